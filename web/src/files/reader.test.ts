import { expect, test } from "vitest";
import { sentence } from "./reader";

test("a problem reads as one sentence, whatever the engine's words begin and end with", () => {
  expect(sentence({ code: "", what: "the end of the link is missing", where: "" })).toBe(
    "The end of the link is missing.",
  );
  expect(sentence({ code: "", what: "Two agents have one name.", where: "row 4" })).toBe(
    "Two agents have one name (row 4).",
  );
});
