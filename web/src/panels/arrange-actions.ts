import { computed } from "@preact/signals";
import { boxOf, centerOf } from "../document/box";
import { dissolveGroup, makeGroup, setGroupTieWeight } from "../document/commands/groups";
import { addTie, DRAWN_TIE_FACTOR, WHOLE_SCENE } from "../document/commands/ties";
import { alignAgents, distributeAgents, type Edge, flipAgents, rotateAgents } from "../document/commands/transform";
import { groupWithSet } from "../document/group-with-set";
import { agentLabel, groupLabel, selectedAgents } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { Command } from "../document/store";
import { type ActionParts, type Doing, type Doings, here, performOrSay } from "./doing";

export type ArrangeId =
  | `align-${Edge}`
  | "distribute-horizontally"
  | "distribute-vertically"
  | "flip-horizontal"
  | "flip-vertical"
  | "rotate-left"
  | "rotate-right"
  | "make-group"
  | "dissolve-group"
  | "tie-selected"
  | "tie-group";

const TURN = Math.PI / 12;

/** What is done to the selected agents together. */
export function arrangeActions(parts: ActionParts): Doings<ArrangeId> {
  const { document, messages } = parts;

  const count = computed(() => {
    const selection = document.selection.value;
    return selection.kind === "tie" ? 0 : selectedAgents(document.scene.value, selection).size;
  });

  function arrange(least: number, command: (keyframe: number, agents: ReadonlySet<number>) => Command): Doing {
    return {
      isEnabled: computed(() => count.value >= least),
      run() {
        const { scene, selection, keyframe } = here(document);
        document.perform(command(keyframe, selectedAgents(scene, selection)));
      },
    };
  }

  const align = (edge: Edge) => arrange(2, (keyframe, agents) => alignAgents(keyframe, agents, edge));

  const rotate = (angle: number) =>
    arrange(2, (keyframe, agents) => ({
      label: "Rotate agents",
      apply(scene) {
        const positions = mainTrack(scene).keyframes[keyframe]?.positions;
        const box = positions && boxOf(positions, agents);
        return box ? rotateAgents(keyframe, agents, centerOf(box), angle).apply(scene) : scene;
      },
    }));

  return {
    "align-left": align("left"),
    "align-center": align("center"),
    "align-right": align("right"),
    "align-top": align("top"),
    "align-middle": align("middle"),
    "align-bottom": align("bottom"),
    "distribute-horizontally": arrange(3, (keyframe, agents) => distributeAgents(keyframe, agents, "x")),
    "distribute-vertically": arrange(3, (keyframe, agents) => distributeAgents(keyframe, agents, "y")),
    "flip-horizontal": arrange(2, (keyframe, agents) => flipAgents(keyframe, agents, "horizontal")),
    "flip-vertical": arrange(2, (keyframe, agents) => flipAgents(keyframe, agents, "vertical")),
    "rotate-left": rotate(TURN),
    "rotate-right": rotate(-TURN),
    "make-group": {
      isEnabled: computed(() => count.value > 0 && document.selection.value.kind !== "group"),
      run() {
        const { scene, selection } = here(document);
        const agents = selectedAgents(scene, selection);
        const existing = groupWithSet(scene.groups, agents);
        if (!existing) {
          const whyNot = "A scene has at most 1,000 groups, 8 deep.";
          if (!performOrSay(parts, makeGroup(agents), whyNot)) return;
        }
        const path = groupWithSet(document.scene.peek().groups, agents);
        if (!path) return;
        document.selection.value = { kind: "group", path };
        const name = groupLabel(document.scene.peek(), path);
        messages.announce(existing ? `They are ${name} already` : `${name} made of ${agents.size} agents`);
      },
    },
    "dissolve-group": {
      isEnabled: computed(() => document.selection.value.kind === "group"),
      run() {
        const { scene, selection } = here(document);
        if (selection.kind !== "group") return;
        const agents = selectedAgents(scene, selection);
        document.perform(dissolveGroup(selection.path));
        document.selection.value = { kind: "agents", agents };
        messages.announce("Group dissolved");
      },
    },
    "tie-selected": {
      isEnabled: computed(() => count.value === 2),
      run() {
        const { scene, selection, keyframe } = here(document);
        const [a, b] = selectedAgents(scene, selection);
        if (a === undefined || b === undefined) return;
        const isEverywhere = parts.toolbox.tieScope.peek() === "scene";
        document.perform(addTie(isEverywhere ? WHOLE_SCENE : { kind: "keyframe", index: keyframe }, a, b));
        document.selection.value = { kind: "tie", a: Math.min(a, b), b: Math.max(a, b) };
        messages.announce(`${agentLabel(scene, a)} tied to ${agentLabel(scene, b)}`);
      },
    },
    "tie-group": {
      isEnabled: computed(() => document.selection.value.kind === "group"),
      run() {
        const { selection } = here(document);
        if (selection.kind === "group") document.perform(setGroupTieWeight(selection.path, DRAWN_TIE_FACTOR));
      },
    },
  };
}
