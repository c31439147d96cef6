import { loadRefusal, PNG_START, sizeRefusal } from "./picture-size";
import { drawnPixels, NoPixels, type Pixels, SIDE } from "./pixels";
import { svgRefusal } from "./svg-check";

/** Bytes of a file: the largest camera pictures are half as large. */
const FILE_LIMIT = 64 * 1024 * 1024;
/** Bytes of an SVG: hundreds of times an icon. */
const SVG_LIMIT = 8 * 1024 * 1024;

/** The picture in a file, as the browser itself decodes it: an image element runs nothing and fetches nothing. */
export async function picturePixels(file: File): Promise<Pixels> {
  const isSvg = file.type === "image/svg+xml" || /\.svg$/i.test(file.name);
  if (file.size > (isSvg ? SVG_LIMIT : FILE_LIMIT)) {
    throw new NoPixels(`${file.name} is too large; ${isSvg ? "an SVG may have 8" : "a picture may have 64"} MiB.`);
  }
  const refusal = isSvg ? svgRefusal(await file.text()) : null;
  if (refusal) throw new NoPixels(`${file.name} ${refusal}`);
  // A picture is told by its bytes, whichever kind it is said to be; a drawing is not.
  const type = isSvg ? "image/svg+xml" : file.type || "image/png";
  const url = await addressOf(new Blob([file], { type }));
  const image = await loaded(url);
  if (!image) throw new NoPixels(loadRefusal(file.name, await startOf(file)));
  const excess = sizeRefusal(file.name, image.naturalWidth, image.naturalHeight);
  if (excess) throw new NoPixels(excess);
  if (!isSvg && !(await isWhole(file))) throw new NoPixels(`${file.name} cannot be decoded; it may be cut short.`);
  const pixels = pixelsOf(image, isSvg, file.name);
  if (isOneColor(pixels)) throw new NoPixels("There is no shape in this picture: all of it has one color.");
  return pixels;
}

/** The file as an address of its own, which needs no other right than to show a picture. */
function addressOf(file: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(new NoPixels("The file cannot be read."));
    reader.readAsDataURL(file);
  });
}

/** Loaded, not yet decoded: its size is known first. Null when the browser cannot. */
function loaded(url: string): Promise<HTMLImageElement | null> {
  return new Promise((resolve) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => resolve(null);
    image.src = url;
  });
}

async function startOf(file: File): Promise<DataView> {
  return new DataView(await file.slice(0, PNG_START).arrayBuffer());
}

function pixelsOf(image: HTMLImageElement, isSvg: boolean, name: string): Pixels {
  const { naturalWidth: width, naturalHeight: height } = image;
  const longer = Math.max(width, height);
  // A drawing is as fine as it is drawn; a picture has the pixels it has.
  const scale = isSvg ? SIDE / Math.max(1, longer) : Math.min(1, SIDE / Math.max(1, longer));
  const [across, down] = [width * scale, height * scale];
  return drawnPixels(across, down, (context) => {
    try {
      context.drawImage(image, 0, 0, Math.max(1, Math.round(across)), Math.max(1, Math.round(down)));
    } catch {
      throw new NoPixels(`${name} cannot be decoded.`);
    }
  });
}

/** An image element shows as much of a picture as there is, and leaves the rest transparent. */
function isWhole(file: File): Promise<boolean> {
  return createImageBitmap(file).then(
    (bitmap) => {
      bitmap.close();
      return true;
    },
    () => false,
  );
}

/** Whether nothing tells a shape from what is around it, at any threshold; what cannot be seen is judged by the engine. */
function isOneColor({ rgba }: Pixels): boolean {
  const words = new Uint32Array(rgba.buffer, rgba.byteOffset, rgba.length / 4);
  return rgba[3] === 255 && words.every((word) => word === words[0]);
}
