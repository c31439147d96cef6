import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import { placeBeside, type Side } from "./place-beside";

/** A button that opens something over the page; the browser closes it on Escape and on a press elsewhere. */
export function PopoverButton(props: {
  /** The accessible name of the button and of what it opens. */
  label: string;
  buttonClass: string;
  side: Side;
  tip?: string;
  tipSide?: string;
  /** The button's face. */
  face: ComponentChildren;
  /** Made when it is opened. */
  children: (close: () => void) => ComponentChildren;
}) {
  const { side } = props;
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const panel = useRef<HTMLDivElement>(null);
  const isOpen = useSignal(false);

  // The content may arrive after the panel, so its place and its first control are looked for as it grows.
  useLayoutEffect(() => {
    const [anchor, opened] = [button.current, panel.current];
    if (!isOpen.value || !anchor || !opened) return;
    const settle = () => {
      placeBeside(opened, anchor, side);
      if (!opened.contains(opened.ownerDocument.activeElement)) firstControl(opened)?.focus();
    };
    const observer = new ResizeObserver(settle);
    settle();
    observer.observe(opened);
    return () => observer.disconnect();
  }, [isOpen.value, side]);

  return (
    <>
      <button
        ref={button}
        type="button"
        class={props.buttonClass}
        aria-label={props.label}
        aria-haspopup="dialog"
        aria-expanded={isOpen.value}
        popovertarget={id}
        data-tip={props.tip}
        data-tip-side={props.tipSide}
      >
        {props.face}
      </button>
      <div
        ref={panel}
        id={id}
        class="popover"
        popover="auto"
        role="dialog"
        aria-label={props.label}
        onToggle={(event) => {
          isOpen.value = event.newState === "open";
        }}
      >
        {isOpen.value && props.children(() => panel.current?.hidePopover())}
      </div>
    </>
  );
}

function firstControl(panel: HTMLElement): HTMLElement | null {
  return panel.querySelector<HTMLElement>("button:not(:disabled), input:not(:disabled), select:not(:disabled)");
}
