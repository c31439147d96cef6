import { mainTrack } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import { type Status, StatusWedge } from "../status";
import { useStudio } from "../studio";

/** What the three shapes of a ribbon mean; only where there is a transition to read. */
export function Legend() {
  const { document } = useStudio();
  const scene = document.scene.value;
  if (scene.minimumDistance <= 0 || mainTrack(scene).keyframes.length < 2) return null;
  return (
    <ul class="legend number" aria-label="What the ribbons say">
      <Entry status="holds" words={`holds ${lengthWithUnit(scene.minimumDistance, scene.stage.units)}`} />
      <Entry status="tight" words="tight" />
      <Entry status="clash" words="clash" />
    </ul>
  );
}

function Entry({ status, words }: { status: Status; words: string }) {
  return (
    <li>
      <StatusWedge status={status} />
      {words}
    </li>
  );
}
