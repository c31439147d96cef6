import type { ComponentChildren } from "preact";

/** A label and what it names, in the inspector's two columns. Controls inside carry the name themselves. */
export function Row({ label, note, children }: { label: string; note?: string; children: ComponentChildren }) {
  return (
    <div class="row">
      <span class="row-label" aria-hidden="true">
        {label}
        {note && <small>{note}</small>}
      </span>
      {children}
    </div>
  );
}
