import "./perspective-view.css";
import { signal, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { BodyKind } from "../../stage/perspective/bodies";
import type { Perspective } from "../../stage/perspective/create-perspective";
import { showOf } from "../show-of";
import { useStudio } from "../studio";
import { openPerspective } from "./open-perspective";
import { PerspectivePill } from "./perspective-pill";

/** How the person likes agents to look, as long as the page is open; null until they say. */
const chosen = signal<BodyKind | null>(null);

/** The show in perspective, over the plan, and what steers it. */
export function PerspectiveView() {
  const studio = useStudio();
  const { view } = studio;
  const show = showOf(studio);
  // Who is in the air does not walk.
  const bodies = useComputed<BodyKind>(() => chosen.value ?? (show.value.isSpatial ? "cones" : "figures"));
  const place = useRef<HTMLDivElement>(null);
  const perspective = useRef<Perspective | null>(null);
  useEffect(() => {
    if (!place.current) return;
    const opened = openPerspective(place.current, studio, bodies);
    perspective.current = opened;
    view.lens.value = opened;
    place.current.focus({ preventScroll: true });
    return () => {
      view.lens.value = null;
      opened?.dispose();
    };
  }, [studio, view, bodies]);
  return (
    <>
      <div
        ref={place}
        class="perspective"
        role="application"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: keys turn it as dragging does
        tabIndex={0}
        aria-label="The show in perspective"
        aria-description="Arrows turn it, with Shift they move it, plus and minus zoom."
      />
      <PerspectivePill
        bodies={bodies.value}
        onBodies={(kind) => {
          chosen.value = kind;
        }}
        sitDown={() => perspective.current?.sitDown()}
      />
    </>
  );
}
