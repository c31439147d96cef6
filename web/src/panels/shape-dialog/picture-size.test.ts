import { expect, test } from "vitest";
import { loadRefusal, sizeRefusal } from "./picture-size";

function pngStart(width: number, height: number): DataView {
  const start = new DataView(new ArrayBuffer(24));
  [0x89504e47, 0x0d0a1a0a, 13, 0x49484452, width, height].forEach((word, k) => {
    start.setUint32(4 * k, word);
  });
  return start;
}

test("a picture too large to load says how large it is, how large it may be, and what to do", () => {
  const says = loadRefusal("huge.png", pngStart(30_000, 30_000));
  expect(says).toContain("30000 × 30000 pixels");
  expect(says).toContain("8,192 pixels each way");
  expect(says).toContain("scale it down");
});

test("a picture that does not load says what can, and that it may be too large", () => {
  expect(loadRefusal("broken.png", pngStart(9, 9))).toMatch(
    /cannot be read; PNG, JPEG, WebP and SVG can, .* if it is larger/,
  );
});

test.each([
  ["Dear all,", "text, not a picture"],
  ["%PDF-1.7", "a PDF"],
  ["GIF89a", "a GIF"],
  ["\0\0\0\x20ftypheic", "a video, a HEIC or an AVIF"],
  ["\0\0\0", "no picture"],
  ["", "empty"],
])("a file of %j is told to be %s, not to be scaled down", (text, kind) => {
  const start = new DataView(Uint8Array.from(text, (letter) => letter.charCodeAt(0)).buffer);
  expect(loadRefusal("party.png", start)).toBe(`party.png is ${kind}; a shape is read from PNG, JPEG, WebP and SVG.`);
});

test("a picture of the limit is taken", () => {
  expect(sizeRefusal("large.png", 8_192, 1)).toBeNull();
  expect(sizeRefusal("large.png", 1, 8_193)).not.toBeNull();
});
