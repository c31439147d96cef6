import fc from "fast-check";
import { expect, test } from "vitest";
import { createDocument } from "../create-store";
import { emptyScene } from "../defaults";
import { Formation, type Point } from "../formation";
import { groupDepth, groupPaths, groupSet } from "../groups";
import { type AdjacencySpec, type Group, mainTrack, type Scene } from "../scene";
import type { Command } from "../store";
import * as absence from "./absence";
import * as agents from "./agents";
import * as groups from "./groups";
import * as keyframes from "./keyframes";
import * as retime from "./retime";
import * as scenes from "./scene";
import * as ties from "./ties";
import * as transform from "./transform";
import * as transitions from "./transitions";
import * as travel from "./travel";

/** What is wrong with a scene, by the rules of the format; empty for a valid one. */
function problems(scene: Scene): string[] {
  const track = mainTrack(scene);
  const count = track.agents.length;
  const found: string[] = [];
  const claim = (holds: boolean, otherwise: string) => {
    if (!holds) found.push(otherwise);
  };
  claim(track.keyframes.length >= 1, "no keyframe");
  claim(track.segments.length === track.keyframes.length - 1, "segments do not fit the keyframes");
  for (const [i, keyframe] of track.keyframes.entries()) {
    const next = track.keyframes[i + 1];
    claim(keyframe.positions.agentCount === count, `keyframe ${i} has ${keyframe.positions.agentCount} of ${count}`);
    claim(
      keyframe.positions.xy.every((value) => Math.abs(value) <= 1e5),
      `keyframe ${i} reaches too far`,
    );
    claim(keyframe.time >= 0 && keyframe.hold >= 0, `keyframe ${i} is at ${keyframe.time} for ${keyframe.hold}`);
    claim(!next || keyframe.time + keyframe.hold < next.time, `keyframe ${i} runs into the next`);
    claim(
      keyframe.absent.every((agent, k) => agent < count && (k === 0 || agent > (keyframe.absent[k - 1] ?? -1))),
      `keyframe ${i} misses ${keyframe.absent} of ${count}`,
    );
    if (keyframe.adjacency) found.push(...adjacencyProblems(keyframe.adjacency, count));
  }
  for (const [i, { path }] of track.segments.entries()) {
    claim(path === null || new Set(path.map(String)).size > 1, `the path of segment ${i} has no length`);
    claim(path?.every((point) => point.every((value) => Math.abs(value) <= 1e5)) ?? true, `path ${i} reaches too far`);
  }
  for (const [i, { radius, maxSpeed }] of track.agents.entries()) {
    claim(radius >= 0 && radius <= 1e5, `agent ${i} has a radius of ${radius}`);
    claim(maxSpeed === null || (maxSpeed >= 0.01 && maxSpeed <= 1000), `agent ${i} has a top speed of ${maxSpeed}`);
  }
  claim((track.keyframes.at(-1)?.time ?? 0) <= 3600, "longer than an hour");
  claim(groupDepth(scene.groups) <= 8 && groupPaths(scene.groups).length <= 1000, "too many groups");
  found.push(...adjacencyProblems(scene.adjacency, count), ...groupProblems(scene.groups, count));
  return found;
}

function adjacencyProblems(adjacency: AdjacencySpec, count: number): string[] {
  const pairs = [...adjacency.ties, ...adjacency.cuts];
  const isOnce = (list: readonly (readonly [number, number, ...number[]])[]) =>
    new Set(list.map(([a, b]) => `${Math.min(a, b)} ${Math.max(a, b)}`)).size === list.length;
  return [
    ...pairs.flatMap(([a, b]) => (a !== b && a >= 0 && b >= 0 && a < count && b < count ? [] : [`tie ${a} ${b}`])),
    ...adjacency.ties.flatMap(([, , factor]) => (factor >= 1e-6 && factor <= 1e6 ? [] : [`factor ${factor}`])),
    ...(isOnce(adjacency.ties) && isOnce(adjacency.cuts) ? [] : ["a pair is listed twice"]),
  ];
}

function groupProblems(list: readonly Group[], count: number): string[] {
  return list.flatMap((group, i) => {
    const own = [...group.members, ...group.children.flatMap((child) => [...groupSet(child)])];
    const others = list.slice(i + 1).flatMap((other) => [...groupSet(other)]);
    return [
      ...(new Set(own).size === own.length ? [] : [`group ${group.name} holds an agent twice`]),
      ...(own.every((agent) => agent >= 0 && agent < count) ? [] : [`group ${group.name} holds nobody`]),
      ...(own.some((agent) => others.includes(agent)) ? [`group ${group.name} shares an agent`] : []),
      ...(own.length > 0 ? [] : [`group ${group.name} is empty`]),
      ...groupProblems(group.children, count),
    ];
  });
}

/** Ten agents on a line in three groups, one within another, and three keyframes: most commands have something to do. */
const START: Scene = [
  agents.addAgents(Array.from({ length: 10 }, (_, i): Point => [i, 0])),
  keyframes.duplicateKeyframe(0),
  keyframes.duplicateKeyframe(1),
  groups.makeGroup(new Set([0, 1, 2, 3])),
  groups.makeGroup(new Set([1, 2])),
  groups.makeGroup(new Set([5, 6])),
].reduce((scene, next) => next.apply(scene), emptyScene());

const index = fc.integer({ min: 0, max: 9 });
const at = fc.integer({ min: 0, max: 4 });
const seconds = fc.oneof(fc.double({ min: -5, max: 60, noNaN: true }), fc.constantFrom(0, 4, 3599, 3600, 5000));
const place: fc.Arbitrary<Point> = fc.tuple(
  fc.oneof(fc.double({ min: -50, max: 50, noNaN: true }), fc.constantFrom(-2e5, 2e5, 0)),
  fc.double({ min: -50, max: 50, noNaN: true }),
);
const some = fc.uniqueArray(index, { minLength: 0, maxLength: 6 }).map((list) => new Set(list));
const path = fc.constantFrom([0], [1], [2], [0, 0], [1, 0], [0, 1], [0, 0, 0]);
const scope: fc.Arbitrary<ties.TieScope> = fc.oneof(
  fc.constant(ties.WHOLE_SCENE),
  at.map((keyframe) => ({ kind: "keyframe", index: keyframe }) as const),
);

/** Any command with any arguments, sensible or not. */
const command: fc.Arbitrary<Command> = fc.oneof(
  { weight: 3, arbitrary: fc.array(place, { maxLength: 5 }).map((places) => agents.addAgents(places)) },
  fc.tuple(at, some, place).map((a) => agents.moveAgents(...a)),
  fc.tuple(at, index, place).map((a) => agents.setPlace(...a)),
  fc
    .tuple(index, fc.array(place, { minLength: 4, maxLength: 4 }))
    .map(([k, slots]) => agents.placeAgents(k, [0, 1, 2, 3], slots, [2, 0, 3, 1])),
  fc.tuple(some, place).map((a) => agents.duplicateAgents(...a)),
  some.map(agents.deleteAgents),
  fc.tuple(index, fc.string({ maxLength: 100 })).map((a) => agents.renameAgent(...a)),
  some.map((set) => agents.colorAgents(set, "#123456")),
  fc.tuple(some, fc.constantFrom(-1, 0, 0.4, 1e9, Number.NaN)).map((a) => agents.setRadius(...a)),
  fc.tuple(some, fc.constantFrom(null, 0, 2.5, 1e9)).map((a) => agents.setTopSpeed(...a)),
  fc.tuple(at, some, place, fc.double({ min: -7, max: 7, noNaN: true })).map((a) => transform.rotateAgents(...a)),
  fc.tuple(at, some, place, place).map((a) => transform.scaleAgents(...a)),
  fc.tuple(at, some, fc.constantFrom("horizontal", "vertical")).map((a) => transform.flipAgents(...a)),
  fc
    .tuple(index, some, fc.constantFrom("left", "center", "right", "top", "middle", "bottom"))
    .map((a) => transform.alignAgents(...a)),
  fc.tuple(at, some, fc.constantFrom("x", "y")).map((a) => transform.distributeAgents(...a)),
  fc.tuple(scope, index, index, fc.constantFrom(0, 0.1, 10, 1e9)).map((a) => ties.setTieFactor(...a)),
  fc.tuple(scope, index, index).map((a) => ties.addTie(...a)),
  fc.tuple(scope, index, index).map((a) => ties.cutTie(...a)),
  fc.tuple(scope, index, index).map((a) => ties.restoreTie(...a)),
  fc.tuple(scope, index, index).map((a) => ties.resetTie(...a)),
  at.map(ties.dropOwnTies),
  { weight: 2, arbitrary: some.map((set) => groups.makeGroup(set)) },
  fc.tuple(path, fc.string()).map((a) => groups.renameGroup(...a)),
  { weight: 2, arbitrary: fc.tuple(path, fc.oneof(path, fc.constant([]))).map((a) => groups.nestGroup(...a)) },
  path.map(groups.dissolveGroup),
  fc.tuple(path, some).map((a) => groups.addToGroup(...a)),
  fc.tuple(path, some).map((a) => groups.removeFromGroup(...a)),
  fc.tuple(path, fc.constantFrom(null, 0, 10, 1e7)).map((a) => groups.setGroupTieWeight(...a)),
  { weight: 2, arbitrary: seconds.map(addAsSeen) },
  at.map(keyframes.duplicateKeyframe),
  fc.tuple(at, some, fc.boolean()).map((a) => absence.setAbsent(...a)),
  at.map(keyframes.deleteKeyframe),
  fc.tuple(at, fc.string()).map((a) => keyframes.renameKeyframe(...a)),
  fc.tuple(at, at).map((a) => keyframes.reorderKeyframe(...a)),
  fc.tuple(at, seconds).map((a) => retime.retimeKeyframe(...a)),
  fc.tuple(at, seconds).map((a) => retime.rippleKeyframe(...a)),
  fc.tuple(at, seconds).map((a) => retime.setHold(...a)),
  at.map((segment) => transitions.setTransition(segment, { method: "polar" })),
  fc.constant(transitions.setAllTransitions({ sharing: 0.25 })),
  fc
    .tuple(at, fc.option(fc.array(place, { maxLength: 5 })))
    .map(([segment, points]) => travel.setPath(segment, points, "Draw path")),
  fc.tuple(at, fc.double({ min: -7, max: 7, noNaN: true })).map((a) => travel.turnFormation(...a)),
  fc.string({ maxLength: 300 }).map(scenes.setTitle),
  fc.constantFrom(0, 1, 60, 120, 500).map(scenes.setFrameRate),
  fc.constantFrom(-1, 0, 0.6, Number.NaN).map(scenes.setMinimumDistance),
);

/** A keyframe that captures what stands at the first. */
function addAsSeen(time: number): Command {
  return {
    label: "Add keyframe",
    apply: (scene) =>
      keyframes.addKeyframe(time, mainTrack(scene).keyframes[0]?.positions ?? Formation.from([])).apply(scene),
  };
}

test("no sequence of commands makes an invalid scene", () => {
  fc.assert(
    fc.property(fc.array(command, { maxLength: 40 }), (commands) => {
      let scene = START;
      for (const next of commands) {
        scene = next.apply(scene);
        expect(problems(scene)).toEqual([]);
      }
    }),
    { numRuns: 400 },
  );
});

test("any sequence of commands undone completely gives the identical scene, and redone completely what it made", () => {
  fc.assert(
    fc.property(fc.array(command, { maxLength: 30 }), (commands) => {
      const start = START;
      const document = createDocument(start);
      for (const next of commands) document.perform(next);
      const end = document.scene.value;
      while (document.undoLabel.value !== null) document.undo();
      expect(document.scene.value).toBe(start);
      while (document.redoLabel.value !== null) document.redo();
      expect(document.scene.value).toBe(end);
    }),
    { numRuns: 200 },
  );
});

test("a command applied twice to one scene gives equal scenes and leaves the scene alone", () => {
  fc.assert(
    fc.property(fc.array(command, { maxLength: 15 }), command, (commands, last) => {
      const scene = commands.reduce((made, next) => next.apply(made), START);
      const before = structuredClone(plain(scene));
      expect(plain(last.apply(scene))).toEqual(plain(last.apply(scene)));
      expect(plain(scene)).toEqual(before);
    }),
    { numRuns: 200 },
  );
});

function plain(scene: Scene): unknown {
  return {
    ...scene,
    tracks: scene.tracks.map((t) => ({
      ...t,
      keyframes: t.keyframes.map((k) => ({ ...k, positions: [...k.positions.xy] })),
    })),
  };
}

test("agents who are moved together keep their distances, at the edge of what a scene holds too", () => {
  const places: Point[] = [
    [0, 0],
    [3, 1],
    [-2, 5],
  ];
  const far = fc.double({ min: -3e5, max: 3e5, noNaN: true });
  fc.assert(
    fc.property(far, far, (x, y) => {
      const scene = agents.addAgents(places).apply(emptyScene());
      const moved = mainTrack(agents.moveAgents(0, new Set([0, 1, 2]), [x, y]).apply(scene)).keyframes[0]?.positions;
      for (const [agent, [px, py]] of places.entries()) {
        // Coordinates up to 1e5 are sums of two: each is off by no more than half of its last digit, 7.3e-12.
        expect(moved?.x(agent)).toBeCloseTo((moved?.x(0) ?? Number.NaN) + px, 10);
        expect(moved?.y(agent)).toBeCloseTo((moved?.y(0) ?? Number.NaN) + py, 10);
      }
    }),
  );
});
