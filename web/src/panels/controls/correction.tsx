import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { placeBeside } from "./place-beside";

/** What became of a number, below where it was set; over everything, so that no panel cuts it off. Read out elsewhere. */
export function Correction({ words, anchor }: { words: string; anchor: RefObject<HTMLElement> }) {
  const bubble = useRef<HTMLSpanElement>(null);

  useLayoutEffect(() => bubble.current?.showPopover(), []);

  useLayoutEffect(() => {
    const [said, place] = [bubble.current, anchor.current];
    if (!said || !place) return;
    const settle = () => placeBeside(said, place, "below-end");
    settle();
    addEventListener("scroll", settle, { capture: true, passive: true });
    return () => removeEventListener("scroll", settle, { capture: true });
  }, [words, anchor]);

  return (
    <span ref={bubble} class="correction" popover="manual" aria-hidden="true">
      {words}
    </span>
  );
}
