import { useRef, useState } from "preact/hooks";

/** How an edit of a cell ends, and where the person goes from there: out of the table, or to a cell. */
export type EditEnd = "leave" | "stay" | "down" | "right" | "left";

/** A cell while it is typed into. */
export function CellEditor(props: {
  label: string;
  text: string;
  /** The text is what the person began to type, so typing goes on after it instead of replacing it. */
  isBegun: boolean;
  isNumber: boolean;
  /** Whether the text can be taken over. */
  accepts(text: string): boolean;
  onEnd(text: string | null, end: EditEnd): void;
}) {
  const [text, setText] = useState(props.text);
  const isOver = useRef(false);
  function end(taken: string | null, way: EditEnd): void {
    if (isOver.current) return;
    isOver.current = true;
    props.onEnd(taken !== null && props.accepts(taken) ? taken : null, way);
  }
  return (
    <input
      class="cell-editor"
      ref={(input) => {
        if (input && input.ownerDocument.activeElement !== input) {
          input.focus();
          if (props.isBegun) input.setSelectionRange(props.text.length, props.text.length);
          else input.select();
        }
      }}
      aria-label={props.label}
      aria-invalid={!props.accepts(text)}
      inputMode={props.isNumber ? "decimal" : "text"}
      autocomplete="off"
      spellcheck={false}
      value={text}
      onInput={(event) => setText(event.currentTarget.value)}
      onBlur={() => end(text, "leave")}
      onPointerDown={(event) => event.stopPropagation()}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") end(text, "down");
        else if (event.key === "Escape") end(null, "stay");
        else if (event.key === "Tab") end(text, event.shiftKey ? "left" : "right");
        else return;
        event.preventDefault();
      }}
    />
  );
}
