import { useSignalEffect } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { selectedRun } from "../../document/run";
import { mainTrack } from "../../document/scene";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { KeyframeList } from "./keyframe-list";
import { Playhead, TimeSlider } from "./playhead";
import { Ribbons } from "./ribbons";
import { RulerStrip } from "./ruler-strip";
import { Scrubber } from "./scrubber";
import type { TrackTouch } from "./track-touch";
import { Transport } from "./transport";
import { createViewport, type Viewport } from "./viewport";
import "./timeline.css";

const EmptySlot = lazily(() => import("./empty-slot").then((part) => part.EmptySlot));
const HoldHandle = lazily(() => import("./hold-handle").then((part) => part.HoldHandle));
const LoopBar = lazily(() => import("./loop-bar").then((part) => part.LoopBar));
const Overview = lazily(() => import("./overview").then((part) => part.Overview));

/** The show along time: what plays it, its keyframes and the transitions between them. */
export function Timeline() {
  const { document, playback } = useStudio();
  const viewport = useMemo(() => createViewport(document, playback), [document, playback]);
  const touch = useTouch(viewport);
  const window = useRef<HTMLDivElement>(null);
  const track = useRef<HTMLDivElement>(null);

  useLayoutEffect(() => {
    const element = window.current;
    if (!element) return;
    const measure = () => {
      viewport.width.value = element.clientWidth;
    };
    const observer = new ResizeObserver(measure);
    measure();
    observer.observe(element);
    return () => observer.disconnect();
  }, [viewport]);

  useSignalEffect(() => {
    if (track.current) track.current.style.transform = `translateX(${-viewport.scroll.value}px)`;
  });
  useFollow(viewport);

  const selection = document.selection.value;
  const isOneKeyframe = selection.kind === "keyframe" && selectedRun(selection) === null;
  const isSingle = mainTrack(document.scene.value).keyframes.length === 1;
  return (
    <section class="timeline" aria-label="Timeline">
      <Transport />
      <div
        ref={window}
        id="timeline-track"
        class="track-window"
        onPointerDown={(event) => {
          if (event.pointerType === "touch") touch.current?.down(event.pointerId, event.clientX);
        }}
        onPointerMove={(event) => {
          if (event.pointerType !== "touch") return;
          touch.current?.move(event.pointerId, event.clientX, event.currentTarget.getBoundingClientRect().left);
        }}
        onPointerUp={(event) => touch.current?.up(event.pointerId)}
        onPointerCancel={(event) => touch.current?.up(event.pointerId)}
        onClickCapture={(event) => {
          if (touch.current?.takesClick()) event.stopPropagation();
        }}
        onWheel={(event) => {
          event.preventDefault();
          const left = event.currentTarget.getBoundingClientRect().left;
          if (event.ctrlKey || event.metaKey) viewport.zoomBy(Math.exp(-event.deltaY / 300), event.clientX - left);
          else viewport.scrollTo(viewport.scroll.peek() + event.deltaX + event.deltaY);
        }}
      >
        <Scrubber viewport={viewport} />
        <div ref={track} class="track">
          <RulerStrip viewport={viewport} />
          {playback.range.value && <LoopBar viewport={viewport} />}
          <Ribbons viewport={viewport} />
          <KeyframeList viewport={viewport} />
          {isOneKeyframe && <HoldHandle viewport={viewport} />}
          {isSingle && <EmptySlot viewport={viewport} />}
          <TimeSlider />
          <Playhead viewport={viewport} />
        </div>
        {viewport.isCut.value && <Overview viewport={viewport} />}
      </div>
    </section>
  );
}

/** Fingers on the track, once the page is drawn. */
function useTouch(viewport: Viewport): RefObject<TrackTouch> {
  const touch = useRef<TrackTouch>(null);
  useEffect(() => {
    import("./track-touch").then(
      (part) => {
        touch.current = new part.TrackTouch(viewport);
      },
      // Without it the overview still leads everywhere.
      () => {},
    );
  }, [viewport]);
  return touch;
}

/** Turns the page when the playhead plays out of sight; whoever has scrolled elsewhere is left there. */
function useFollow(viewport: Viewport): void {
  const { playback } = useStudio();
  const wasSeen = useRef(true);
  useEffect(
    () =>
      playback.follow((time) => {
        if (playback.isPlaying.value && wasSeen.current && !viewport.isSeen(time)) viewport.reveal(time);
        wasSeen.current = viewport.isSeen(time);
      }),
    [playback, viewport],
  );
}
