import "./rail.css";
import { Group, Hand, type IconNode, MousePointer2, PencilLine, Shapes, Spline, TrafficCone } from "lucide";
import { Icon } from "../theme/icons";
import type { ToolName } from "../tools/toolbox";
import { moveFocus } from "./roving";
import { useStudio } from "./studio";
import { keyName, keyShortcuts, useAction } from "./use-action";

interface RailTool {
  readonly tool: ToolName;
  readonly name: string;
  readonly icon: IconNode;
}

/** Parted by a hairline: points and makes, then relates, then looks. */
const GROUPS: readonly (readonly RailTool[])[] = [
  [
    { tool: "select", name: "Select", icon: MousePointer2 },
    { tool: "draw", name: "Draw", icon: PencilLine },
    { tool: "shape", name: "Shape", icon: Shapes },
  ],
  [
    { tool: "tie", name: "Tie", icon: Spline },
    { tool: "group", name: "Group", icon: Group },
    { tool: "obstacle", name: "Obstacle", icon: TrafficCone },
  ],
  [{ tool: "pan", name: "Pan", icon: Hand }],
];

/** The tools, one of them in hand. Arrows move along it, Tab leaves it. */
export function Rail() {
  return (
    <div
      class="rail"
      role="toolbar"
      aria-label="Tools"
      aria-orientation="vertical"
      onKeyDown={(event) => moveFocus(event, "button")}
    >
      {GROUPS.map((tools, index) => (
        <>
          {index > 0 && <hr />}
          {tools.map((tool) => (
            <ToolButton key={tool.tool} {...tool} />
          ))}
        </>
      ))}
    </div>
  );
}

function ToolButton({ tool, name, icon }: RailTool) {
  const { toolbox } = useStudio();
  const { action } = useAction(`tool-${tool}`);
  const isActive = toolbox.active.value === tool;
  const isMaking = isActive && ["draw", "shape", "obstacle"].includes(tool);
  const key = action.keys[0];
  return (
    <button
      type="button"
      class="tool"
      aria-label={name}
      aria-pressed={isActive}
      aria-description={isMaking ? "Press again to place it in the middle" : undefined}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      tabIndex={isActive ? 0 : -1}
      data-tip={name}
      data-tip-side="right"
      data-keys={key && keyName(key)}
      onClick={(event) => {
        // No pointer: Enter is this button's as long as it has the focus, so that here it must place, too.
        if (isMaking && event.detail === 0) toolbox.placeInMiddle();
        else action.run();
      }}
    >
      <Icon node={icon} size={18} />
      <span class="tool-key">{key}</span>
    </button>
  );
}
