/** How a way's curves look: one of the agents' colors, from 1, and its dashes. */
export interface Line {
  readonly color: number;
  readonly dash: readonly number[];
}

const WIDTH = 24;

/** A short stretch of a curve, for a legend. */
export function LineSample({ line }: { line: Line }) {
  return (
    <svg class="line-sample" viewBox={`0 0 ${WIDTH} 8`} width={WIDTH} height="8" aria-hidden="true">
      <path
        d={`M0 4H${WIDTH}`}
        style={{ stroke: `var(--agent-${line.color})` }}
        stroke-dasharray={line.dash.join(" ") || undefined}
      />
    </svg>
  );
}
