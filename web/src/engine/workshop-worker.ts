import type { RecordingData } from "./api";
import init, { Engine } from "./pkg/workshop.js";
import type { OpenedMessage } from "./protocol";
import { basic, type Handlers, pause, post, serve, take } from "./serve";

/** An engine that answers what a first visit does not ask, too. */

/** Work that is asked for in slices goes on for about so many milliseconds at a time. */
const SLICE = 50;

/** The question that an errand is done for. */
let errand = 0;

const handlers: Handlers<Engine> = {
  ...basic,
  openAny: ({ text }, to) => JSON.parse(to.open_any(text)) as OpenedMessage,
  writeKeyframes: ({ scene }, to) => {
    take(scene, to);
    return JSON.parse(to.write_keyframes()) as { text: string; notes: string[] };
  },
  writeMotion: ({ scene, format }, to) => {
    take(scene, to);
    return to.write_motion(format);
  },
  openRecording: ({ text }, to) => {
    const head = JSON.parse(to.open_recording(text)) as Omit<RecordingData, "xy">;
    return { ...head, xy: to.recording_positions() };
  },
  assignment: ({ scene, segment, recipe, isFlipped, isPredicted, rest }, to, id) => {
    take(scene, to);
    to.begin_assignment(segment, JSON.stringify(recipe), isFlipped, isPredicted, rest === "stay");
    return finish(id, to);
  },
  affinity: ({ scene, keyframe, agents, metric, times }, to, id) => {
    take(scene, to);
    to.begin_affinity(keyframe, agents, metric, times);
    return finish(id, to);
  },
  comparison: ({ scene, segment, way, cost, pace }, to, id) => {
    take(scene, to);
    to.begin_comparison(segment, way, JSON.stringify({ cost }), pace ?? undefined);
    return finish(id, to);
  },
  modes: ({ scene, keyframe, most }, to) => {
    take(scene, to);
    return to.modes(keyframe, most);
  },
  modesBetween: ({ scene, segment, most, steps }, to) => {
    take(scene, to);
    const match = to.mode_match(segment, most);
    return { match, eigenvalues: steps > 0 ? to.eigenvalues_between(segment, steps) : new Float64Array(0) };
  },
  movement: ({ scene, segment }, to) => {
    take(scene, to);
    let progress = 0;
    while (progress < 1) progress = to.step(segment);
    return to.segment_movement();
  },
  salvage: ({ scene, segment }, to) => {
    if (scene) take(scene, to);
    const end = performance.now() + SLICE;
    let progress = 0;
    while (progress < 1 && performance.now() < end) progress = to.salvage(segment);
    return { progress, found: progress < 1 ? null : to.salvaged() };
  },
  proposeGroups: ({ scene, keyframe, agents, way }, to) => {
    take(scene, to);
    return to.propose_groups(keyframe, agents, way.kind, way.amount);
  },
  cancel: (ask, to) => {
    errand = 0;
    return basic.cancel(ask, to);
  },
};

/** Goes on with the errand that was begun, listening in between; null when another or a cancel took its place. */
async function finish(id: number, to: Engine): Promise<string | null> {
  errand = id;
  for (;;) {
    const progress = to.step_errand();
    if (progress >= 1) return to.errand_result();
    post({ kind: "progress", plan: id, segment: -1, progress });
    await pause();
    if (errand !== id) return null;
  }
}

serve(init, () => new Engine(), handlers);
