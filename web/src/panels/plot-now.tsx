import { useRef } from "preact/hooks";
import { useShownAtPlayhead } from "./at-playhead";

/** The playhead in a plot that spans `from` to `to`, scene seconds, over a width and height in units of its drawing. */
export function PlotNow(props: { from: number; to: number; width: number; height: number }) {
  const { from, to, width, height } = props;
  const line = useRef<SVGLineElement>(null);
  useShownAtPlayhead(
    (time) => time >= from && time <= to,
    (isNow) => line.current?.setAttribute("visibility", isNow ? "visible" : "hidden"),
  );
  useShownAtPlayhead(
    (time) => (width * (time - from)) / Math.max(1e-9, to - from),
    (x) => {
      if (!line.current) return;
      // Numbers, where attributes would be new texts on every frame.
      line.current.x1.baseVal.value = x;
      line.current.x2.baseVal.value = x;
    },
  );
  return <line ref={line} class="plot-now" y1="0" y2={height} />;
}
