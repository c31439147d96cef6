import type { ComponentChildren } from "preact";

/** What is selected: its kind, its name, and at the right what matters most about it. */
export function Head(props: { kind: string; aside?: ComponentChildren; children: ComponentChildren }) {
  return (
    <header class="inspector-head">
      <p class="inspector-kind">
        <span>{props.kind}</span>
        {props.aside}
      </p>
      <h2>{props.children}</h2>
    </header>
  );
}
