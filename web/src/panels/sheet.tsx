import { type Signal, useSignal, useSignalEffect } from "@preact/signals";
import { SlidersHorizontal, X } from "lucide";
import { useRef } from "preact/hooks";
import { Icon } from "../theme/icons";
import { useStudio } from "./studio";
import { penOn } from "./travel/pen";

/** A pull of the grip this far closes the sheet, CSS pixels. */
const FAR_ENOUGH = 60;

/**
 * On a narrow screen the inspector is a sheet over the stage, which opens for what has nothing else to show and makes way
 * for the pen of a path.
 */
export function useSheet(): Signal<boolean> {
  const { document } = useStudio();
  const isOpen = useSignal(false);
  useSignalEffect(() => {
    const { kind } = document.selection.value;
    if (kind === "transition" || kind === "tie") isOpen.value = true;
    if (kind === "none") isOpen.value = false;
  });
  useSignalEffect(() => {
    if (penOn.value !== null) isOpen.value = false;
  });
  return isOpen;
}

/** Opens the sheet for what is selected; absent where the inspector has its own place. */
export function SheetButton({ isOpen }: { isOpen: Signal<boolean> }) {
  return (
    <div class="floating sheet-button">
      <button
        type="button"
        class="icon-button"
        aria-label="Show inspector"
        aria-expanded={isOpen.value}
        data-tip="Show inspector"
        data-tip-side="end"
        onClick={() => {
          isOpen.value = !isOpen.value;
        }}
      >
        <Icon node={SlidersHorizontal} />
      </button>
    </div>
  );
}

/** The sheet's upper edge: pressed or pulled down, it closes. */
export function SheetGrip({ isOpen }: { isOpen: Signal<boolean> }) {
  const from = useRef<number | null>(null);
  function close(): void {
    from.current = null;
    isOpen.value = false;
  }
  return (
    <button
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
