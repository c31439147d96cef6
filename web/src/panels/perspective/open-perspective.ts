import type { ReadonlySignal } from "@preact/signals";
import { selectedAgents } from "../../document/queries";
import { toggled } from "../../document/sets";
import type { BodyKind } from "../../stage/perspective/bodies";
import {
  createPerspective,
  type Perspective,
  type Picked,
  type PickWay,
} from "../../stage/perspective/create-perspective";
import { NoGraphics } from "../../stage/perspective/device";
import { agentSelection } from "../../tools/tool";
import type { Studio } from "../studio";
import { isMac } from "../use-action";

/** The perspective view in `place`; null where the browser has none, which is said and leaves the plan. */
export function openPerspective(
  place: HTMLElement,
  studio: Studio,
  bodies: ReadonlySignal<BodyKind>,
): Perspective | null {
  const { document, playback, planner, view, messages } = studio;

  function backToPlan(title: string, text: string): void {
    view.projection.value = "plan";
    messages.say({ tone: "problem", title, text });
  }

  function pick(picked: Picked, way: PickWay): void {
    const { scene, selection } = document;
    if (picked.kind === "obstacle" && way === "replace") {
      selection.value = picked;
      return;
    }
    const before = selectedAgents(scene.peek(), selection.peek());
    const agents = new Set(picked.kind === "agent" ? [picked.agent] : []);
    if (way === "replace") selection.value = agentSelection(agents);
    else if (way === "add") selection.value = agentSelection(new Set([...before, ...agents]));
    else selection.value = agentSelection(toggled(before, agents));
  }

  try {
    return createPerspective(place, {
      scene: document.scene,
      selection: document.selection,
      segments: planner.segments,
      ties: planner.ties,
      playback,
      view,
      bodies,
      isMac,
      onPick: pick,
      onLost: () => backToPlan("The graphics device went away.", "The plan shows instead; open the perspective again."),
    });
  } catch (error) {
    if (!(error instanceof NoGraphics)) throw error;
    backToPlan("This browser does not draw in perspective.", "It has no WebGL 2, or it is turned off; the plan stays.");
    return null;
  }
}
