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

test("what is no picture says which are, and that it may be too large", () => {
  for (const start of [new DataView(new ArrayBuffer(3)), new DataView(new ArrayBuffer(24)), pngStart(9, 9)]) {
    expect(loadRefusal("broken.png", start)).toMatch(/cannot be read; PNG, JPEG, WebP and SVG can, .* if it is larger/);
  }
});

test("a picture of the limit is taken", () => {
  expect(sizeRefusal("large.png", 8_192, 1)).toBeNull();
  expect(sizeRefusal("large.png", 1, 8_193)).not.toBeNull();
});
