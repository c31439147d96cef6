/** Pixels each way: larger than cameras give, and small enough to decode. */
const SIDE_LIMIT = 8192;
const LIMIT_WORDS = "8,192 pixels each way";

/** Why a picture of so many pixels is not taken, in a sentence; null when it is. */
export function sizeRefusal(name: string, width: number, height: number): string | null {
  if (Math.max(width, height) <= SIDE_LIMIT) return null;
  return `${name} has ${width} × ${height} pixels, more than the page can take; scale it down to at most ${LIMIT_WORDS}.`;
}

/** Why a picture that did not load is not taken; `start` is how its file begins: browsers do not tell what is too large from what is broken. */
export function loadRefusal(name: string, start: DataView): string {
  const [width, height] = pngSize(start) ?? [0, 0];
  return (
    sizeRefusal(name, width, height) ??
    `${name} cannot be read; PNG, JPEG, WebP and SVG can, up to ${LIMIT_WORDS}. Scale it down if it is larger.`
  );
}

/** Bytes of a PNG before its pixels: its signature, and the first chunk up to the size (PNG specification, sections 5.2 and 11.2.1). */
export const PNG_START = 24;
const PNG_SIGNATURE = [0x89504e47, 0x0d0a1a0a] as const;

function pngSize(start: DataView): [width: number, height: number] | null {
  if (start.byteLength < PNG_START) return null;
  if (PNG_SIGNATURE.some((word, k) => start.getUint32(4 * k) !== word)) return null;
  return [start.getUint32(16), start.getUint32(20)];
}
