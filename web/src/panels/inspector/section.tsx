import type { ComponentChildren } from "preact";

/** A part of the inspector, parted from the one above by a line. */
export function Section(props: {
  title?: string;
  note?: string;
  isRegion?: boolean;
  isFormer?: boolean;
  children: ComponentChildren;
}) {
  const look = props.isFormer ? "inspector-section is-former" : "inspector-section";
  const heading = props.title !== undefined && (
    <h3>
      {props.title} {props.note && <span>{props.note}</span>}
    </h3>
  );
  if (props.isRegion && props.title !== undefined) {
    return (
      <section class={look} aria-label={props.title}>
        {heading}
        {props.children}
      </section>
    );
  }
  return (
    <div class={look}>
      {heading}
      {props.children}
    </div>
  );
}
