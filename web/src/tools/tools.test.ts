import fc from "fast-check";
import { expect, test } from "vitest";
import type { Point } from "../document/formation";
import { createBench } from "./test-bench";
import type { ToolName } from "./toolbox";

const SIX: readonly Point[] = [
  [0, 0],
  [2, 0],
  [4, 0],
  [0, 3],
  [2, 3],
  [4, 3],
];

const place: fc.Arbitrary<Point> = fc
  .tuple(fc.integer({ min: -4, max: 12 }), fc.integer({ min: -4, max: 10 }))
  .map(([x, y]) => [x / 2, y / 2]);
const held = fc.record({ shift: fc.boolean(), ctrl: fc.boolean(), alt: fc.boolean() });
const happening = fc.oneof(
  { weight: 3, arbitrary: fc.record({ kind: fc.constant("press" as const), at: place, held }) },
  { weight: 6, arbitrary: fc.record({ kind: fc.constant("move" as const), at: place, held }) },
  { weight: 3, arbitrary: fc.record({ kind: fc.constant("release" as const), at: place, held }) },
  fc.record({ kind: fc.constant("cancel" as const) }),
  fc.record({ kind: fc.constant("undo" as const) }),
  fc.record({ kind: fc.constant("seek" as const), time: fc.constantFrom(0, 1, 3, 4) }),
  fc.record({
    kind: fc.constant("tool" as const),
    tool: fc.constantFrom<ToolName>("select", "draw", "shape", "tie", "group", "pan"),
  }),
);

test("whatever a hand does, in whatever order, no gesture stays open and all of it can be undone", async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(happening, { maxLength: 40 }), async (happenings) => {
      const bench = createBench(SIX, SIX);
      bench.toolbox.spacing.value = { by: "count", count: 3 };
      const start = bench.document.scene.value;
      for (const event of happenings) {
        if (event.kind === "tool") bench.toolbox.active.value = event.tool;
        else if (event.kind === "undo") bench.document.undo();
        else if (event.kind === "seek") bench.playback.seek(event.time);
        else if (event.kind === "cancel") bench.toolbox.cancel();
        else bench[event.kind](event.at, event.held);
      }
      bench.toolbox.cancel();
      await bench.settled();
      expect(bench.document.isDragging.value).toBe(false);
      expect(bench.toolbox.overlay.value.kind).toBe("none");
      while (bench.document.undoLabel.value !== null) bench.document.undo();
      expect(bench.document.scene.value).toBe(start);
    }),
    { numRuns: 300 },
  );
});
