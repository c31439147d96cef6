import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { mainTrack } from "../../document/scene";
import { momentAt } from "../../document/timing";
import { showOf } from "../show-of";
import { useStudio } from "../studio";

/** Nobody reads numbers that change faster; milliseconds. */
const READABLE = 100;

/** Where everybody is at the playhead, x and y an agent in meters; while playing, ten times a second. */
export function useLivePlaces(): ReadonlySignal<ArrayLike<number>> {
  const studio = useStudio();
  const { document, playback } = studio;
  const places = useSignal<ArrayLike<number>>([]);
  const last = useRef(Number.NEGATIVE_INFINITY);
  useSignalEffect(() => {
    const show = showOf(studio).value;
    const scene = document.scene.value;
    const time = playback.time.value;
    const now = performance.now();
    if (playback.isPlaying.value && now - last.current < READABLE) return;
    last.current = now;
    const moment = momentAt(scene, time);
    if (moment.kind === "standing") {
      places.value = mainTrack(scene).keyframes[moment.keyframe]?.positions.xy ?? [];
      return;
    }
    const xy = new Float32Array(show.agentCount * 2);
    show.positionsInto(time, xy);
    places.value = xy;
  });
  return places;
}
