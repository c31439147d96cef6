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
  const kind = kindOf(start);
  if (kind !== "picture") return `${name} is ${kind}; a shape is read from PNG, JPEG, WebP and SVG.`;
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

/** How files begin that are pictures a browser may fail to load, or that somebody takes for one: `?` is any byte. */
const BEGINNINGS: readonly (readonly [start: string, kind: string])[] = [
  ["\x89PNG", "picture"],
  ["\xff\xd8\xff", "picture"],
  ["RIFF????WEBP", "picture"],
  ["<", "picture"],
  ["GIF8", "a GIF"],
  ["BM", "a BMP"],
  ["II*\0", "a TIFF"],
  ["MM\0*", "a TIFF"],
  ["????ftyp", "a video, a HEIC or an AVIF"],
  ["%PDF", "a PDF"],
  ["PK\x03\x04", "an archive or a document"],
];

/** What a file is by its first bytes: `picture` where it is one that is read. */
function kindOf(start: DataView): string {
  const bytes = Array.from({ length: start.byteLength }, (_, k) => start.getUint8(k));
  if (bytes.length === 0) return "empty";
  const begins = (pattern: string) =>
    [...pattern].every((letter, k) => letter === "?" || bytes[k] === letter.charCodeAt(0));
  const known = BEGINNINGS.find(([pattern]) => begins(pattern));
  if (known) return known[1];
  // Bytes above those of ASCII are letters of other languages; below the blank only tabs and ends of lines are text.
  const isText = bytes.every((byte) => byte >= 32 || byte === 9 || byte === 10 || byte === 13);
  return isText ? "text, not a picture" : "no picture";
}
