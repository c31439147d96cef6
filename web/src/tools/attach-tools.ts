import { effect } from "@preact/signals";
import type { ScreenPoint } from "../stage/camera";
import { toStage } from "../stage/camera";
import { createFingers, screenOn, wheelTurn, wheelZoom } from "../stage/pointers";
import type { View } from "../stage/view";
import type { ToolboxAtWork } from "./create-toolbox";
import type { Pointing } from "./tool";

/** A second press this soon and this near is a double one. */
const DOUBLE = { milliseconds: 400, pixels: 8 } as const;

/** Pixels below which a step of the wheel is a trackpad's. */
const FINE = 40;
/** Milliseconds without a step that end a roll. */
const ROLL = 200;

/** What the pointers on the stage are doing. */
type Doing =
  | { readonly kind: "nothing" }
  | { readonly kind: "tool"; readonly pointer: number }
  | { readonly kind: "pan"; readonly pointer: number; readonly last: ScreenPoint }
  /** Two fingers; until all are lifted nothing else begins. */
  | { readonly kind: "pinch" };

const NOTHING: Doing = { kind: "nothing" };

/** Brings pointer and wheel on the stage to the tool in hand; panning and zooming belong to the view. Answers how to stop. */
export function attachTools(
  element: HTMLElement,
  toolbox: Pick<ToolboxAtWork, "cursor" | "isSpaceHeld" | "notePan" | "send">,
  view: View,
  isMac: boolean,
): () => void {
  const fingers = createFingers();
  let doing: Doing = NOTHING;
  let lastRoll = { time: Number.NEGATIVE_INFINITY, isFine: false };
  let lastPress = { time: Number.NEGATIVE_INFINITY, screen: { x: 0, y: 0 } };

  const screenOf = (event: MouseEvent) => screenOn(element, event);

  function pointing(event: PointerEvent): Pointing {
    const screen = screenOf(event);
    return {
      at: toStage(view.camera.peek(), screen),
      screen,
      pointer: event.pointerType,
      shift: event.shiftKey,
      ctrl: isMac ? event.metaKey : event.ctrlKey,
      alt: event.altKey,
    };
  }

  function isDouble(event: PointerEvent): boolean {
    const screen = screenOf(event);
    const away = Math.hypot(screen.x - lastPress.screen.x, screen.y - lastPress.screen.y);
    const isSecond = event.timeStamp - lastPress.time < DOUBLE.milliseconds && away < DOUBLE.pixels;
    lastPress = { time: isSecond ? Number.NEGATIVE_INFINITY : event.timeStamp, screen };
    return isSecond;
  }

  function onDown(event: PointerEvent): void {
    if (event.pointerType === "touch") {
      fingers.put(event.pointerId, screenOf(event));
      if (fingers.count > 1) {
        if (doing.kind === "tool") toolbox.send({ kind: "cancel" });
        doing = { kind: "pinch" };
        return;
      }
    }
    if (doing.kind !== "nothing") return;
    const isPan = event.button === 1 || (event.button === 0 && toolbox.isSpaceHeld.peek());
    if (!isPan && event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    if (isPan) {
      toolbox.notePan();
      doing = { kind: "pan", pointer: event.pointerId, last: screenOf(event) };
      element.style.cursor = "grabbing";
      return;
    }
    doing = { kind: "tool", pointer: event.pointerId };
    toolbox.send({ kind: "press", isDouble: isDouble(event), ...pointing(event) });
  }

  function onMove(event: PointerEvent): void {
    if (doing.kind === "pinch") {
      pinch(event);
      return;
    }
    if (doing.kind === "pan") {
      if (event.pointerId !== doing.pointer) return;
      const screen = screenOf(event);
      view.panBy(screen.x - doing.last.x, screen.y - doing.last.y);
      doing = { ...doing, last: screen };
      return;
    }
    if (doing.kind === "tool" && event.pointerId !== doing.pointer) return;
    if (doing.kind === "nothing" && event.pointerType === "touch") return;
    if (event.pointerType === "touch") fingers.put(event.pointerId, screenOf(event));
    toolbox.send({ kind: "move", ...pointing(event) });
  }

  function pinch(event: PointerEvent): void {
    const pinched = fingers.pinch(event.pointerId, screenOf(event));
    if (!pinched) return;
    const { from, to, spread } = pinched;
    view.panBy(to.x - from.x, to.y - from.y);
    view.zoomBy(spread, to);
  }

  function onUp(event: PointerEvent): void {
    const isOurs = (doing.kind === "tool" || doing.kind === "pan") && event.pointerId === doing.pointer;
    if (doing.kind === "tool" && isOurs) toolbox.send({ kind: "release", ...pointing(event) });
    lift(event, isOurs);
  }

  function onLost(event: PointerEvent): void {
    const isOurs = (doing.kind === "tool" || doing.kind === "pan") && event.pointerId === doing.pointer;
    if (doing.kind === "tool" && isOurs) toolbox.send({ kind: "cancel" });
    lift(event, isOurs);
  }

  function lift(event: PointerEvent, isOurs: boolean): void {
    fingers.lift(event.pointerId);
    if (isOurs || (doing.kind === "pinch" && fingers.count === 0)) doing = NOTHING;
    element.style.cursor = toolbox.cursor.peek();
  }

  function onLeave(): void {
    if (doing.kind === "nothing") view.hovered.value = null;
  }

  function onWheel(event: WheelEvent): void {
    event.preventDefault();
    const { dx, dy } = wheelTurn(event);
    // A roll stays what it began as: its fast middle part looks like a wheel's.
    const isSameRoll = event.timeStamp - lastRoll.time < ROLL;
    lastRoll = { time: event.timeStamp, isFine: isSameRoll ? lastRoll.isFine : isFine(event) };
    if (event.ctrlKey || event.metaKey) view.zoomBy(wheelZoom(event), screenOf(event));
    else if (event.shiftKey) view.panBy(-(dx || dy), 0);
    else if (lastRoll.isFine) view.panBy(-dx, -dy);
    else view.zoomBy(wheelZoom(event), screenOf(event));
  }

  const stopCursor = effect(() => {
    element.style.cursor = toolbox.cursor.value;
  });
  element.style.touchAction = "none";
  element.style.userSelect = "none";
  const heard = new AbortController();
  const listen = { signal: heard.signal };
  element.addEventListener("pointerdown", onDown, listen);
  element.addEventListener("pointermove", onMove, listen);
  element.addEventListener("pointerup", onUp, listen);
  element.addEventListener("pointercancel", onLost, listen);
  element.addEventListener("lostpointercapture", onLost, listen);
  element.addEventListener("pointerleave", onLeave, listen);
  element.addEventListener("wheel", onWheel, { ...listen, passive: false });
  // The middle button would scroll the page by itself.
  element.addEventListener("mousedown", (event) => event.button === 1 && event.preventDefault(), listen);
  return () => {
    heard.abort();
    stopCursor();
  };
}

/** Two fingers on a trackpad roll both ways or in fine steps, a mouse wheel down in coarse ones. */
function isFine({ deltaMode, deltaX, deltaY }: WheelEvent): boolean {
  return deltaMode === WheelEvent.DOM_DELTA_PIXEL && (deltaX !== 0 || Math.abs(deltaY) < FINE);
}
