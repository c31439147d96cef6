import { isWithoutDistance } from "../queries";
import type { Command } from "../store";
import { setAllTransitions } from "./transitions";

/** Agents keep a distance everywhere on their way, meters; in a scene that names one already nothing changes. */
export function keepApart(minimumDistance: number): Command {
  return {
    label: "Keep apart",
    apply: (scene) =>
      isWithoutDistance(scene) ? setAllTransitions({ avoidance: true }).apply({ ...scene, minimumDistance }) : scene,
  };
}
