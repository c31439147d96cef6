import { expect, test } from "vitest";
import { addAgents } from "../../document/commands/agents";
import { type Branch, takeProposal } from "../../document/commands/propose";
import { createDocument } from "../../document/create-store";
import { emptyScene } from "../../document/defaults";
import type { GroupingWay } from "../../engine/api";
import { createProposal, proposedWords } from "./proposal";

const leaf = (...members: number[]): Branch => ({ members, children: [] });
const inParts = (count: number): GroupingWay => ({ kind: "parts", amount: count });

/** Six agents; the engine answers when the test says so. */
function bench() {
  const places = Array.from({ length: 6 }, (_, agent) => [agent, 0] as const);
  const document = createDocument(addAgents(places).apply(emptyScene()));
  const answers: ((branches: readonly Branch[]) => void)[] = [];
  const proposal = createProposal({
    document,
    agentCount: 6,
    ask: () => new Promise((resolve) => answers.push(resolve)),
    command: (branches) => takeProposal([], branches),
    stop: () => {},
    announce: () => {},
    onProblem: () => {},
  });
  return { document, proposal, answers, settled: () => new Promise((resolve) => setTimeout(resolve, 0)) };
}

test("proposals show at once, and taking one over is one undo entry however many were looked at", async () => {
  const { document, proposal, answers, settled } = bench();
  const before = document.scene.value;
  proposal.show(inParts(2));
  answers[0]?.([leaf(0, 1, 2), leaf(3, 4, 5)]);
  await settled();
  expect(document.scene.value.groups).toHaveLength(2);
  proposal.show(inParts(3));
  answers[1]?.([leaf(0, 1), leaf(2, 3), leaf(4, 5)]);
  await settled();
  expect(proposal.words.value).toBe("3 groups");
  proposal.accept();
  expect(document.scene.value.groups).toHaveLength(3);
  document.undo();
  expect(document.scene.value).toBe(before);
});

test("Cancel leaves the identical scene, also when an answer comes late", async () => {
  const { document, proposal, answers, settled } = bench();
  const before = document.scene.value;
  proposal.show(inParts(2));
  proposal.cancel();
  answers[0]?.([leaf(0, 1, 2), leaf(3, 4, 5)]);
  await settled();
  expect(document.scene.value).toBe(before);
  expect(document.undoLabel.value).toBeNull();
});

test("of two questions the later counts, whichever is answered first", async () => {
  const { document, proposal, answers, settled } = bench();
  proposal.show(inParts(2));
  proposal.show(inParts(1));
  answers[1]?.([leaf(0, 1, 2, 3, 4, 5)]);
  answers[0]?.([leaf(0, 1, 2), leaf(3, 4, 5)]);
  await settled();
  expect(document.scene.value.groups).toHaveLength(1);
});

test("a proposal is said in words", () => {
  expect(proposedWords([], 6)).toBe("No groups");
  expect(proposedWords([leaf(0, 1, 2)], 6)).toBe("1 group, 3 agents in none");
  const halves: Branch = { members: [], children: [leaf(0), leaf(1, 2)] };
  expect(proposedWords([halves, leaf(3, 4, 5)], 6)).toBe("3 groups in 2");
});
