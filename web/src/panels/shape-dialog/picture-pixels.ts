import { drawnPixels, NoPixels, type Pixels, SIDE } from "./pixels";
import { svgRefusal } from "./svg-check";

/** Bytes of a file: the largest camera pictures are half as large. */
const FILE_LIMIT = 64 * 1024 * 1024;
/** Bytes of an SVG: hundreds of times an icon. */
const SVG_LIMIT = 8 * 1024 * 1024;
/** Pixels each way: larger than cameras give, and small enough to decode. */
const SIDE_LIMIT = 8192;

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
  const image = await loaded(url, file.name);
  checkSize(image, file.name);
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

/** Loaded, not yet decoded: its size is known first. */
function loaded(url: string, name: string): Promise<HTMLImageElement> {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => reject(new NoPixels(`${name} cannot be read; PNG, JPEG, WebP and SVG can.`));
    image.src = url;
  });
}

function checkSize({ naturalWidth: width, naturalHeight: height }: HTMLImageElement, name: string): void {
  if (Math.max(width, height) > SIDE_LIMIT) {
    throw new NoPixels(`${name} has ${width} × ${height} pixels; a picture may have 8,192 each way.`);
  }
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
