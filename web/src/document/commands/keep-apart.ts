import { mainTrack, type Scene } from "../scene";
import type { Command } from "../store";
import { setAllTransitions } from "./transitions";

/** Whether nothing is asked of a motion but the formations: no distance, so that nobody is warned of a meeting. */
export function asksNoDistance(scene: Scene): boolean {
  return scene.minimumDistance === 0 && mainTrack(scene).segments.length > 0;
}

/** Agents keep a distance everywhere on their way, meters; in a scene that names one already nothing changes. */
export function keepApart(minimumDistance: number): Command {
  return {
    label: "Keep apart",
    apply: (scene) =>
      asksNoDistance(scene) ? setAllTransitions({ avoidance: true }).apply({ ...scene, minimumDistance }) : scene,
  };
}
