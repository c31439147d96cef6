import { X } from "lucide";
import type { ComponentChildren } from "preact";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import { Icon } from "../../theme/icons";
import { releaseFocus } from "../release-focus";

export interface FrameProps {
  readonly title: ComponentChildren;
  /** One of the sizes of dialogs.css. */
  readonly size: "small" | "medium" | "large" | "whole";
  /** A line under the title. */
  readonly lead?: ComponentChildren;
  onClose(): void;
  readonly children: ComponentChildren;
}

/** A titled dialog; a sheet from the bottom on a phone. */
export function Frame({ title, size, lead, onClose, children }: FrameProps) {
  const id = useId();
  return (
    <Modal class={`dialog is-${size}`} labelledBy={id} onClose={onClose}>
      <header class="dialog-head">
        <h2 id={id}>{title}</h2>
        <button type="button" class="icon-button" aria-label="Close" onClick={onClose}>
          <Icon node={X} />
        </button>
        {lead && <p class="dialog-lead">{lead}</p>}
      </header>
      {children}
    </Modal>
  );
}

export interface ModalProps {
  readonly class: string;
  readonly label?: string;
  readonly labelledBy?: string;
  onClose(): void;
  readonly children: ComponentChildren;
}

/**
 * The browser's own modal dialog: it keeps the focus inside; Escape and a press beside it close. Whoever opened it by
 * keys has the focus back where it was; after a pointer's press keys are meant for the stage.
 */
export function Modal({ class: name, label, labelledBy, onClose, children }: ModalProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => {
    const element = dialog.current;
    const wasOpenedByKeys = document.activeElement?.matches(":focus-visible") ?? false;
    element?.showModal();
    // Without a control that asks for it, the dialog itself has the focus: Close is not what most come for.
    if (!element?.querySelector("[autofocus]")) element?.focus();
    // Closed before it leaves the page: only then does the browser return the focus.
    return () => {
      element?.close();
      if (!wasOpenedByKeys) releaseFocus();
    };
  }, []);
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: Escape is the key that closes, and the browser hears it.
    <dialog
      ref={dialog}
      class={name}
      tabIndex={-1}
      aria-label={label}
      aria-labelledby={labelledBy}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
      onClick={(event) => {
        if (event.target === event.currentTarget && isBeside(event, event.currentTarget)) onClose();
      }}
    >
      {children}
    </dialog>
  );
}

/** Gives an element that comes later the focus which the dialog itself has meanwhile; whoever moved on is left alone. */
export function focusLate(element: HTMLElement | null): void {
  if (element && document.activeElement === element.closest("dialog")) element.focus();
}

function isBeside(event: MouseEvent, element: Element): boolean {
  const box = element.getBoundingClientRect();
  return event.clientX < box.left || event.clientX > box.right || event.clientY < box.top || event.clientY > box.bottom;
}
