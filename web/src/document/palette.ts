/**
 * The agents' colors as a scene stores them, in the order they are given out; the last is for agents in no group.
 *
 * They are the light theme's tokens; the stage shows their partners in the dark.
 */
export const AGENT_COLORS = [
  "#c64f36",
  "#2d48cc",
  "#b98800",
  "#024b3b",
  "#e85fa8",
  "#1399e4",
  "#620687",
  "#07875b",
  "#4c5600",
  "#1d2a3a",
] as const;

/** Given to groups: all but the last. */
export const GROUP_COLORS: readonly string[] = AGENT_COLORS.slice(0, -1);
export const UNGROUPED_COLOR: string = AGENT_COLORS[9];
