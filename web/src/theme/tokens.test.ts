import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

const css = readFileSync(new URL("./tokens.css", import.meta.url), "utf8");

/** Declarations of the block that follows `opening`, in order. */
function declarationsAfter(opening: string): string[] {
  const start = css.indexOf(opening);
  if (start < 0) throw new Error(`tokens.css has no block ${opening}`);
  const body = css.slice(css.indexOf("{", start + opening.length - 1) + 1);
  return body
    .slice(0, body.indexOf("}"))
    .replace(/\/\*[\s\S]*?\*\//g, "")
    .split(";")
    .map((declaration) => declaration.replace(/\s+/g, " ").trim())
    .filter((declaration) => declaration !== "");
}

function names(declarations: readonly string[]): string[] {
  return declarations.map((declaration) => declaration.slice(0, declaration.indexOf(":")));
}

describe("tokens", () => {
  const light = declarationsAfter(":root {");
  const chosen = declarationsAfter(':root[data-theme="dark"] {');
  const system = declarationsAfter(':root:not([data-theme="light"]) {');

  it("dark looks the same whether chosen or followed from the system", () => {
    expect(chosen.length).toBeGreaterThan(40);
    expect(system).toEqual(chosen);
  });

  it("dark overrides only what light defines", () => {
    const known = new Set(names(light));
    expect(names(chosen).filter((name) => !known.has(name))).toEqual([]);
  });

  it("every color has a value in both themes", () => {
    const overridden = new Set(names(chosen));
    const colors = light.filter((declaration) => /#|rgb\(|^--tie/.test(declaration));
    expect(names(colors).filter((name) => !overridden.has(name))).toEqual([]);
  });
});
