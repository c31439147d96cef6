import type { Signal } from "@preact/signals";
import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { placeBeside } from "./place-beside";
import type { PopoverProps } from "./popover";

export interface PopoverPanelProps extends Pick<PopoverProps, "label" | "side" | "children"> {
  readonly id: string;
  readonly anchor: RefObject<HTMLButtonElement>;
  readonly isOpen: Signal<boolean>;
}

/** What a button opens over the page, opened as it comes; the browser closes it on Escape and on a press elsewhere. */
export function PopoverPanel({ id, label, side, anchor, isOpen, children }: PopoverPanelProps) {
  const panel = useRef<HTMLDivElement>(null);

  useLayoutEffect(() => panel.current?.showPopover(), []);

  // The content may arrive after the panel, so its place and its first control are looked for as it grows.
  useLayoutEffect(() => {
    const [button, opened] = [anchor.current, panel.current];
    if (!isOpen.value || !button || !opened) return;
    const settle = () => {
      placeBeside(opened, button, side);
      if (!opened.contains(opened.ownerDocument.activeElement)) firstControl(opened)?.focus();
    };
    const observer = new ResizeObserver(settle);
    settle();
    observer.observe(opened);
    return () => observer.disconnect();
  }, [isOpen.value, side, anchor]);

  return (
    <div
      ref={panel}
      id={id}
      class="popover"
      popover="auto"
      role="dialog"
      aria-label={label}
      onToggle={(event) => {
        isOpen.value = event.newState === "open";
      }}
    >
      {isOpen.value && children(() => panel.current?.hidePopover())}
    </div>
  );
}

function firstControl(panel: HTMLElement): HTMLElement | null {
  return panel.querySelector<HTMLElement>("button:not(:disabled), input:not(:disabled), select:not(:disabled)");
}
