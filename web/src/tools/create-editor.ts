import type { ReadonlySignal } from "@preact/signals";
import { distanceTo } from "../document/obstacle";
import { selectedAgents } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { lengthWithUnit } from "../document/units";
import type { Playback } from "../playback/playback";
import { handleAt, handlesOf, selectionBounds, selectionBox } from "../stage/handles";
import { agentAt, agentReach, agentsWithin, handleReach, tieAt, tieReach } from "../stage/hit";
import { liftsOf } from "../stage/lifts";
import { discRadius, screenSpacing, spacingAt } from "../stage/spacing";
import type { View } from "../stage/view";
import type { Editor } from "./tool";
import type { Toolbox } from "./toolbox";

/** What the tools are put to work with. */
export interface ToolParts {
  readonly document: DocumentStore;
  readonly view: View;
  readonly playback: Playback;
  /** Tools know no engine, only who answers this one question: see [`Editor.assign`]. */
  readonly engine: Pick<Editor, "assign">;
  /** Ties by keyframe, as drawn: a0, b0, a1, b1, …; null while unknown. */
  readonly ties: ReadonlySignal<readonly ({ readonly pairs: Uint32Array } | null)[]>;
  /** Where the stage shows everybody: x, y an agent, meters. */
  shownXy(): ArrayLike<number>;
  announce(text: string): void;
  warn(title: string, text: string): void;
}

/** The editor of the page: what is shown is what is hit. */
export function createEditor(parts: ToolParts, settings: Pick<Toolbox, "shape" | "spacing" | "tieScope">): Editor {
  const { document, view, playback } = parts;

  /** Of the discs as they are drawn, CSS pixels. */
  function radius(): number {
    const spacing = spacingAt(mainTrack(document.scene.peek()), playback.time.peek());
    return discRadius(screenSpacing(spacing, view.camera.peek().scale));
  }

  return {
    document,
    get keyframe() {
      return document.activeKeyframe.peek();
    },
    get camera() {
      return view.camera.peek();
    },
    get size() {
      return view.size.peek();
    },
    get shape() {
      return settings.shape.peek();
    },
    get spacing() {
      return settings.spacing.peek();
    },
    get tieScope() {
      return settings.tieScope.peek();
    },
    get isUpright() {
      return view.projection.peek() === "front";
    },
    get areGroupsShown() {
      return view.layers.peek().groups;
    },
    agentAt: ({ screen, pointer }) =>
      agentAt(parts.shownXy(), view.camera.peek(), screen, agentReach(radius(), pointer)),
    obstacleAt({ at }) {
      const { obstacles } = document.scene.peek();
      const index = obstacles.findLastIndex(({ shape }) => distanceTo(shape, at) === 0);
      return index < 0 ? null : index;
    },
    tieAt({ screen, pointer }) {
      const pairs = parts.ties.peek()[document.activeKeyframe.peek()]?.pairs;
      if (!pairs) return null;
      const tie = tieAt(pairs, parts.shownXy(), view.camera.peek(), screen, tieReach(pointer));
      return tie === null ? null : [pairs[2 * tie] ?? 0, pairs[2 * tie + 1] ?? 0];
    },
    handleAt({ screen, pointer }) {
      const selection = document.selection.peek();
      const hasBox = selection.kind === "agents" || selection.kind === "group";
      const bounds = hasBox ? selectionBounds(parts.shownXy(), selectedAgents(document.scene.peek(), selection)) : null;
      if (!bounds) return null;
      const camera = view.camera.peek();
      const box = selectionBox(bounds, camera, radius());
      const isSpatial = mainTrack(document.scene.peek()).keyframes.some(({ positions }) => positions.heights);
      const handles = handlesOf(box, liftsOf(view.projection.peek(), isSpatial));
      // A fingertip reaches from a handle to the agents beside it: on a disc it means the agent.
      const isOnDisc = agentAt(parts.shownXy(), camera, screen, radius()) !== null;
      return isOnDisc ? null : handleAt(box, handles, screen, handleReach(pointer));
    },
    agentsWithin: (from, to) => agentsWithin(parts.shownXy(), from, to),
    inWords: (meters) => lengthWithUnit(meters, document.scene.peek().stage.units),
    assign: (source, target) => parts.engine.assign(source, target),
    panBy: (dx, dy) => view.panBy(dx, dy),
    announce: parts.announce,
    warn: parts.warn,
  };
}
