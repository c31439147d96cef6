import { lazily } from "../lazily";
import { useStudio } from "../studio";

const MakingOptions = lazily(() => import("./making-options").then((part) => part.MakingOptions));

/** What the tool in hand can be told, beside it. */
export function ToolOptions() {
  const tool = useStudio().toolbox.active.value;
  return tool === "draw" || tool === "shape" ? <MakingOptions tool={tool} /> : null;
}
