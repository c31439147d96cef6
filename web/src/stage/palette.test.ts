import { readFileSync } from "node:fs";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { AGENT_COLORS } from "../document/palette";
import { contrast, inkOn, withContrast } from "./contrast";
import { readPalette } from "./palette";

const css = readFileSync(new URL("../theme/tokens.css", import.meta.url), "utf8");
const darkStart = css.indexOf(':root[data-theme="dark"]');

function reader(theme: "light" | "dark"): (name: string) => string {
  const dark = css.slice(darkStart, css.indexOf("@media", darkStart));
  return (name) => {
    const pattern = new RegExp(`${name}:\\s*([^;]+);`);
    return (theme === "dark" ? pattern.exec(dark)?.[1] : undefined) ?? pattern.exec(css)?.[1] ?? "";
  };
}

const hexes = fc.integer({ min: 0, max: 0xffffff }).map((value) => `#${value.toString(16).padStart(6, "0")}`);

describe("palette", () => {
  const light = readPalette(reader("light"));
  const dark = readPalette(reader("dark"));

  it("a palette color is shown as itself in the light and as its partner in the dark", () => {
    expect(AGENT_COLORS.map((color) => light.shown(color))).toEqual(AGENT_COLORS);
    expect(dark.shown(AGENT_COLORS[3] ?? "")).toBe("#36e6c4");
    expect(dark.shown("#1D2A3A")).toBe("#e3f2f4");
  });

  it("every color has 3:1 on the sheet in both themes", () => {
    fc.assert(
      fc.property(hexes, (color) => {
        for (const palette of [light, dark]) {
          expect(contrast(palette.shown(color), palette.sheet)).toBeGreaterThanOrEqual(3);
        }
      }),
    );
  });

  it("a color that already stands out is left alone", () => {
    expect(light.shown("#7a1f1f")).toBe("#7a1f1f");
    expect(dark.shown("#ffd0d0")).toBe("#ffd0d0");
  });

  it("a pale blue darkens into a blue, not a gray", () => {
    const shown = withContrast("#b8d4ff", "#fbfbf8", 3);
    const [r, g, b] = [1, 3, 5].map((at) => Number.parseInt(shown.slice(at, at + 2), 16));
    expect(b ?? 0).toBeGreaterThan((g ?? 0) + 20);
    expect(g ?? 0).toBeGreaterThan(r ?? 0);
  });

  it("reads its numbers", () => {
    expect(light.trailAlpha).toBe(0.62);
    expect(dark.hullAlpha).toBe(0.13);
    expect(dark.isDark).toBe(true);
  });

  it("a name on a disc reads at 4:1 or better on any color", () => {
    fc.assert(
      fc.property(hexes, (color) => {
        expect(contrast(inkOn(color), color)).toBeGreaterThanOrEqual(4);
      }),
    );
  });
});
