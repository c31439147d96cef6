import { groupPaths } from "../../document/groups";
import { mainTrack } from "../../document/scene";
import { formatCount } from "../../document/units";
import { screenSpacing, spacingAt } from "../../stage/spacing";
import { useAtPlayhead } from "../at-playhead";
import { useStudio } from "../studio";

/** Below this spacing on the screen ties would be a gray wash, and the stage leaves them out. Pixels. */
const TIES_FROM = 7;

/** What the marks mean and how many there are. */
export function InfoLine() {
  const { document, view } = useStudio();
  const tiesFrom = useAtPlayhead((time) => {
    if (!view.layers.value.ties) return null;
    const spacing = spacingAt(mainTrack(document.scene.value), time);
    const pixels = screenSpacing(spacing, view.camera.value.scale);
    return pixels < TIES_FROM ? Math.ceil((view.zoom.value * TIES_FROM * 10) / pixels) * 10 : null;
  });
  const scene = document.scene.value;
  const agents = mainTrack(scene).agents.length;
  if (agents === 0) return null;
  const groups = groupPaths(scene.groups).filter((path) => path.length === 1).length;
  const count = `${formatCount(agents)} ${agents === 1 ? "agent" : "agents"}`;
  const hasMotion = mainTrack(scene).keyframes.length > 1;
  return (
    <p class="info-line number">
      {hasMotion && (
        <span class="info-legend">
          <svg width="32" height="10" viewBox="0 0 32 10" aria-hidden="true">
            <circle cx="4.5" cy="5" r="3.5" class="faint" />
            <path d="M5 4.5 21 3.2V6.8L5 5.5z" class="trail" />
            <circle cx="21" cy="5" r="3.75" class="firm" />
            <circle cx="28.3" cy="5" r="3" class="ring" />
          </svg>
          from, now, to
        </span>
      )}
      <span>{groups > 0 ? `${count} in ${groups} ${groups === 1 ? "group" : "groups"}` : count}</span>
      <TiesFrom percent={tiesFrom.value} />
    </p>
  );
}

function TiesFrom({ percent }: { percent: number | null }) {
  return percent === null ? null : <span>ties show from {formatCount(percent)} %</span>;
}
