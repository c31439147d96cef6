import { Plus } from "lucide";
import { mainTrack } from "../../document/scene";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import { placed } from "./place";
import { ribbonPath } from "./ribbon";
import { THUMBNAIL_WIDTH, xOf } from "./scale";
import type { Viewport } from "./viewport";

const RIBBON_WIDTH = 250;

/** While there is one keyframe: what a second one would bring. */
export function EmptySlot({ viewport }: { viewport: Viewport }) {
  const { actions, document } = useStudio();
  const { keyframes } = mainTrack(document.scene.value);
  const only = keyframes[0];
  if (!only || keyframes.length > 1) return null;
  const left = xOf(viewport.scale.value, only.time + only.hold) + THUMBNAIL_WIDTH / 2 + 13;
  const width = Math.min(RIBBON_WIDTH, viewport.width.value * 0.3);
  return (
    <div ref={placed(left)} class="empty-slot">
      <svg width={width} height="54" aria-hidden="true">
        <path d={ribbonPath("none", width, 54, 0)} />
      </svg>
      <button
        type="button"
        class="slot"
        aria-label="Add a second keyframe"
        tabIndex={-1}
        onClick={() => actions.get("add-keyframe").run()}
      >
        <Icon node={Plus} />
      </button>
      <span>The motion appears between two keyframes</span>
    </div>
  );
}
