import { describe, expect, it } from "vitest";
import { shortName } from "./short-name";

describe("a name in a disc", () => {
  it.each([
    ["B1", "B1"],
    ["Anna", "Anna"],
    ["Trumpet 12", "T12"],
    ["Trumpet12", "T12"],
    ["Second Trumpet 3", "ST3"],
    ["Anna Maria", "AM"],
    ["Katharina", "Kat"],
    ["123456", "123"],
    ["Müllerin", "Mül"],
  ])("%s is cut to %s", (name, short) => {
    expect(shortName(name)).toBe(short);
  });

  it("nothing longer than four characters is left, and nothing is cut to nothing", () => {
    for (const name of ["a-b-c-d-e-f-g", "x 99999", "-----", "1 2 3 4 5", "😀😀😀😀😀😀", "Drum 1234"]) {
      const short = shortName(name);
      expect([...short].length).toBeLessThanOrEqual(4);
      expect(short).not.toBe("");
    }
  });
});
