import { type Signal, useSignalEffect } from "@preact/signals";
import { X } from "lucide";
import { useRef } from "preact/hooks";
import { Icon } from "../theme/icons";
import { useStudio } from "./studio";

/** A pull of the grip this far closes the sheet, CSS pixels. */
const FAR_ENOUGH = 60;

/** The sheet's upper edge: pressed or pulled down, it closes. What it covers of the stage the view is told. */
export function SheetGrip({ isOpen }: { isOpen: Signal<boolean> }) {
  const { aside, view } = useStudio();
  const grip = useRef<HTMLButtonElement>(null);
  const from = useRef<number | null>(null);

  useSignalEffect(() => {
    // The sheet is as high as the window has it, and so is the stage.
    void view.size.value;
    // A panel in the inspector's place lies where the sheet would.
    const kind = aside.value?.kind;
    const lies = isOpen.value || kind === "modes" || kind === "recording";
    const sheet = grip.current?.parentElement;
    view.covered.value = lies && sheet ? coveredBy(sheet) : 0;
  });

  function close(): void {
    from.current = null;
    isOpen.value = false;
  }
  return (
    <button
      ref={grip}
      type="button"
      class="sheet-grip"
      aria-label="Close"
      onPointerDown={(event) => {
        from.current = event.clientY;
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (from.current !== null && event.clientY - from.current > FAR_ENOUGH) close();
      }}
      onPointerUp={() => {
        from.current = null;
      }}
      onClick={close}
    >
      <Icon node={X} />
      <span class="sheet-bar" />
    </button>
  );
}

/** CSS pixels of the stage from below; a sheet at its side, or beside it, takes none of its height. */
function coveredBy(sheet: HTMLElement): number {
  const stage = sheet.parentElement?.querySelector<HTMLElement>(".stage");
  if (!stage || sheet.offsetTop <= stage.offsetTop) return 0;
  return Math.max(0, stage.offsetTop + stage.offsetHeight - sheet.offsetTop);
}
