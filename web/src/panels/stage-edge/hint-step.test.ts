import { expect, test } from "vitest";
import { addAgents, moveAgents } from "../../document/commands/agents";
import { addKeyframe } from "../../document/commands/keyframes";
import { emptyScene } from "../../document/defaults";
import { mainTrack } from "../../document/scene";
import { hintStep } from "./hint-step";

test("first agents, then a second formation, then the show", () => {
  const empty = emptyScene();
  expect(hintStep(empty)).toBe("draw");
  const drawn = addAgents([
    [0, 0],
    [1, 0],
  ]).apply(empty);
  expect(hintStep(drawn)).toBe("next");
  const [first] = mainTrack(drawn).keyframes;
  if (!first) throw new Error("a scene has a keyframe");
  const standing = addKeyframe(4, first.positions).apply(drawn);
  expect(hintStep(standing)).toBe("next");
  expect(hintStep(moveAgents(1, new Set([0]), [0, 5]).apply(standing))).toBe("play");
});
