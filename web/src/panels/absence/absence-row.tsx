import { setAbsent } from "../../document/commands/absence";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";

/** Whether agents are there while the others stand at the keyframe at hand. */
export function AbsenceRow({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const keyframe = document.activeKeyframe.value;
  const absent = mainTrack(scene).keyframes[keyframe]?.absent ?? [];
  const count = [...agents].filter((agent) => absent.includes(agent)).length;
  const isSome = count > 0 && count < agents.size;
  return (
    <Switch
      label="Absent here"
      note={isSome ? `${count} of them, at ${keyframeLabel(scene, keyframe)}` : `at ${keyframeLabel(scene, keyframe)}`}
      isOn={count === agents.size}
      onToggle={(isAbsent) => document.perform(setAbsent(keyframe, agents, isAbsent))}
    />
  );
}
