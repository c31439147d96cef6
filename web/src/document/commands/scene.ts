import { clipText, LIMITS, withinLimits } from "../limits";
import type { Join, Scene, Stage } from "../scene";
import type { Command } from "../store";

export function setTitle(title: string): Command {
  return { label: "Rename scene", apply: (scene) => patch(scene, { title: clipText(title.trim(), LIMITS.title) }) };
}

/** Sizes in meters; those that are not above zero are left as they were. */
export function setStage(change: Partial<Stage>): Command {
  return {
    label: "Change stage",
    apply: (scene) => {
      const stage = { ...scene.stage, ...change };
      const isSound = [stage.width, stage.depth].every((size) => size > 0 && size <= LIMITS.coordinate);
      const isSame = Object.entries(change).every(([key, value]) => scene.stage[key as keyof Stage] === value);
      return isSound && !isSame ? { ...scene, stage } : scene;
    },
  };
}

/** @param meters 0 for no limit */
export function setMinimumDistance(meters: number): Command {
  return {
    label: "Change minimum distance",
    apply: (scene) => (meters >= 0 && Number.isFinite(meters) ? patch(scene, { minimumDistance: meters }) : scene),
  };
}

/** How transitions meet at keyframes where nobody stops. */
export function setJoin(join: Join): Command {
  return { label: "Change join", apply: (scene) => patch(scene, { join }) };
}

/** @param tension 0 for no velocity at keyframes, 0.5 as from neighbor to neighbor, 1 for twice that */
export function setTension(tension: number): Command {
  return {
    label: "Change tension",
    apply: (scene) => (tension >= 0 && tension <= 1 ? patch(scene, { tension }) : scene),
  };
}

/** @param frameRate frames per second, 1–120 */
export function setFrameRate(frameRate: number): Command {
  return {
    label: "Change frame rate",
    apply: (scene) => {
      const { min, max } = LIMITS.frameRate;
      return frameRate >= min && frameRate <= max ? withinLimits(scene, patch(scene, { frameRate })) : scene;
    },
  };
}

export function setTempo(change: Partial<Scene["tempo"]>): Command {
  return {
    label: "Change tempo",
    apply: (scene) => {
      const tempo = { ...scene.tempo, ...change };
      const isSound = tempo.beatsPerMinute > 0 && tempo.beatsPerBar >= 1 && Number.isInteger(tempo.beatsPerBar);
      const isSame = Object.entries(change).every(([key, value]) => scene.tempo[key as keyof typeof tempo] === value);
      return isSound && !isSame && Number.isFinite(tempo.start) ? { ...scene, tempo } : scene;
    },
  };
}

function patch(scene: Scene, change: Partial<Scene>): Scene {
  const isSame = Object.entries(change).every(([key, value]) => scene[key as keyof Scene] === value);
  return isSame ? scene : { ...scene, ...change };
}
