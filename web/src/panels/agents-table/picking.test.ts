import { expect, test } from "vitest";
import { pick } from "./picking";
import type { TableRow } from "./table-rows";

const heading = (path: number[] | null): TableRow => ({
  kind: "heading",
  path,
  label: "",
  color: "",
  agentCount: 2,
  tieWeight: null,
});
const agent = (index: number): TableRow => ({ kind: "agent", agent: index, path: null });
const rows = [heading([0]), agent(4), agent(7), heading(null), agent(1), agent(2)];

test("a row alone replaces what was selected", () => {
  expect(pick(rows, new Set([1, 2]), 1, 0, "only")).toEqual({ kind: "agents", agents: new Set([4]) });
});

test("a toggled row joins or leaves, and the last to leave leaves nothing", () => {
  expect(pick(rows, new Set([4]), 2, 1, "toggle")).toEqual({ kind: "agents", agents: new Set([4, 7]) });
  expect(pick(rows, new Set([4]), 1, 1, "toggle")).toEqual({ kind: "none" });
});

test("a range takes the agents between, in either direction and across headings", () => {
  const between = { kind: "agents", agents: new Set([7, 1]) };
  expect(pick(rows, new Set(), 4, 2, "range")).toEqual(between);
  expect(pick(rows, new Set(), 2, 4, "range")).toEqual(between);
});

test("a group's heading selects the group, that of the ungrouped its agents", () => {
  expect(pick(rows, new Set(), 0, 0, "only")).toEqual({ kind: "group", path: [0] });
  expect(pick(rows, new Set(), 3, 0, "only")).toEqual({ kind: "agents", agents: new Set([1, 2]) });
});
