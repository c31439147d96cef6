import { mainTrack } from "../../document/scene";
import { endsAround } from "../../document/stretches";
import { PlotNow } from "../plot-now";
import { useStudio } from "../studio";

const WIDTH = 272;
const HEIGHT = 132;

/** Every eigenvalue as a line over the transition's time, with the playhead. */
export function BetweenPlot(props: { eigenvalues: Float64Array; modeCount: number; segment: number }) {
  const { document } = useStudio();
  const { eigenvalues, modeCount, segment } = props;
  const track = mainTrack(document.scene.value);
  const [source, target] = endsAround(track, segment).map((end) => track.keyframes[end]);
  const from = (source?.time ?? 0) + (source?.hold ?? 0);
  const to = target?.time ?? from;
  return (
    <svg class="between" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      <path d={linesOf(eigenvalues, modeCount)} />
      <PlotNow from={from} to={to} width={WIDTH} height={HEIGHT} />
    </svg>
  );
}

/** SVG path data, a line a mode; the constant mode's is the lower edge. */
export function linesOf(eigenvalues: Float64Array, modeCount: number): string {
  const instants = eigenvalues.length / modeCount;
  const greatest = Math.max(...eigenvalues, 1e-9);
  let path = "";
  for (let mode = 0; mode < modeCount; mode += 1) {
    for (let instant = 0; instant < instants; instant += 1) {
      const x = (WIDTH * instant) / Math.max(1, instants - 1);
      const y = HEIGHT - 1 - (HEIGHT - 3) * ((eigenvalues[instant * modeCount + mode] ?? 0) / greatest);
      path += `${instant === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`;
    }
  }
  return path;
}
