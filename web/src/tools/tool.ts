import type { Formation, Point } from "../document/formation";
import type { Selection } from "../document/selection";
import type { DocumentStore } from "../document/store";
import type { Camera, ScreenPoint, Size } from "../stage/camera";
import type { Handle } from "../stage/handles";
import type { PointerKind } from "../stage/hit";
import type { Overlay, ShapeName, Spacing } from "./toolbox";

/** Where a pointer is and what is held with it. */
export interface Pointing {
  /** Meters on the stage. */
  readonly at: Point;
  /** CSS pixels on the stage element. */
  readonly screen: ScreenPoint;
  readonly pointer: PointerKind;
  readonly shift: boolean;
  /** Ctrl, or Cmd on a Mac. */
  readonly ctrl: boolean;
  readonly alt: boolean;
}

/** What a tool hears. After a press come moves and then one release or cancel; moves come without a press, too. */
export type ToolEvent =
  /** `isBeside`: pressed beside everybody, wherever they have come since: the start of a box. */
  | (Pointing & { readonly kind: "press"; readonly isDouble: boolean; readonly isBeside?: boolean })
  | (Pointing & { readonly kind: "move" })
  | (Pointing & { readonly kind: "release" })
  | { readonly kind: "cancel" };

export type Press = Extract<ToolEvent, { kind: "press" }>;

/** What a tool acts through: what is under the pointer, the document, and nothing of the page. */
export interface Editor {
  readonly document: DocumentStore;
  /** The keyframe that is edited. */
  readonly keyframe: number;
  readonly camera: Camera;
  /** Of what is seen of the stage. */
  readonly size: Size;
  readonly shape: ShapeName;
  readonly spacing: Spacing;
  readonly tieScope: "scene" | "keyframe";
  /** Whether up on the screen is height: the show is seen from the front. */
  readonly isUpright: boolean;
  /** Whether groups are seen, and so taken as one. */
  readonly areGroupsShown: boolean;
  agentAt(pointing: Pointing): number | null;
  obstacleAt(pointing: Pointing): number | null;
  tieAt(pointing: Pointing): readonly [a: number, b: number] | null;
  /** Of the box around the selected agents. */
  handleAt(pointing: Pointing): Handle | null;
  agentsWithin(from: Point, to: Point): number[];
  /** A length as the person reads it, with its unit. */
  inWords(meters: number): string;
  /** `answer[i]` is the place in `target` of agent i of `source`; least total squared distance. */
  assign(source: Formation, target: Formation): Promise<ArrayLike<number>>;
  panBy(dx: number, dy: number): void;
  announce(text: string): void;
  /** A problem the person should see: what happened, and what to do. */
  warn(title: string, text: string): void;
}

/** A tool: states as data and one step between them. A state that holds a gesture closes it on every way out. */
export interface Tool<State> {
  readonly start: State;
  step(state: State, event: ToolEvent, editor: Editor): State;
  /** Enter: what is under way ends as it is, or what the tool makes is put in the middle. */
  settle?(state: State, editor: Editor): State;
  overlay(state: State): Overlay;
  cursor(state: State): string;
}

export const NO_OVERLAY: Overlay = { kind: "none" };

/** Pixels a pointer may tremble before a press becomes a drag. */
export function isDrag(from: ScreenPoint, to: Pointing): boolean {
  const slop = to.pointer === "touch" ? 10 : 4;
  return Math.hypot(to.screen.x - from.x, to.screen.y - from.y) > slop;
}

/** CSS pixels as meters at the camera's scale. */
export function metersOf(pixels: number, editor: Editor): number {
  return pixels / editor.camera.scale;
}

export function agentSelection(agents: ReadonlySet<number>): Selection {
  return agents.size > 0 ? { kind: "agents", agents } : { kind: "none" };
}
