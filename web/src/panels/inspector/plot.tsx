import { PlotNow } from "../plot-now";
import { areaPath, belowPath, curvePath, type PlotFrame, plotY } from "./plot-path";

const WIDTH = 110;
const HEIGHT = 26;
/** Room for the line's own width at the top and bottom. */
const MARGIN = 3;

/**
 * A measure over a transition's time, with the playhead. A limit is dashed, and the curve below it stands out.
 *
 * @param props.least the upper edge stands for this at least, so that round-off is not drawn as mountains
 */
export function Plot(props: { values: Float32Array; from: number; to: number; limit?: number; least?: number }) {
  const { values, from, to, limit } = props;
  const top = Math.max(maximum(values), limit === undefined ? 0 : limit * 1.5, props.least ?? 0, 1e-9);
  const frame: PlotFrame = { width: WIDTH, height: HEIGHT - 2 * MARGIN, low: 0, high: top };
  const isBroken = limit !== undefined && values.some((value) => value < limit);
  return (
    <svg class="plot" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} preserveAspectRatio="none" aria-hidden="true">
      <g transform={`translate(0 ${MARGIN})`}>
        <path class="plot-area" d={areaPath(values, frame)} />
        {limit !== undefined && limit > 0 && (
          <path class={isBroken ? "plot-limit broken" : "plot-limit"} d={`M0 ${plotY(frame, limit)}H${WIDTH}`} />
        )}
        <path class="plot-line" d={curvePath(values, frame)} />
        {isBroken && <path class="plot-broken" d={belowPath(values, frame, limit)} />}
      </g>
      <PlotNow from={from} to={to} width={WIDTH} height={HEIGHT} />
    </svg>
  );
}

function maximum(values: Float32Array): number {
  let most = 0;
  for (const value of values) if (value > most) most = value;
  return most;
}
