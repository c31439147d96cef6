import { type Signal, signal } from "@preact/signals";
import { reorderKeyframe } from "../../document/commands/keyframes";
import { retimeKeyframe, rippleKeyframe } from "../../document/commands/retime";
import { type Keyframe, mainTrack, type Scene } from "../../document/scene";
import type { DocumentStore } from "../../document/store";
import { type DragState, IDLE } from "./drag-state";
import { type Scale, xOf } from "./scale";
import { type SnapTargets, snapTime } from "./snap";

export interface DragInput {
  /** Track pixels. */
  readonly x: number;
  readonly isRipple: boolean;
}

/** How the track is looked at while something is dragged on it. */
export interface TrackLook {
  scale(): Scale;
  ruler(): SnapTargets["ruler"];
}

/** Pixels a press may wander and still be a click. */
const CLICK_SLOP = 4;
/** Times are set to the millisecond, seconds. */
const ROUNDING = 1e-3;
/** A pointer this near to another keyframe's middle means its place. */
const PLACE_REACH = 18;

/** Dragging a keyframe along the timeline: one undo entry, or none. */
export class KeyframeDrag {
  readonly state: Signal<DragState>;
  /** The scene when the press began: where everything is measured from. */
  private start: Scene;
  /** Where the playhead was then, scene seconds: a dragged keyframe sticks to it. Later it may be dragged along. */
  private playhead = 0;

  constructor(
    private readonly document: DocumentStore,
    private readonly track: TrackLook,
    state: Signal<DragState> = signal(IDLE),
  ) {
    this.state = state;
    this.start = document.scene.peek();
  }

  press(index: number, x: number, playhead: number): void {
    this.cancel();
    this.playhead = playhead;
    this.start = this.document.scene.peek();
    this.state.value = { kind: "pressed", index, x };
  }

  move(input: DragInput): void {
    const state = this.state.peek();
    if (state.kind === "idle") return;
    const { index, x } = state;
    if (state.kind === "pressed" && Math.abs(input.x - x) < CLICK_SLOP) return;
    const gesture = state.kind === "pressed" ? this.document.beginGesture() : state.gesture;
    const other = this.keyframeUnder(input.x, index);
    if (other !== null) {
      gesture.preview(retimeKeyframe(index, this.keyframes[index]?.time ?? 0));
      this.state.value = { kind: "reordering", index, x, gesture, other };
      return;
    }
    const scale = this.track.scale();
    const wanted = (this.keyframes[index]?.time ?? 0) + (input.x - x) / scale.pixelsPerSecond;
    const snapped = snapTime(wanted, this.start, {
      pixelsPerSecond: scale.pixelsPerSecond,
      times: [this.playhead],
      ruler: this.track.ruler(),
    });
    gesture.preview(input.isRipple ? rippleKeyframe(index, snapped) : retimeKeyframe(index, snapped));
    const landed = mainTrack(this.document.scene.peek()).keyframes[index]?.time ?? snapped;
    const isStopped = wanted < 0 || Math.abs(landed - snapped) > ROUNDING;
    this.state.value = { kind: "retiming", index, x, gesture, stop: isStopped ? landed : null };
  }

  /** @returns where the keyframe is in the order after a drag; null when it was a click */
  release(): number | null {
    const state = this.state.peek();
    this.state.value = IDLE;
    if (state.kind === "reordering") state.gesture.preview(reorderKeyframe(state.index, state.other));
    if (state.kind === "retiming" || state.kind === "reordering") state.gesture.commit();
    if (state.kind === "reordering") return state.other;
    return state.kind === "retiming" ? state.index : null;
  }

  cancel(): void {
    const state = this.state.peek();
    this.state.value = IDLE;
    if (state.kind === "retiming" || state.kind === "reordering") state.gesture.cancel();
  }

  private get keyframes(): readonly Keyframe[] {
    return mainTrack(this.start).keyframes;
  }

  private keyframeUnder(x: number, index: number): number | null {
    const scale = this.track.scale();
    const found = this.keyframes.findIndex(
      (keyframe, other) => other !== index && Math.abs(xOf(scale, keyframe.time) - x) < PLACE_REACH,
    );
    return found < 0 ? null : found;
  }
}
