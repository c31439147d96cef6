/** Up to here all modes are fetched and followed; beyond it the first of them: a person does not look at a thousand. */
export const ALL_UP_TO = 400;

/** Modes shown beyond it, the constant one included. */
export const FEW_MODES = 60;

/** Modes to ask for beside the constant one. */
export function modesToShow(agentCount: number): number {
  return agentCount <= ALL_UP_TO ? Math.max(0, agentCount - 1) : FEW_MODES - 1;
}
