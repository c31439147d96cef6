import { computed } from "@preact/signals";
import { deleteAgents, duplicateAgents, moveAgents } from "../document/commands/agents";
import { dissolveGroup } from "../document/commands/groups";
import { liftAgents } from "../document/commands/heights";
import { deleteKeyframe } from "../document/commands/keyframes";
import { deleteObstacle } from "../document/commands/obstacles";
import { cutTie, WHOLE_SCENE } from "../document/commands/ties";
import type { Point } from "../document/formation";
import { mostAgents } from "../document/limits";
import { selectedAgents } from "../document/queries";
import { mainTrack } from "../document/scene";
import { NOTHING } from "../document/selection";
import { nudgeSteps } from "../document/snap";
import { formatCount, lengthWithUnit } from "../document/units";
import { type ActionParts, type Doing, type Doings, here } from "./doing";

export type EditId =
  | "duplicate"
  | "delete"
  | `${"nudge" | "push"}-${"left" | "right" | "up" | "down" | "higher" | "lower"}`;

/** What is done to whatever is selected. */
export function editActions(parts: ActionParts): Doings<EditId> {
  const { document, messages } = parts;
  const hasSelected = computed(() => selectedAgents(document.scene.value, document.selection.value).size > 0);
  const movesAgents = computed(() => hasSelected.value && document.selection.value.kind !== "tie");

  function nudge(toward: Point, reach: "near" | "far"): Doing {
    return {
      isEnabled: movesAgents,
      run() {
        const { scene, selection, keyframe } = here(document);
        const agents = selectedAgents(scene, selection);
        const step = nudgeSteps(scene)[reach];
        const by: Point = [toward[0] * step, toward[1] * step];
        // Presses on the same agents are one undo entry: nobody undoes a walk step by step.
        const series = `nudge ${keyframe} ${[...agents].join()}`;
        document.perform({ ...moveAgents(keyframe, agents, by, "Nudge agents"), series });
      },
    };
  }

  function lift(sign: 1 | -1, reach: "near" | "far"): Doing {
    return {
      isEnabled: movesAgents,
      run() {
        const { scene, selection, keyframe } = here(document);
        const agents = selectedAgents(scene, selection);
        const by = sign * nudgeSteps(scene)[reach];
        const series = `lift ${keyframe} ${[...agents].join()}`;
        document.perform({ ...liftAgents(keyframe, agents, by), series });
        const lifted = mainTrack(document.scene.peek()).keyframes[keyframe]?.positions;
        const highest = Math.max(...[...agents].map((agent) => lifted?.height(agent) ?? 0));
        messages.announce(`Height ${lengthWithUnit(highest, scene.stage.units)}`);
      },
    };
  }

  return {
    duplicate: {
      isEnabled: movesAgents,
      run() {
        const { scene, selection } = here(document);
        const agents = selectedAgents(scene, selection);
        const first = mainTrack(scene).agents.length;
        const { far } = nudgeSteps(scene);
        if (first + agents.size > mostAgents(scene)) {
          const text = `This show has room for ${formatCount(mostAgents(scene))} agents.`;
          messages.say({ tone: "problem", title: "The agents were not duplicated.", text });
          return;
        }
        document.perform(duplicateAgents(agents, [far, -far]));
        const copies = Array.from({ length: agents.size }, (_, i) => first + i);
        document.selection.value = { kind: "agents", agents: new Set(copies) };
      },
    },
    delete: {
      isEnabled: computed(() => {
        const { kind } = document.selection.value;
        const isOnlyKeyframe = kind === "keyframe" && mainTrack(document.scene.value).keyframes.length === 1;
        return kind !== "none" && kind !== "transition" && !isOnlyKeyframe;
      }),
      run: () => deleteSelected(parts),
    },
    "nudge-left": nudge([-1, 0], "near"),
    "nudge-right": nudge([1, 0], "near"),
    "nudge-up": nudge([0, 1], "near"),
    "nudge-down": nudge([0, -1], "near"),
    "push-left": nudge([-1, 0], "far"),
    "push-right": nudge([1, 0], "far"),
    "push-up": nudge([0, 1], "far"),
    "push-down": nudge([0, -1], "far"),
    "nudge-higher": lift(1, "near"),
    "nudge-lower": lift(-1, "near"),
    "push-higher": lift(1, "far"),
    "push-lower": lift(-1, "far"),
  };
}

/** Agents go from every keyframe, a tie is cut, a group is dissolved: its agents stay. */
function deleteSelected({ document, messages }: ActionParts): void {
  const { scene, selection } = here(document);
  switch (selection.kind) {
    case "agents":
      document.perform(deleteAgents(selection.agents));
      document.selection.value = NOTHING;
      messages.announce(`${selection.agents.size} agents deleted from every keyframe`);
      return;
    case "tie":
      document.perform(cutTie(WHOLE_SCENE, selection.a, selection.b));
      document.selection.value = NOTHING;
      messages.announce("Tie cut");
      return;
    case "group":
      document.perform(dissolveGroup(selection.path));
      messages.announce("Group dissolved");
      return;
    case "obstacle":
      document.perform(deleteObstacle(selection.index));
      document.selection.value = NOTHING;
      messages.announce("Obstacle deleted");
      return;
    case "keyframe":
      if (mainTrack(scene).keyframes.length > 1) document.perform(deleteKeyframe(selection.index));
      return;
    default:
  }
}
