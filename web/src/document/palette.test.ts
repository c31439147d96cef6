import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { Formation } from "./formation";
import { AGENT_COLORS, UNGROUPED_COLOR } from "./palette";
import { agentColors, groupColor } from "./queries";
import type { Agent, Group, Scene } from "./scene";

function group(members: number[], color = "", children: Group[] = []): Group {
  return { name: "", color, members, tieWeight: null, children };
}

function scene(agents: Agent[], groups: Group[]): Scene {
  const positions = new Formation(new Float64Array(2 * agents.length));
  return {
    title: "",
    seed: 0,
    stage: { width: 100, depth: 60, height: 0, backdrop: "grid", units: "m" },
    tempo: { beatsPerMinute: 120, beatsPerBar: 4, start: 0 },
    frameRate: 30,
    minimumDistance: 0,
    join: "separate",
    tension: 0.5,
    groups,
    adjacency: { base: "delaunay", weights: "inverse", ties: [], cuts: [], obstacleTies: [] },
    tracks: [
      {
        agents,
        keyframes: [{ name: "", time: 0, hold: 0, corner: false, between: 0, positions, absent: [], adjacency: null }],
        segments: [],
      },
    ],
    obstacles: [],
  };
}

function agents(count: number): Agent[] {
  return Array.from({ length: count }, () => ({ name: "", color: "", radius: 0.25, maxSpeed: null }));
}

/** Place in the palette from 1; 0 for a color that is not in it. */
const number = (color: string | undefined) => (AGENT_COLORS as readonly string[]).indexOf(color ?? "") + 1;

describe("colors", () => {
  it("the stored palette is the light theme's", () => {
    const css = readFileSync(new URL("../theme/tokens.css", import.meta.url), "utf8");
    const light = css.slice(0, css.indexOf("[data-theme"));
    const tokens = Array.from(
      { length: 10 },
      (_, k) => new RegExp(`--agent-${k + 1}:\\s*(#[0-9a-f]{6})`).exec(light)?.[1],
    );
    expect(AGENT_COLORS).toEqual(tokens);
  });

  it("groups without a color take 1, 2, 3 in order, and agents without a group are 10", () => {
    const colors = agentColors(scene(agents(4), [group([0]), group([1]), group([2])]));
    expect(colors.map(number)).toEqual([1, 2, 3, 10]);
  });

  it("giving one group a color leaves the others' alone", () => {
    const colors = agentColors(scene(agents(3), [group([0], "#123456"), group([1]), group([2])]));
    expect(colors).toEqual(["#123456", AGENT_COLORS[1], AGENT_COLORS[2]]);
  });

  it("an agent's own color comes before its group's, and the innermost group's before the outer's", () => {
    const [first, ...others] = agents(3);
    const own: Agent[] = [{ name: "", radius: 0.25, maxSpeed: null, ...first, color: "#abcdef" }, ...others];
    const colors = agentColors(scene(own, [group([0, 1], "", [group([2])])]));
    expect(colors[0]).toBe("#abcdef");
    expect(number(colors[1])).toBe(1);
    expect(number(colors[2])).toBe(2);
  });

  it("the color of the ungrouped is never given to a group", () => {
    const many = scene(
      agents(25),
      Array.from({ length: 25 }, (_, k) => group([k])),
    );
    for (const color of agentColors(many)) expect(color).not.toBe(UNGROUPED_COLOR);
  });

  it("a group and its agents agree on its color", () => {
    const nested = scene(agents(4), [group([0], "", [group([1])]), group([2, 3])]);
    const colors = agentColors(nested);
    expect([groupColor(nested, [0]), groupColor(nested, [0, 0]), groupColor(nested, [1])]).toEqual(colors.slice(0, 3));
  });
});
