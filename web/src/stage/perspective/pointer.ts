import type { ScreenPoint } from "../camera";
import { agentReach, type PointerKind } from "../hit";
import { createFingers, screenOn, wheelZoom } from "../pointers";
import type { Steering } from "./steering";

/** Radians a pixel: across a stage of common width it is half a turn. */
const TURN = 0.004;

/** A press that moves less is a click, pixels. */
const CLICK = 4;

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
  const fingers = createFingers();
  let doing: Doing = NOTHING;
  const screenOf = (event: MouseEvent) => screenOn(element, event);

  function onDown(event: PointerEvent): void {
    const at = screenOf(event);
    if (event.pointerType === "touch") fingers.put(event.pointerId, at);
    if (fingers.count > 1) {
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
    const pinched = fingers.pinch(id, now);
    if (!pinched) return;
    steering.slide(pinched.from, pinched.to);
    steering.zoom(pinched.spread, pinched.to);
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
    fingers.lift(event.pointerId);
    const isOurs = "pointer" in doing && doing.pointer === event.pointerId;
    if (isOurs || (doing.kind === "pinch" && fingers.count === 0)) doing = NOTHING;
  }

  function onWheel(event: WheelEvent): void {
    event.preventDefault();
    steering.zoom(wheelZoom(event), screenOf(event));
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
