import { useLayoutEffect, useRef } from "preact/hooks";
import { placeBeside, type Side } from "./place-beside";

/** What became of a number, beside where it was set; over everything, so that no panel cuts it off. Read out elsewhere. */
export function Correction(props: { words: string; anchor: HTMLElement | null; side?: Side }) {
  const { words, anchor, side = "outside" } = props;
  const bubble = useRef<HTMLSpanElement>(null);

  useLayoutEffect(() => bubble.current?.showPopover(), []);

  useLayoutEffect(() => {
    const said = bubble.current;
    if (!said || !anchor) return;
    const row = anchor.closest(".row, .tool-options") ?? anchor;
    const settle = () => placeBeside(said, anchor, side, side === "outside" ? row : anchor);
    settle();
    addEventListener("scroll", settle, { capture: true, passive: true });
    return () => removeEventListener("scroll", settle, { capture: true });
  }, [words, anchor, side]);

  return (
    <span ref={bubble} class="correction" popover="manual" aria-hidden="true">
      {words}
    </span>
  );
}
