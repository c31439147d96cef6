import type { Signal } from "@preact/signals";
import { SlidersHorizontal } from "lucide";
import { Icon } from "../../theme/icons";

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
