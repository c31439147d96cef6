import "./travel.css";
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { setPath } from "../../document/commands/travel";
import { barycenterOf, type Point } from "../../document/formation";
import { mainTrack } from "../../document/scene";
import { nudgeSteps, snapOf, snapPoint } from "../../document/snap";
import { endsAround } from "../../document/stretches";
import { extended, isMeant } from "../../shapes/stroke";
import { bowBetween, crosses, curveThrough, followed, pathOfStroke, settled } from "../../shapes/travel";
import { toScreen, toStage } from "../../stage/camera";
import { useStudio } from "../studio";
import { PathPoint } from "./path-point";
import { penOn } from "./pen";
import { isTooShort, penWords } from "./pen-words";

/** Pixels between the points kept of a stroke. */
const GRAIN = 3;
/** Pixels a stroke must go to be a path; less is a click. */
const SHORTEST = 24;
/** How far the head of the arrow reaches back, and to the side, CSS pixels. */
const HEAD = { back: 13, aside: 6 } as const;
/** Wheel pixels that double the scale, as on the stage. */
const WHEEL_DOUBLING = 400;

/** The path of the transition that is looked at: a dashed arrow over the stage, its points to be pulled, and the pen to draw one. */
export function PathOverlay() {
  const { document, messages, view } = useStudio();
  const selection = document.selection.value;
  const scene = document.scene.value;
  const index = selection.kind === "transition" ? selection.index : -1;
  const track = mainTrack(scene);
  const { keyframes, segments } = track;
  const [source, target] = endsAround(track, index).map((end) => keyframes[end]?.positions);
  const stroke = useSignal<readonly Point[]>([]);
  const isDrawing = penOn.value === index;
  useEffect(() => {
    isTooShort.value = false;
  }, [isDrawing]);
  if (!source || !target || view.projection.value !== "plan") return null;

  const [from, to] = [barycenterOf(source), barycenterOf(target)];
  const path = segments[index]?.path;
  const points = path ? followed(path, from, to) : [];
  const camera = view.camera.value;
  const shown = (line: readonly Point[]) => line.map((point) => toScreen(camera, point));
  const snap = snapOf(scene);
  const inner = points.slice(1, -1);

  function withPoint(k: number, at: Point): Point[] {
    return settled(points.with(k + 1, snapPoint(at, snap)), from, to, snap);
  }

  return (
    <div class="travel">
      <svg class="travel-lines" aria-hidden="true">
        {points.length > 0 && <Arrow line={shown(curveThrough(points))} isFaint={isDrawing} />}
        {stroke.value.length > 1 && <polyline class="travel-stroke" points={traced(shown(stroke.value))} />}
      </svg>
      {!isDrawing &&
        inner.map((point, k) => (
          <PathPoint
            key={k}
            number={k + 1}
            at={toScreen(camera, point)}
            steps={nudgeSteps(scene)}
            begin={() => {
              const gesture = document.beginGesture();
              return {
                // The points are those of the moment the gesture began.
                to: (by) => gesture.preview(setPath(index, withPoint(k, moved(point, by)), "Move path")),
                commit: gesture.commit,
                cancel: gesture.cancel,
              };
            }}
            scale={camera.scale}
            nudge={(by) => document.perform(setPath(index, withPoint(k, moved(point, by)), "Move path", `path ${k}`))}
            remove={() => {
              const left = points.toSpliced(k + 1, 1);
              document.perform(
                setPath(index, left.length > 2 ? left : null, left.length > 2 ? "Move path" : "Remove path"),
              );
            }}
          />
        ))}
      {isDrawing && (
        <Pen
          stroke={stroke}
          onDone={(drawn) => {
            const made = pathOfStroke(drawn, from, to, snap);
            isTooShort.value = !made;
            if (!made) return;
            penOn.value = null;
            document.perform(setPath(index, made, "Draw path"));
            if (!crosses(curveThrough(followed(made, from, to)))) return;
            messages.say({
              tone: "good",
              title: "The path is drawn.",
              text: "It crosses itself: they pass there twice.",
            });
          }}
          onShort={() => {
            isTooShort.value = true;
          }}
        />
      )}
      {isDrawing && (
        <PenBar
          onBow={() => {
            penOn.value = null;
            document.perform(setPath(index, bowBetween(from, to, snap), "Draw path"));
          }}
        />
      )}
    </div>
  );
}

/** What Enter and Escape do, where the inspector has made way and there may be no keys. */
function PenBar({ onBow }: { onBow(): void }) {
  return (
    <fieldset class="floating travel-bar" aria-label="Path">
      <p role="status">{penWords.value}</p>
      <button type="button" class="button" onClick={onBow}>
        Make a bow
      </button>
      <button
        type="button"
        class="button"
        onClick={() => {
          penOn.value = null;
        }}
      >
        Cancel
      </button>
    </fieldset>
  );
}

/** What draws: presses, pulls and lets go; the wheel still zooms. */
function Pen(props: {
  stroke: { value: readonly Point[] };
  onDone(drawn: readonly Point[]): void;
  /** It was a click, or hardly more. */
  onShort(): void;
}) {
  const { view } = useStudio();
  const { stroke, onDone, onShort } = props;
  useEffect(
    () => () => {
      stroke.value = [];
    },
    [],
  );
  const placeOf = (event: MouseEvent) => toStage(view.camera.peek(), { x: event.offsetX, y: event.offsetY });
  const meters = (pixels: number) => pixels / view.camera.peek().scale;
  return (
    <div
      class="travel-pen"
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        stroke.value = [placeOf(event)];
      }}
      onPointerMove={(event) => {
        if (stroke.value.length > 0) stroke.value = extended(stroke.value, placeOf(event), meters(GRAIN));
      }}
      onPointerUp={() => {
        const drawn = stroke.value;
        stroke.value = [];
        if (isMeant(drawn, meters(SHORTEST))) onDone(drawn);
        else if (drawn.length > 0) onShort();
      }}
      onPointerCancel={() => {
        stroke.value = [];
      }}
      onWheel={(event) => {
        event.preventDefault();
        view.zoomBy(2 ** (-event.deltaY / WHEEL_DOUBLING), { x: event.offsetX, y: event.offsetY });
      }}
    />
  );
}

interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Dashed, with a head at its end. */
function Arrow({ line, isFaint }: { line: readonly Spot[]; isFaint: boolean }) {
  const tip = line.at(-1);
  if (!tip) return null;
  const tail = line.findLast(({ x, y }) => Math.hypot(tip.x - x, tip.y - y) > HEAD.back) ?? line[0] ?? tip;
  const away = Math.hypot(tip.x - tail.x, tip.y - tail.y) || 1;
  const [ux, uy] = [(tip.x - tail.x) / away, (tip.y - tail.y) / away];
  const barb = (side: number) => ({
    x: tip.x - HEAD.back * ux - side * HEAD.aside * uy,
    y: tip.y - HEAD.back * uy + side * HEAD.aside * ux,
  });
  return (
    <g class={isFaint ? "travel-path is-faint" : "travel-path"}>
      <polyline class="travel-halo" points={traced(line)} />
      <polyline class="travel-line" points={traced(line)} />
      <polygon class="travel-head" points={traced([barb(1), tip, barb(-1)])} />
    </g>
  );
}

function traced(line: readonly Spot[]): string {
  return line.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" ");
}

function moved([x, y]: Point, [dx, dy]: Point): Point {
  return [x + dx, y + dy];
}
