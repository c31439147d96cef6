import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { addAgents } from "../../document/commands/agents";
import { emptyScene } from "../../document/defaults";
import type { Group, Scene } from "../../document/scene";
import { movedCell } from "./cell-moves";
import { drawnRows, rowAt, rowOffsets, scrollTo } from "./row-window";
import { type TableRow, tableRows } from "./table-rows";

function group(name: string, members: number[], children: Group[] = []): Group {
  return { name, color: "", members, tieWeight: null, children };
}

function sceneOf(agentCount: number, groups: Group[]): Scene {
  const places = Array.from({ length: agentCount }, (_, agent) => [agent, 0] as const);
  return { ...addAgents(places).apply(emptyScene()), groups };
}

function outline(rows: readonly TableRow[]): string[] {
  return rows.map((row) => (row.kind === "heading" ? `${row.label} ${row.agentCount}` : String(row.agent)));
}

describe("the table's rows", () => {
  test("a scene without groups has no headings", () => {
    expect(outline(tableRows(sceneOf(3, [])))).toEqual(["0", "1", "2"]);
  });

  test("a group is headed by its name and counts everybody within, its own agents before its groups", () => {
    const rows = tableRows(sceneOf(5, [group("Band", [4], [group("Brass", [2, 0])])]));
    expect(outline(rows)).toEqual(["Band 3", "4", "Brass 2", "0", "2", "No group 2", "1", "3"]);
  });

  test("every agent has exactly one row, however the groups lie", () => {
    const placement = fc.array(fc.integer({ min: -1, max: 3 }), { maxLength: 40 });
    fc.assert(
      fc.property(placement, (homes) => {
        const members = (home: number) => homes.flatMap((other, agent) => (other === home ? [agent] : []));
        const groups = [
          group("A", members(0), [group("B", members(1))]),
          group("C", members(2)),
          group("D", members(3)),
        ];
        const rows = tableRows(sceneOf(homes.length, groups));
        const agents = rows.flatMap((row) => (row.kind === "agent" ? [row.agent] : []));
        expect(agents.sort((a, b) => a - b)).toEqual(homes.map((_, agent) => agent));
      }),
    );
  });
});

const heights = { heading: 32, agent: 27 };

describe("the rows in sight", () => {
  const rows = tableRows(
    sceneOf(5000, [
      group(
        "Odd",
        Array.from({ length: 2500 }, (_, k) => 2 * k + 1),
      ),
    ]),
  );
  const offsets = rowOffsets(rows, heights);
  const total = offsets[rows.length] ?? 0;

  test("rows and gaps together are as high as everybody, wherever one scrolls and whatever has the focus", () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 140_000 }), fc.option(fc.nat(5001)), (top, kept) => {
        const drawn = drawnRows(offsets, top, 600, kept);
        const sum = drawn.reduce((height, item) => {
          if (item.kind === "gap") return height + item.height;
          return height + (offsets[item.index + 1] ?? 0) - (offsets[item.index] ?? 0);
        }, 0);
        expect(sum).toBe(total);
        const indices = drawn.flatMap((item) => (item.kind === "row" ? [item.index] : []));
        if (kept !== null) expect(indices).toContain(kept);
        expect(indices.length).toBeLessThan(60);
      }),
    );
  });

  test("nothing in sight is left out", () => {
    const shown = new Set(
      drawnRows(offsets, 40_000, 600, null).flatMap((item) => (item.kind === "row" ? [item.index] : [])),
    );
    for (let y = 40_000; y <= 40_600; y += 10) expect(shown.has(rowAt(offsets, y))).toBe(true);
  });

  test("scrolling to a row moves no further than needed", () => {
    expect(scrollTo(offsets, 3, 0, 600)).toBe(0);
    expect(scrollTo(offsets, 0, 500, 600)).toBe(0);
    expect(scrollTo(offsets, 100, 0, 600)).toBe((offsets[101] ?? 0) - 600);
  });
});

describe("moving among the cells", () => {
  const shape = { rowCount: 10, columnCount: 4, page: 5 };

  test("arrows stop at the edges", () => {
    expect(movedCell({ row: 0, column: 0 }, "ArrowUp", false, shape)).toEqual({ row: 0, column: 0 });
    expect(movedCell({ row: 9, column: 3 }, "ArrowRight", false, shape)).toEqual({ row: 9, column: 3 });
  });

  test("control and End lead to the last cell of all", () => {
    expect(movedCell({ row: 2, column: 1 }, "End", true, shape)).toEqual({ row: 9, column: 3 });
  });

  test("a letter does not move", () => {
    expect(movedCell({ row: 2, column: 1 }, "a", false, shape)).toBeNull();
  });
});
