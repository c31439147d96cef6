import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { takeProposal } from "../../document/commands/propose";
import { groupAt, groupSet } from "../../document/groups";
import { allAgents } from "../../document/queries";
import type { GroupPath } from "../../document/scene";
import { type Studio, useStudio } from "../studio";
import { createProposal, type Proposal } from "./proposal";
import { ProposalPreview } from "./proposal-preview";

/** So many times the median likeness at the few end of the scale, and a so-manieth at the other. */
const MUCH = 100;

/** Groups being found by the engine, until they are taken or left. */
export function Proposing({ inside, onClose }: { inside: GroupPath; onClose: () => void }) {
  const studio = useStudio();
  const proposal = useSignal<Proposal | null>(null);
  useEffect(() => {
    proposal.value = propose(studio, inside);
  }, []);
  return proposal.value && <ProposalPreview proposal={proposal.value} onClose={onClose} />;
}

function propose({ document, engine, messages }: Studio, inside: GroupPath): Proposal {
  const scene = document.scene.peek();
  const group = groupAt(scene.groups, inside);
  const agents = group ? groupSet(group) : allAgents(scene);
  const keyframe = document.activeKeyframe.peek();
  const members = Uint32Array.from(agents);
  return createProposal({
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
