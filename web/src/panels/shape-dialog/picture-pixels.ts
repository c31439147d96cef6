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
  if (refusal) throw new NoPixels(`${file.name} ${refusal}. Only shapes are drawn.`);
  // A picture is told by its bytes, whichever kind it is said to be; a drawing is not.
  const type = isSvg ? "image/svg+xml" : file.type || "image/png";
  const url = await addressOf(new Blob([file], { type }));
  return pixelsOf(await loaded(url, file.name), isSvg, file.name);
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

function pixelsOf(image: HTMLImageElement, isSvg: boolean, name: string): Pixels {
  const { naturalWidth: width, naturalHeight: height } = image;
  const longer = Math.max(width, height);
  if (longer > SIDE_LIMIT) {
    throw new NoPixels(`${name} has ${width} × ${height} pixels; a picture may have 8,192 each way.`);
  }
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
