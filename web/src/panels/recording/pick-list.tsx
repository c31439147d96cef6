import { X } from "lucide";
import { formatCount, formatTime } from "../../document/units";
import { Icon } from "../../theme/icons";
import { presentInAll } from "./picks";
import { type OpenRecording, recorded, setPicks } from "./state";

/** The frames that become keyframes, and who is in all of them. */
export function PickList({ open: { recording, picks } }: { open: OpenRecording }) {
  if (picks.length === 0) {
    return (
      <p class="inspector-text">Walk through the recording and pick the frames that the new motion should pass.</p>
    );
  }
  const leftOut = recording.agentCount - presentInAll(recording, picks).length;
  return (
    <>
      <ol class="pick-list">
        {picks.map((frame) => {
          const time = formatTime(recording.timeOf(frame));
          const there = presentInAll(recording, [frame]).length;
          return (
            <li key={frame}>
              <button type="button" class="pick" onClick={() => recorded.seek(recording.timeOf(frame))}>
                <span class="number">{time}</span>
                <span class="unit number">{formatCount(there)} there</span>
              </button>
              <button
                type="button"
                class="icon-button"
                aria-label={`Remove ${time}`}
                onClick={() => setPicks(picks.filter((other) => other !== frame))}
              >
                <Icon node={X} size={14} />
              </button>
            </li>
          );
        })}
      </ol>
      {leftOut > 0 && (
        <p class="inspector-text">
          {formatCount(leftOut)} of {formatCount(recording.agentCount)} agents {leftOut === 1 ? "is" : "are"} absent in
          a picked frame and left out: a scene has everybody in every keyframe.
        </p>
      )}
    </>
  );
}
