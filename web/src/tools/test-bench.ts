import { computed, signal } from "@preact/signals";
import { addAgents } from "../document/commands/agents";
import { addKeyframe } from "../document/commands/keyframes";
import { createDocument } from "../document/create-store";
import { emptyScene } from "../document/defaults";
import { Formation, type Point } from "../document/formation";
import { durationOf } from "../document/limits";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { createPlayback, type Playback } from "../playback/playback";
import { toScreen } from "../stage/camera";
import { createView } from "../stage/create-view";
import type { View } from "../stage/view";
import { createToolbox, type ToolboxAtWork } from "./create-toolbox";
import type { Pointing, ToolEvent } from "./tool";
import { createWorkbench } from "./workbench";

/** Pixels a meter on the bench: an agent is hit within a third of a meter at most. */
const SCALE = 40;

/** A formation to start from. */
export const SQUARE: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

export type Held = Partial<Pick<Pointing, "shift" | "ctrl" | "alt">>;

/** A toolbox with a document, a view and a show, for tests that act as a hand does. */
export interface Bench {
  readonly document: DocumentStore;
  readonly toolbox: ToolboxAtWork;
  readonly view: View;
  readonly playback: Playback;
  readonly ties: { value: readonly ({ readonly pairs: Uint32Array } | null)[] };
  readonly announced: string[];
  readonly warned: string[];
  /** What the engine answers: by default everybody keeps their order. */
  assign: (source: Formation, target: Formation) => Promise<ArrayLike<number>>;
  /** Where everybody is shown; null: at the keyframe that is edited. */
  shownXy: () => ArrayLike<number> | null;
  press(at: Point, held?: Held & { readonly isDouble?: boolean }): void;
  move(at: Point, held?: Held): void;
  release(at: Point, held?: Held): void;
  click(at: Point, held?: Held): void;
  /** Press at the first place, move through the others, release at the last. */
  drag(path: readonly Point[], held?: Held): void;
  /** Until what waits for the engine is done. */
  settled(): Promise<void>;
  place(agent: number, keyframe?: number): Point;
  selected(): number[];
}

/** @param formations of one keyframe each, eight counts apart; the first may be empty */
export function createBench(...formations: readonly (readonly Point[])[]): Bench {
  return benchWith(formations, createWorkbench);
}

/** A bench whose tools are fetched when the first is wanted, as in the page. */
export function createLateBench(...formations: readonly (readonly Point[])[]): Bench {
  return benchWith(formations);
}

function benchWith(formations: readonly (readonly Point[])[], tools?: typeof createWorkbench): Bench {
  const [first = [], ...later] = formations;
  let scene = first.length > 0 ? addAgents(first).apply(emptyScene()) : emptyScene();
  for (const formation of later) {
    const last = mainTrack(scene).keyframes.at(-1);
    scene = addKeyframe(last?.time ?? 0, Formation.from(formation)).apply(scene);
  }
  const document = createDocument(scene);
  const playback = createPlayback(computed(() => durationOf(document.scene.value)));
  const view = createView(document.scene);
  view.camera.value = { scale: SCALE, left: 500, top: 400 };
  const ties = signal<readonly ({ readonly pairs: Uint32Array } | null)[]>([]);
  const announced: string[] = [];
  const warned: string[] = [];

  const keyframeXy = () =>
    mainTrack(document.scene.peek()).keyframes[document.activeKeyframe.peek()]?.positions.xy ?? [];

  const bench: Bench = {
    document,
    view,
    playback,
    ties,
    announced,
    warned,
    assign: async (source) => Uint32Array.from({ length: source.agentCount }, (_, i) => i),
    shownXy: () => null,
    toolbox: createToolbox(
      {
        document,
        view,
        playback,
        ties,
        engine: { assign: async (source, target) => Uint32Array.from(await bench.assign(source, target)) },
        shownXy: () => bench.shownXy() ?? keyframeXy(),
        announce: (text) => announced.push(text),
        warn: (title) => warned.push(title),
      },
      tools,
    ),
    press: (at, held) => bench.toolbox.send({ kind: "press", isDouble: false, ...pointing(at, held) }),
    move: (at, held) => bench.toolbox.send({ kind: "move", ...pointing(at, held) }),
    release: (at, held) => bench.toolbox.send({ kind: "release", ...pointing(at, held) }),
    click(at, held) {
      bench.press(at, held);
      bench.release(at, held);
    },
    drag(path, held) {
      const last = path.at(-1);
      if (path[0]) bench.press(path[0], held);
      for (const at of path.slice(1)) bench.move(at, held);
      if (last) bench.release(last, held);
    },
    settled: () => new Promise((resolve) => setTimeout(resolve, 0)),
    place: (agent, keyframe = 0) =>
      mainTrack(document.scene.value).keyframes[keyframe]?.positions.point(agent) ?? [NaN, NaN],
    selected() {
      const selection = document.selection.value;
      return selection.kind === "agents" ? [...selection.agents].sort((a, b) => a - b) : [];
    },
  };

  function pointing(
    at: Point,
    held: Held & { readonly isDouble?: boolean } = {},
  ): Omit<Extract<ToolEvent, { kind: "move" }>, "kind"> {
    return {
      at,
      screen: toScreen(view.camera.peek(), at),
      pointer: "mouse",
      shift: false,
      ctrl: false,
      alt: false,
      ...held,
    };
  }

  return bench;
}
