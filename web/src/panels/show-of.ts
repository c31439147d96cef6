import { computed, type ReadonlySignal } from "@preact/signals";
import { mainTrack } from "../document/scene";
import { Show } from "../playback/show";
import { motionNow } from "../stage/subject";
import type { Seen } from "./seen";

const shows = new WeakMap<Seen, ReadonlySignal<Show>>();

/** The show as it is now, one for all panels; of what is seen, as it is drawn. */
export function showOf(studio: Seen): ReadonlySignal<Show> {
  let show = shows.get(studio);
  if (!show) {
    show = computed(() => {
      const scene = studio.document.scene.value;
      return new Show(mainTrack(scene), studio.planner.segments.value.map(motionNow), scene.join);
    });
    shows.set(studio, show);
  }
  return show;
}
