import type { ComponentChildren } from "preact";
import { useId, useRef } from "preact/hooks";
import { placeBeside, type Side } from "./place-beside";

/** A button that opens something over the page; the browser closes it on Escape and on a press elsewhere. */
export function PopoverButton(props: {
  /** The accessible name of the button and of what it opens. */
  label: string;
  buttonClass: string;
  side: Side;
  tip?: string;
  tipSide?: string;
  isDisabled?: boolean;
  /** The button's face. */
  face: ComponentChildren;
  children: (close: () => void) => ComponentChildren;
}) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const panel = useRef<HTMLDivElement>(null);
  const close = () => panel.current?.hidePopover();
  return (
    <>
      <button
        ref={button}
        type="button"
        class={props.buttonClass}
        aria-label={props.label}
        aria-haspopup="dialog"
        popovertarget={id}
        disabled={props.isDisabled ?? false}
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
          const isOpen = event.newState === "open";
          button.current?.setAttribute("aria-expanded", String(isOpen));
          if (!isOpen || !button.current || !panel.current) return;
          placeBeside(panel.current, button.current, props.side);
          panel.current.querySelector<HTMLElement>("button, input, select")?.focus();
        }}
      >
        {props.children(close)}
      </div>
    </>
  );
}
