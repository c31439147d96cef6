import type { JSX } from "preact";
import type { Keyframe } from "../../document/scene";
import { formatDuration } from "../../document/units";
import { StatusWedge } from "../status";
import { shortTime } from "./clock";
import type { KeyframePlace } from "./layout";
import { placed } from "./place";
import { THUMBNAIL_WIDTH } from "./scale";
import { Thumbnail, type ThumbnailProps } from "./thumbnail";

export interface KeyframeOptionProps {
  readonly index: number;
  readonly name: string;
  readonly keyframe: Keyframe;
  readonly place: KeyframePlace;
  /** Room for the name below, CSS pixels; 0 where it shows only under the pointer. */
  readonly nameWidth: number;
  readonly isSelected: boolean;
  readonly isFocusable: boolean;
  /** How many stand too near to another or to an obstacle. */
  readonly breachCount: number;
  /** A stop where others pass. */
  readonly isCorner: boolean;
  /** It lies in a transition instead of ending it. */
  readonly isBetween: boolean;
  /** Null while the keyframe is far out of sight. */
  readonly paint: Pick<ThumbnailProps, "colors" | "palette"> | null;
  readonly mark: "none" | "dragged" | "target";
  readonly handlers: Pick<
    JSX.HTMLAttributes<HTMLDivElement>,
    "onPointerDown" | "onPointerMove" | "onPointerUp" | "onPointerCancel" | "onClick" | "onContextMenu"
  >;
}

/** A keyframe: the formation in small at its time, drawn on to the right for as long as it holds. */
export function KeyframeOption(props: KeyframeOptionProps) {
  const { index, name, keyframe, place, mark, breachCount } = props;
  const hold = place.right - place.x - THUMBNAIL_WIDTH / 2;
  return (
    <div
      ref={placed(place.x - THUMBNAIL_WIDTH / 2)}
      class={`keyframe is-${mark}`}
      role="option"
      aria-selected={props.isSelected}
      aria-label={name}
      aria-description={description(props)}
      tabIndex={props.isFocusable ? 0 : -1}
      data-index={index}
      {...props.handlers}
    >
      {hold > 0 && <i ref={placed(THUMBNAIL_WIDTH, hold)} class="hold-bar" />}
      {props.isCorner && <i class="corner-mark" />}
      {props.isBetween && <i class="between-mark" />}
      {breachCount > 0 && (
        <i class="breach-mark">
          <StatusWedge status="clash" />
        </i>
      )}
      <span class="thumbnail">{props.paint && <Thumbnail keyframe={keyframe} {...props.paint} />}</span>
      <span ref={roomForName(props.nameWidth)} class={props.nameWidth > 0 ? "keyframe-name" : "keyframe-name is-aside"}>
        {mark === "dragged" ? shortTime(Math.round(keyframe.time * 100) / 100) : name}
      </span>
    </div>
  );
}

function roomForName(width: number): (element: HTMLElement | null) => void {
  return (element) => element?.style.setProperty("--room", width > 0 ? `${width}px` : "max-content");
}

function description({ keyframe, isCorner, isBetween, breachCount }: KeyframeOptionProps): string {
  const { time, hold } = keyframe;
  const words = [
    `at ${shortTime(time)}`,
    hold > 0 ? `holds ${formatDuration(hold)}` : "",
    isCorner ? "corner" : "",
    isBetween ? "in-between" : "",
    breachCount > 0 ? `${breachCount} too near` : "",
  ];
  return words.filter(Boolean).join(", ");
}
