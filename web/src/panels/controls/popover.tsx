import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useId, useRef } from "preact/hooks";
import { lazily } from "../lazily";
import type { Side } from "./place-beside";

const PopoverPanel = lazily(() => import("./popover-panel").then((part) => part.PopoverPanel));

export interface PopoverProps {
  /** The accessible name of the button and of what it opens. */
  readonly label: string;
  readonly buttonClass: string;
  readonly side: Side;
  readonly tip?: string;
  readonly tipSide?: string;
  /** The button's face. */
  readonly face: ComponentChildren;
  /** Made when it is opened. */
  readonly children: (close: () => void) => ComponentChildren;
}

/** A button that opens something over the page. What opens is fetched at the first press; from then on the browser opens it. */
export function PopoverButton(props: PopoverProps) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const isWanted = useSignal(false);
  const isOpen: Signal<boolean> = useSignal(false);
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
        onKeyDown={(event) => {
          // The browser closes what is open: no shortcut takes the key before the focus is inside.
          if (event.key === "Escape" && document.getElementById(id)?.matches(":popover-open")) event.stopPropagation();
        }}
        onClick={(event) => {
          // What opens itself as it comes would be closed again by this very press.
          if (!isWanted.value) event.preventDefault();
          isWanted.value = true;
        }}
      >
        {props.face}
      </button>
      {isWanted.value && (
        <PopoverPanel id={id} label={props.label} side={props.side} anchor={button} isOpen={isOpen}>
          {props.children}
        </PopoverPanel>
      )}
    </>
  );
}
