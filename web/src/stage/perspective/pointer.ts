import type { ScreenPoint } from "../camera";
import { agentReach, type PointerKind } from "../hit";
import type { Steering } from "./steering";

/** Radians a pixel: across a stage of common width it is half a turn. */
const TURN = 0.004;

/** A press that moves less is a click, pixels. */
const CLICK = 4;

/** As on the plan: wheel pixels that double the size, and much fewer for a pinch on a trackpad; pixels a line. */
const WHEEL_DOUBLING = 400;
const PINCH_DOUBLING = 70;
const LINE = 16;

/** What the pointers are doing. */
type Doing =
  | { readonly kind: "nothing" }
  | { readonly kind: "press"; readonly pointer: number; readonly from: ScreenPoint }
  | { readonly kind: "turn"; readonly pointer: number; readonly last: ScreenPoint }
  | { readonly kind: "slide"; readonly pointer: number; readonly last: ScreenPoint }
  /** Two fingers; until all are lifted nothing else begins. */
  | { readonly kind: "pinch" };

const NOTHING: Doing = { kind: "nothing" };

/** Drag turns, Shift-drag and two fingers slide, wheel and pinch zoom, a click picks. Answers how to stop. */
export function attachPointer(element: HTMLElement, steering: Steering, isMac: boolean): () => void {
  const fingers = new Map<number, ScreenPoint>();
  let doing: Doing = NOTHING;

  function screenOf(event: MouseEvent): ScreenPoint {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  function onDown(event: PointerEvent): void {
    const at = screenOf(event);
    if (event.pointerType === "touch") fingers.set(event.pointerId, at);
    if (fingers.size > 1) {
      doing = { kind: "pinch" };
      return;
    }
    if (doing.kind !== "nothing" || event.button > 1) return;
    element.setPointerCapture(event.pointerId);
    const isSlide = event.button === 1;
    doing = isSlide
      ? { kind: "slide", pointer: event.pointerId, last: at }
      : { kind: "press", pointer: event.pointerId, from: at };
  }

  function onMove(event: PointerEvent): void {
    const at = screenOf(event);
    switch (doing.kind) {
      case "pinch":
        pinch(event.pointerId, at);
        return;
      case "nothing":
        if (event.pointerType !== "touch") steering.hover(at, slackOf(event.pointerType));
        return;
      case "press": {
        if (event.pointerId !== doing.pointer) return;
        if (Math.hypot(at.x - doing.from.x, at.y - doing.from.y) < CLICK) return;
        steering.hover(null, 0);
        follow({ kind: event.shiftKey ? "slide" : "turn", pointer: event.pointerId, last: doing.from }, at);
        return;
      }
      default:
        if (event.pointerId === doing.pointer) follow(doing, at);
    }
  }

  function follow(dragging: Extract<Doing, { readonly last: ScreenPoint }>, at: ScreenPoint): void {
    const { last } = dragging;
    if (dragging.kind === "turn") steering.turn((last.x - at.x) * TURN, (at.y - last.y) * TURN);
    else steering.slide(last, at);
    doing = { ...dragging, last: at };
  }

  function pinch(id: number, now: ScreenPoint): void {
    const before = fingers.get(id);
    if (!before) return;
    fingers.set(id, now);
    const still = [...fingers].find(([other]) => other !== id)?.[1];
    if (!still) return;
    // One finger moves at a time: the middle of the two goes half its way.
    const middle = (moving: ScreenPoint) => ({ x: (moving.x + still.x) / 2, y: (moving.y + still.y) / 2 });
    steering.slide(middle(before), middle(now));
    const spread = Math.hypot(now.x - still.x, now.y - still.y) / Math.hypot(before.x - still.x, before.y - still.y);
    if (Number.isFinite(spread) && spread > 0) steering.zoom(spread, middle(now));
  }

  function onUp(event: PointerEvent): void {
    if (doing.kind === "press" && event.pointerId === doing.pointer) {
      const isToggle = isMac ? event.metaKey : event.ctrlKey;
      steering.pick(
        screenOf(event),
        slackOf(event.pointerType),
        event.shiftKey ? "add" : isToggle ? "toggle" : "replace",
      );
    }
    lift(event);
  }

  function lift(event: PointerEvent): void {
    fingers.delete(event.pointerId);
    const isOurs = "pointer" in doing && doing.pointer === event.pointerId;
    if (isOurs || (doing.kind === "pinch" && fingers.size === 0)) doing = NOTHING;
  }

  function onWheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : LINE);
    const doubling = event.ctrlKey || event.metaKey ? PINCH_DOUBLING : WHEEL_DOUBLING;
    steering.zoom(2 ** (-pixels / doubling), screenOf(event));
  }

  const heard = new AbortController();
  const listen = { signal: heard.signal };
  element.addEventListener("pointerdown", onDown, listen);
  element.addEventListener("pointermove", onMove, listen);
  element.addEventListener("pointerup", onUp, listen);
  element.addEventListener("pointercancel", lift, listen);
  element.addEventListener("pointerleave", () => steering.hover(null, 0), listen);
  element.addEventListener("wheel", onWheel, { ...listen, passive: false });
  // The middle button would scroll the page by itself.
  element.addEventListener("mousedown", (event) => event.button === 1 && event.preventDefault(), listen);
  return () => heard.abort();
}

function slackOf(pointer: PointerKind): number {
  return agentReach(0, pointer);
}
