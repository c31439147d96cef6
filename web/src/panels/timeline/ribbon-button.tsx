import { useSignalEffect } from "@preact/signals";
import type { Ref } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { agentLabel } from "../../document/queries";
import type { Scene } from "../../document/scene";
import { formatTime, lengthWithUnit } from "../../document/units";
import type { Approach } from "../../engine/api";
import { closestWords } from "../closest";
import { StatusWedge } from "../status";
import { useStudio } from "../studio";
import type { TransitionPlace } from "./layout";
import { placed } from "./place";
import { momentX, ribbonPath, ribbonStart } from "./ribbon";
import { ribbonName } from "./ribbon-name";
import { timeAt } from "./scale";
import { METHOD_WORDS, type TransitionState } from "./transition-state";
import type { Viewport } from "./viewport";

const HEIGHT = 54;
const INSET = 9;
const BAR_HALF_HEIGHT = 14.5;
const BAR_HALF_WIDTH = 0.875;
/** Narrower ribbons show the number alone, or no label. */
const ROOM_FOR_METHOD = 104;
const ROOM_FOR_NUMBER = 44;

export interface RibbonProps {
  readonly index: number;
  /** `Opener to Letter C`. */
  readonly names: string;
  readonly place: TransitionPlace;
  readonly state: TransitionState;
  readonly isSelected: boolean;
  readonly viewport: Viewport;
}

/** One transition: a wedge whose shape and color say how the minimum distance fares, and how it is moved. */
export function Ribbon({ index, names, place, state, isSelected, viewport }: RibbonProps) {
  const { document, playback } = useStudio();
  const { status, plan, words, closest, before, progress } = state;
  const inset = Math.min(INSET, place.width / 6);
  const width = place.width - 2 * inset;
  const scale = viewport.scale.value;
  const { units } = document.scene.value.stage;
  const momentTime = closest?.time ?? 0;
  const momentOf = (time: number) => (scale.origin + time * scale.pixelsPerSecond - place.left - inset) / width;
  const moment = momentOf(momentTime);
  const near = plan && closest && closestWords(plan.report, closest, units);
  const cut = inset + momentX(moment, width, 3.5);
  const was = before && inset + momentX(momentOf(before.time), width, 3.5);
  const method = plan ? METHOD_WORDS[plan.report.choice.method] : "";

  const labels = useSeenPart(place, viewport);

  const choose = (clientX: number, element: Element) => {
    document.selection.value = { kind: "transition", index };
    if (place.isMark) {
      playback.seek(timeAt(scale, place.middle));
      return;
    }
    const box = element.getBoundingClientRect();
    const x = clientX - box.left;
    const isOnMark = (status === "tight" || status === "clash") && Math.abs(x - cut) < 8;
    const wasThere = before && was !== null && Math.abs(x - was) < 8;
    playback.seek(isOnMark ? momentTime : wasThere ? before.time : timeAt(scale, place.left + x));
  };

  return (
    <li ref={placed(place.left, place.width)} class={place.isMark ? "ribbon-place is-mark" : "ribbon-place"}>
      <button
        type="button"
        class={progress === null ? `ribbon is-${status}` : `ribbon is-${status} is-planning`}
        aria-pressed={isSelected}
        aria-label={ribbonName(names, state, near)}
        aria-description={before ? beforeWords(document.scene.value, before) : undefined}
        data-tip={before ? beforeWords(document.scene.value, before) : undefined}
        onClick={(event) => {
          if (event.detail > 0) choose(event.clientX, event.currentTarget);
          else document.selection.value = { kind: "transition", index };
        }}
        onFocus={(event) => {
          if (event.currentTarget.matches(":focus-visible")) viewport.reveal(timeAt(scale, place.middle));
        }}
      >
        {place.isMark ? (
          <StatusWedge status={status} />
        ) : (
          <svg width={place.width} height={HEIGHT} aria-hidden="true">
            <g transform={`translate(${inset} 0)`}>
              <path
                class="wedge-shape"
                d={ribbonPath(status, width, HEIGHT, moment)}
                fill={`url(#ribbon-${status}-${isSelected ? "chosen" : "quiet"})`}
              />
              {progress !== null && <path class="progress" d={ribbonStart(progress, width, HEIGHT)} />}
            </g>
            {was !== null && status !== "clash" && <path class="was" d={bar(was)} />}
            {status === "clash" && <path class="cut" d={bar(cut)} />}
          </svg>
        )}
        {place.width >= ROOM_FOR_NUMBER && (
          <span ref={labels} class="ribbon-labels number">
            <span class="known">
              {(place.width >= ROOM_FOR_METHOD || !near) && <span>{method || words}</span>}
              {near && <span class="clearance">{near}</span>}
            </span>
            {progress !== null && plan && <span class="pending">{words}</span>}
          </span>
        )}
      </button>
    </li>
  );
}

function bar(x: number): string {
  const top = HEIGHT / 2 - BAR_HALF_HEIGHT;
  return `M${x - BAR_HALF_WIDTH} ${top}h${2 * BAR_HALF_WIDTH}v${2 * BAR_HALF_HEIGHT}h${-2 * BAR_HALF_WIDTH}Z`;
}

function beforeWords(scene: Scene, { agents: [a, b], distance, time }: Approach): string {
  const near = lengthWithUnit(distance, scene.stage.units);
  return `Before avoidance: ${agentLabel(scene, a)} and ${agentLabel(scene, b)}, ${near} at ${formatTime(time)}`;
}

/** Keeps an element in the middle of that part of a ribbon which is in the window. */
function useSeenPart({ left, width }: TransitionPlace, viewport: Viewport): Ref<HTMLSpanElement> {
  const element = useRef<HTMLSpanElement>(null);
  const stand = () => {
    const from = Math.max(0, viewport.scroll.value - left);
    const to = Math.min(width, viewport.scroll.value + viewport.width.value - left);
    const isSeen = to - from >= ROOM_FOR_METHOD;
    if (!element.current) return;
    element.current.style.left = `${isSeen ? from : 0}px`;
    element.current.style.width = `${isSeen ? to - from : width}px`;
  };
  useSignalEffect(stand);
  useLayoutEffect(stand);
  return element;
}
