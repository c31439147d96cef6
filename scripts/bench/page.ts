import airshow from "../../public/examples/airshow.eigenform.json?raw";
import band from "../../public/examples/band.eigenform.json?raw";
import offsideTrap from "../../public/examples/offside-trap.eigenform.json?raw";
import thousand from "../../public/examples/thousand.eigenform.json?raw";
import { moveAgents } from "../../web/src/document/commands/agents";
import { type MethodName, mainTrack, type Scene } from "../../web/src/document/scene";
import { Ledger, sceneFrom } from "../../web/src/engine/ledger";
import init, { Engine } from "../../web/src/engine/pkg/workshop.js";
import wasmUrl from "../../web/src/engine/pkg/workshop_bg.wasm?url";
import { crossingBlocks, lasting, strewn, strewnShow } from "./scenes";

/** Times the engine in the page itself, without the worker's messages; milliseconds, one entry a run. */

await init({ module_or_path: wasmUrl });

function take(engine: Engine, ledger: Ledger, scene: Scene): void {
  const message = ledger.message(scene);
  for (const [id, xy, heights] of message.added) engine.put_formation(id, xy, heights);
  engine.set_scene(message.rest ?? undefined, Uint32Array.from(message.formations));
}

/** Until every motion can be played; the numbers of none are waited for. */
function moveAll(engine: Engine, scene: Scene): void {
  for (const [segment] of mainTrack(scene).segments.entries()) {
    do engine.step(segment);
    while (!engine.is_moved());
  }
}

/** Until every motion is measured, too. */
function performAll(engine: Engine, scene: Scene): void {
  moveAll(engine, scene);
  for (const [segment] of mainTrack(scene).segments.entries()) while (engine.step(segment) < 1);
}

function timed(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}

/** A first run in the compiler's slow tier is not counted. */
function runs(count: number, work: () => number): number[] {
  work();
  return Array.from({ length: count }, work);
}

function opened(text: string): Scene {
  return sceneFrom((JSON.parse(new Engine().open(text) ?? "null") as { scene: string }).scene);
}

/** The middle keyframe of three is strewn anew, until both motions beside it are there. */
function movedAgent(scene: Scene, count: number, perform = moveAll): number[] {
  let seed = 100;
  const engine = new Engine();
  const ledger = new Ledger();
  take(engine, ledger, scene);
  performAll(engine, scene);
  return runs(count, () => {
    seed += 1;
    const track = mainTrack(scene);
    const keyframes = track.keyframes.map((keyframe, k) =>
      k === 1 ? { ...keyframe, positions: strewn(track.agents.length, seed) } : keyframe,
    );
    const moved = { ...scene, tracks: [{ ...track, keyframes }] };
    return timed(() => {
      take(engine, ledger, moved);
      perform(engine, moved);
    });
  });
}

/** Figure 11 in three levels: a group of 36 is dragged at the second keyframe, until the motions around it are there. */
function movedGroup(count: number, perform = moveAll): number[] {
  const engine = new Engine();
  const ledger = new Ledger();
  const example = opened(thousand);
  const track = mainTrack(example);
  const way = { method: "spectral", hierarchy: true, timing: "smooth", avoidance: false, nodes: [] } as const;
  const segments = track.segments.map((segment) => ({ ...segment, ...way }));
  const scene = { ...example, tracks: [{ ...track, segments }] };
  take(engine, ledger, scene);
  performAll(engine, scene);
  const group = new Set(Array.from({ length: 36 }, (_, agent) => 36 + agent));
  let moved = 0;
  return runs(count, () => {
    moved += 0.37;
    const dragged = moveAgents(1, group, [moved, -moved / 2]).apply(scene);
    return timed(() => {
      take(engine, ledger, dragged);
      perform(engine, dragged);
    });
  });
}

function whole(scene: Scene, count: number): number[] {
  return runs(count, () => {
    const engine = new Engine();
    take(engine, new Ledger(), scene);
    const time = timed(() => performAll(engine, scene));
    engine.free();
    return time;
  });
}

/** Of ties that are known. */
function eigenbasis(agentCount: number, count: number): number[] {
  const scene = strewnShow(agentCount, 2, 10, "spectral");
  return runs(count, () => {
    const engine = new Engine();
    take(engine, new Ledger(), scene);
    engine.tie_factors(0);
    const time = timed(() => engine.modes(0, 1));
    engine.free();
    return time;
  });
}

function assignment(agentCount: number, count: number): number[] {
  const engine = new Engine();
  const [source, target] = [strewn(agentCount, 1).xy, strewn(agentCount, 2).xy];
  return runs(count, () => timed(() => engine.assign(source, target)));
}

const show = (agentCount: number, method: MethodName = "spectral"): Scene => strewnShow(agentCount, 3, 10, method);
const smooth = (scene: Scene): Scene => ({ ...scene, join: "smooth" });

/** Groups of a strewn crowd that is strewn anew: nobody keeps together, the longest search there is. */
function affinity(agentCount: number, count: number): number[] {
  const scene = strewnShow(agentCount, 2, 10, "linear");
  const everybody = Uint32Array.from({ length: agentCount }, (_, agent) => agent);
  return runs(count, () => {
    const engine = new Engine();
    take(engine, new Ledger(), scene);
    const time = timed(() => {
      engine.begin_affinity(0, everybody, "euclidean", 1);
      while (engine.step_errand() < 1);
    });
    engine.free();
    return time;
  });
}

const rows: Record<string, () => number[]> = {
  "eigenbasis 300": () => eigenbasis(300, 9),
  "eigenbasis 1260": () => eigenbasis(1260, 5),
  "assignment 1260": () => assignment(1260, 7),
  "assignment 1936": () => assignment(1936, 5),
  "affinity of 1260": () => affinity(1260, 3),
  "moved agent 60": () => movedAgent(show(60), 15),
  "moved agent 60, measured": () => movedAgent(show(60), 15, performAll),
  "moved agent 60, joined smoothly": () => movedAgent(smooth(show(60)), 15),
  "moved agent 300": () => movedAgent(show(300), 9),
  "moved agent 300, measured": () => movedAgent(show(300), 9, performAll),
  "moved agent 300, joined smoothly": () => movedAgent(smooth(show(300)), 9),
  "moved agent 25 auto": () => movedAgent(show(25, "auto"), 15),
  "moved agent 25 auto, joined smoothly": () => movedAgent(smooth(show(25, "auto")), 15),
  "moved group in 1260": () => movedGroup(9),
  "moved group in 1260, measured": () => movedGroup(9, performAll),
  "one transition of 1260": () => whole(strewnShow(1260, 2, 10, "spectral"), 3),
  "show of 200 x 23 auto": () => whole(strewnShow(200, 23, 10, "auto"), 3),
  "table 1: band 25 x 1211": () => whole(lasting(opened(band), 1211), 5),
  "table 1: soccer 14 x 238": () => whole(lasting(opened(offsideTrap), 238), 5),
  "table 1: figures 1260 x 991": () => whole(lasting(opened(thousand), 991), 3),
  "table 1: airshow 10 x 540": () => whole(lasting(opened(airshow), 540), 5),
  "smooth join of 300 x 6": () => whole(smooth(strewnShow(300, 6, 4, "spectral")), 3),
  "blocks of 1936 kept apart": () => whole(crossingBlocks(), 3),
};

declare global {
  interface Window {
    benchRows: readonly string[];
    benchRow(name: string): number[];
  }
}
window.benchRows = Object.keys(rows);
window.benchRow = (name) => rows[name]?.() ?? [];
