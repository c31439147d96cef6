import { useSignal } from "@preact/signals";
import { takeProposal } from "../../document/commands/propose";
import { groupAt, groupSet } from "../../document/groups";
import { allAgents } from "../../document/queries";
import type { GroupPath } from "../../document/scene";
import { useStudio } from "../studio";
import { createProposal, type Proposal } from "./proposal";
import { ProposalPreview } from "./proposal-preview";
import { Section } from "./section";

/** So many times the median likeness at the few end of the scale, and a so-manieth at the other. */
const MUCH = 100;

/** Groups found by the engine: for everybody, or within a group. */
export function ProposeGroups({ inside }: { inside: GroupPath }) {
  const { document, engine, messages, playback } = useStudio();
  const proposal = useSignal<Proposal | null>(null);
  const scene = document.scene.value;
  const group = groupAt(scene.groups, inside);
  const agents = group ? groupSet(group) : allAgents(scene);

  function open(): void {
    playback.pause();
    const keyframe = document.activeKeyframe.peek();
    const members = Uint32Array.from(agents);
    proposal.value = createProposal({
      document,
      agentCount: agents.size,
      ask: (at, way, tell) =>
        way.kind === "alike"
          ? engine.findAlike(at, { keyframe, agents: members, metric: way.metric, times: MUCH ** -way.amount }, tell)
          : engine.proposeGroups(at, keyframe, members, way),
      stop: engine.stopErrand,
      command: (branches) => takeProposal(inside, branches),
      announce: messages.announce,
      onProblem(error) {
        const text = error instanceof Error ? error.message : String(error);
        messages.say({ tone: "problem", title: "No groups were proposed.", text });
      },
    });
  }

  if (agents.size < 2) return null;
  return (
    <Section>
      {proposal.value ? (
        <ProposalPreview
          proposal={proposal.value}
          onClose={() => {
            proposal.value = null;
          }}
        />
      ) : (
        <button type="button" class="button" onClick={open}>
          Propose groups
        </button>
      )}
    </Section>
  );
}
