import type { Viewport } from "./viewport";

/** Pixels a finger may wander and still tap. */
const TAP_SLOP = 6;

interface Finger {
  readonly startX: number;
  readonly x: number;
}

/** One finger pulls the timeline along, two zoom it. What was pulled is not tapped as well. */
export class TrackTouch {
  private readonly fingers = new Map<number, Finger>();
  private hasMoved = false;

  constructor(private readonly viewport: Viewport) {}

  down(id: number, x: number): void {
    if (this.fingers.size === 0) this.hasMoved = false;
    this.fingers.set(id, { startX: x, x });
  }

  /** @param left of the track's window, CSS pixels of the page */
  move(id: number, x: number, left: number): void {
    const finger = this.fingers.get(id);
    if (!finger) return;
    this.hasMoved ||= Math.abs(x - finger.startX) > TAP_SLOP;
    if (this.hasMoved) {
      const other = [...this.fingers].find(([key]) => key !== id)?.[1];
      if (other) this.pinch(finger, other, x, left);
      else this.viewport.scrollTo(this.viewport.scroll.peek() - (x - finger.x));
    }
    this.fingers.set(id, { ...finger, x });
  }

  up(id: number): void {
    this.fingers.delete(id);
  }

  /** Whether the gesture that just ended moved the timeline; true once. */
  takesClick(): boolean {
    const hasMoved = this.hasMoved;
    this.hasMoved = false;
    return hasMoved;
  }

  private pinch(finger: Finger, other: Finger, x: number, left: number): void {
    const before = Math.max(20, Math.abs(finger.x - other.x));
    const after = Math.max(20, Math.abs(x - other.x));
    this.viewport.scrollTo(this.viewport.scroll.peek() - (x - finger.x) / 2);
    this.viewport.zoomBy(after / before, (x + other.x) / 2 - left);
  }
}
