import { type Signal, signal } from "@preact/signals";
import type { DocumentStore } from "../../document/store";
import { type DragState, IDLE } from "./drag-state";
import type { DragInput, KeyframeDrag, TrackLook } from "./keyframe-drag";

/** A keyframe drag that is fetched when the first keyframe is pressed; a press waits for it. */
export class LaterDrag {
  readonly state: Signal<DragState> = signal(IDLE);
  private drag: KeyframeDrag | null = null;
  /** The press that waits, until it is let go. */
  private waiting: (() => void) | null = null;

  constructor(
    private readonly document: DocumentStore,
    private readonly track: TrackLook,
  ) {}

  press(index: number, x: number, playhead: number): void {
    this.waiting = () => this.drag?.press(index, x, playhead);
    if (this.drag) this.start();
    else void this.fetch();
  }

  move(input: DragInput): void {
    this.drag?.move(input);
  }

  release(): number | null {
    this.waiting = null;
    return this.drag?.release() ?? null;
  }

  cancel(): void {
    this.waiting = null;
    this.drag?.cancel();
  }

  private async fetch(): Promise<void> {
    // Without it a keyframe can still be chosen, and retimed in the inspector.
    const part = await import("./keyframe-drag").catch(() => null);
    this.drag ??= part && new part.KeyframeDrag(this.document, this.track, this.state);
    this.start();
  }

  private start(): void {
    this.waiting?.();
    this.waiting = null;
  }
}
