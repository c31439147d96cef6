import type { IconNode } from "lucide";
import { h } from "preact";

/** A line icon in the text's color; decoration, so the control around it carries the name. */
export function Icon({ node, size = 16 }: { node: IconNode; size?: 14 | 16 | 18 }) {
  return (
    <svg
      class="icon"
      viewBox="0 0 24 24"
      width={size}
      height={size}
      aria-hidden="true"
      data-size={size === 16 ? undefined : size}
    >
      {node.map(([tag, attributes]) => h(tag, attributes))}
    </svg>
  );
}
