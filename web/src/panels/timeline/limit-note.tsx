import { useEffect } from "preact/hooks";
import { Correction } from "../controls/correction";
import { asNear } from "../controls/quantity";
import { useStudio } from "../studio";

/** Where a drag was stopped although it was pulled further, said and shown at what is dragged. */
export function LimitNote({ what, stop, anchor }: { what: string; stop: string; anchor: HTMLElement | null }) {
  const { messages } = useStudio();
  const words = asNear(stop);
  useEffect(() => messages.announce(`${what}: ${words}`), [what, words]);
  return <Correction words={words} anchor={anchor} side="above" />;
}
