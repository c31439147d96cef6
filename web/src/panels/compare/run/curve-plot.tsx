import "uplot/dist/uPlot.min.css";
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import type { Palette } from "../../../stage/palette";
import { usePalette } from "../../timeline/use-paint";

/** A line over time. */
export interface Curve {
  readonly label: string;
  /** Which of the agents' colors, from 1. */
  readonly color: number;
  readonly dash: readonly number[];
  /** Seconds, ascending. */
  readonly times: readonly number[];
  readonly values: readonly number[];
}

const HEIGHT = 190;

/** Curves over time with axes; they may last differently long. */
export function CurvePlot({ title, unit, curves }: { title: string; unit: string; curves: readonly Curve[] }) {
  const host = useRef<HTMLDivElement>(null);
  const palette = usePalette();
  useEffect(() => {
    const element = host.current;
    if (!element || curves.length === 0) return;
    const size = () => ({ width: element.clientWidth, height: HEIGHT });
    const plot = new uPlot({ ...optionsOf(curves, palette), ...size() }, dataOf(curves), element);
    const watching = new ResizeObserver(() => plot.setSize(size()));
    watching.observe(element);
    return () => {
      watching.disconnect();
      plot.destroy();
    };
  }, [curves, palette]);
  return (
    <figure class="run-plot" aria-label={title}>
      <figcaption>
        {title}, <span>{unit} over seconds</span>
      </figcaption>
      <div ref={host} aria-hidden="true" />
    </figure>
  );
}

function dataOf(curves: readonly Curve[]): uPlot.AlignedData {
  return uPlot.join(curves.map(({ times, values }) => [[...times], [...values]]));
}

function optionsOf(curves: readonly Curve[], palette: Palette): Omit<uPlot.Options, "width" | "height"> {
  const style = getComputedStyle(document.documentElement);
  const axis: uPlot.Axis = {
    stroke: palette.ink2,
    font: `11px ${style.getPropertyValue("--sans")}`,
    grid: { stroke: style.getPropertyValue("--line"), width: 1 },
    ticks: { stroke: style.getPropertyValue("--line-strong"), width: 1, size: 4 },
    gap: 4,
  };
  return {
    legend: { show: false },
    cursor: { show: false },
    scales: { x: { time: false }, y: { range: (_, low, high) => [Math.min(0, low), Math.max(high * 1.05, 1e-9)] } },
    axes: [
      { ...axis, size: 26 },
      { ...axis, size: 46 },
    ],
    series: [
      {},
      ...curves.map(
        ({ label, color, dash }): uPlot.Series => ({
          label,
          stroke: style.getPropertyValue(`--agent-${color}`).trim(),
          width: 1.6,
          dash: [...dash],
          points: { show: false },
          spanGaps: true,
        }),
      ),
    ],
  };
}
