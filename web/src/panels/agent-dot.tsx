import { AGENT_COLORS } from "../document/palette";

/** A disc in an agent's or a group's stored color, shown as its partner in the dark. */
export function AgentDot({ color }: { color: string }) {
  const palette: readonly string[] = AGENT_COLORS;
  const place = palette.indexOf(color.toLowerCase());
  if (place >= 0) return <span class={`dot agent-${place + 1}`} />;
  return <span class="dot" style={{ color }} />;
}
