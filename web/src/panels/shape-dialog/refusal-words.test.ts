import { expect, test } from "vitest";
import { refusalWords } from "./refusal-words";

const crowded = (largest: number) => ({
  code: "too-crowded",
  what: "0.515 m",
  where: "",
  tooCrowded: { count: 1700, largest },
});

test("who do not fit are told the distance that the scene has, in its units", () => {
  expect(refusalWords(crowded(12), 0.5, "m")).toBe(
    "1,700 agents do not fit 0.50 m apart, with a little to spare; 12 do. Ask for fewer, a larger shape or a smaller minimum distance.",
  );
  expect(refusalWords(crowded(1), 0.3048, "ft")).toContain(" 1.00 ft apart, with a little to spare; 1 does.");
});

test("another refusal is said as it is", () => {
  expect(refusalWords({ code: "blank-picture", what: "nothing is dark enough", where: "" }, 0.5, "m")).toBe(
    "Nothing is dark enough.",
  );
});
