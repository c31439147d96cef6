import { useRef } from "preact/hooks";
import { mainTrack } from "../../document/scene";
import { useStudio } from "../studio";
import { placed } from "./place";
import { xOf } from "./scale";
import { transitionState } from "./transition-state";
import type { Viewport } from "./viewport";

const MARGIN = 12;

/** The whole show in five pixels when not everything fits: where the keyframes are, where it clashes, what is seen. */
export function Overview({ viewport }: { viewport: Viewport }) {
  const { document, planner } = useStudio();
  const strip = useRef<HTMLDivElement>(null);
  const whole = viewport.trackWidth.value;
  const width = viewport.width.value;
  const scene = document.scene.value;
  const factor = (width - 2 * MARGIN) / whole;
  const furthest = whole - width;

  const follow = (clientX: number) => {
    const left = strip.current?.getBoundingClientRect().left ?? 0;
    viewport.scrollTo((clientX - left) / factor - width / 2);
  };

  return (
    <div
      ref={strip}
      class="overview"
      role="scrollbar"
      aria-label="Part of the timeline seen"
      aria-controls="timeline-track"
      aria-orientation="horizontal"
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round((viewport.scroll.value / furthest) * 100)}
      tabIndex={0}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        follow(event.clientX);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) follow(event.clientX);
      }}
      onKeyDown={(event) => {
        const by = { ArrowLeft: -80, ArrowRight: 80, PageUp: -width, PageDown: width, Home: -whole, End: whole }[
          event.key
        ];
        if (by === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        viewport.scrollTo(viewport.scroll.peek() + by);
      }}
    >
      <i ref={placed(viewport.scroll.value * factor, width * factor)} class="overview-window" />
      {mainTrack(scene).keyframes.map((keyframe, index) => {
        const isClash = transitionState(planner.segments.value[index], scene.minimumDistance).status === "clash";
        const x = xOf(viewport.scale.value, keyframe.time) * factor;
        return <i key={index} ref={placed(x)} class={isClash ? "overview-keyframe is-clash" : "overview-keyframe"} />;
      })}
    </div>
  );
}
