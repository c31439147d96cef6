import { expect, test } from "vitest";
import { refusalWords } from "./refusal-words";

const problem = (what: string) => ({ code: "too-crowded", what, where: "" });

test("who do not fit are told the distance that the scene has, in its units", () => {
  const what = "70 agents do not fit 0.515 m apart, 12 do; ask for fewer";
  expect(refusalWords(problem(what), 0.5, "m")).toBe(
    "70 agents do not fit 0.50 m apart, with a little to spare, 12 do; ask for fewer.",
  );
  expect(refusalWords(problem(what), 0.3048, "ft")).toContain(" 1.00 ft apart,");
});

test("another refusal is said as it is", () => {
  expect(refusalWords(problem("nothing is dark enough"), 0.5, "m")).toBe("Nothing is dark enough.");
});
