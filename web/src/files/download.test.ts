import { expect, test } from "vitest";
import { fileName } from "./download";

test.each([
  ["Autumn opener", "Autumn-opener.csv"],
  ["", "scene.csv"],
  ["../../etc/passwd", "etc-passwd.csv"],
  ["<b>bold</b>", "b-bold-b.csv"],
  ["행진 1", "행진-1.csv"],
])("a title %j becomes the file name %j", (title, name) => {
  expect(fileName(title, "csv")).toBe(name);
});
