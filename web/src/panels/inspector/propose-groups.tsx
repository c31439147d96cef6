import { useSignal } from "@preact/signals";
import { groupAt, groupSet } from "../../document/groups";
import { type GroupPath, mainTrack } from "../../document/scene";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { Section } from "./section";

const Proposing = lazily(() => import("./proposing").then((part) => part.Proposing));

/** Groups found by the engine: for everybody, or within a group. */
export function ProposeGroups({ inside }: { inside: GroupPath }) {
  const { document, playback } = useStudio();
  const isOpen = useSignal(false);
  const scene = document.scene.value;
  const group = groupAt(scene.groups, inside);
  const agentCount = group ? groupSet(group).size : mainTrack(scene).agents.length;

  if (agentCount < 2) return null;
  return (
    <Section>
      {isOpen.value ? (
        <Proposing
          inside={inside}
          onClose={() => {
            isOpen.value = false;
          }}
        />
      ) : (
        <button
          type="button"
          class="button"
          onClick={() => {
            playback.pause();
            isOpen.value = true;
          }}
        >
          Propose groups
        </button>
      )}
    </Section>
  );
}
