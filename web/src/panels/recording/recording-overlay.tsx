import { computed, effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Formation } from "../../document/formation";
import { UNGROUPED_COLOR } from "../../document/palette";
import { mainTrack } from "../../document/scene";
import type { Recording } from "../../engine/recording";
import { createLoop } from "../../stage/loop";
import { neighborSpacing } from "../../stage/spacing";
import { fitCanvas } from "../fit-canvas";
import { useStudio } from "../studio";
import { useAgentColors, usePalette } from "../timeline/use-paint";
import { drawRecording } from "./draw-recording";
import { presentInAll, shiftOf } from "./picks";
import { isOriginalShown, isWalked, type OpenRecording, opened, recorded } from "./state";

/** How much of the show shows through while frames are picked. */
const VEIL = 0.96;
/** How firm the original is beside the motion made from it. */
const FAINT = 0.4;
/** How large its discs are there, so that they are not taken for where the motion comes from. */
const SMALL = 0.6;

/** The recording over the stage: by itself while frames are picked, faint beside the motion that was made from it. */
export function RecordingOverlay() {
  const { document, view, playback } = useStudio();
  const canvas = useRef<HTMLCanvasElement>(null);
  const palette = usePalette();
  const stored = useAgentColors();
  useRecordedTime();
  useEffect(() => {
    const colors = computed(() => colorsOf(opened.value, stored.value).map((color) => palette.shown(color)));
    const agentCount = computed(() => mainTrack(document.scene.value).agents.length);
    // Another scene than the one made from it has other agents.
    const isBeside = computed(() => isOriginalShown.value && takenOf(opened.value).length === agentCount.value);
    return effect(() => {
      const [camera, size, now] = [view.camera.value, view.size.value, opened.value];
      const context = canvas.current && fitCanvas(canvas.current, size);
      if (!context || !now) return;
      context.clearRect(0, 0, size.width, size.height);
      const made = isWalked.value ? null : now.made;
      if (made && !isBeside.value) return;
      if (!made) {
        context.globalAlpha = VEIL;
        context.fillStyle = palette.sheet;
        context.fillRect(0, 0, size.width, size.height);
      }
      const time = made ? now.recording.timeOf(made[0] ?? 0) + playback.time.value : recorded.time.value;
      drawRecording(context, now.recording, time, {
        camera,
        palette,
        shift: shiftOf(now.recording),
        colors: colors.value,
        strength: made ? FAINT : 1,
        size: made ? SMALL : 1,
        spacing: spacingOf(now.recording),
      });
    });
  }, [document, view, playback, palette, stored]);
  return (
    <div aria-hidden="true">
      <canvas ref={canvas} class="stage-canvas" />
    </div>
  );
}

/** The recording's own time goes on by itself, apart from the show's. */
function useRecordedTime(): void {
  useEffect(() => {
    const loop = createLoop((elapsed) => {
      recorded.tick(elapsed);
      return recorded.isPlaying.peek();
    }, globalThis);
    const stop = effect(() => {
      if (recorded.isPlaying.value) loop.invalidate();
    });
    return () => {
      stop();
      loop.stop();
      recorded.pause();
    };
  }, []);
}

/** The recorded agents that the scene made from it has, in its order. */
function takenOf(now: OpenRecording | null): number[] {
  return now?.made ? presentInAll(now.recording, now.made) : [];
}

/** Stored colors by recorded agent: those that the scene made from it has given them. */
function colorsOf(now: OpenRecording | null, scene: readonly string[]): string[] {
  const colors = new Array<string>(now?.recording.agentCount ?? 0).fill(UNGROUPED_COLOR);
  for (const [index, agent] of takenOf(now).entries()) colors[agent] = scene[index] ?? UNGROUPED_COLOR;
  return colors;
}

const spacings = new WeakMap<Recording, number>();

/** Meters between neighbors in the middle of the recording: one size for all of it. */
function spacingOf(recording: Recording): number {
  let spacing = spacings.get(recording);
  if (spacing === undefined) {
    const frame = recording.frameCount >> 1;
    const agents = presentInAll(recording, [frame]);
    spacing = neighborSpacing(Formation.from(agents.map((agent) => recording.place(frame, agent))));
    spacings.set(recording, spacing);
  }
  return spacing;
}
