import {
  AlignCenterHorizontal,
  AlignCenterVertical,
  AlignEndHorizontal,
  AlignEndVertical,
  AlignHorizontalDistributeCenter,
  AlignStartHorizontal,
  AlignStartVertical,
  AlignVerticalDistributeCenter,
  ChevronDown,
  Group,
  TrianglesCenterlineDashedHorizontal,
  TrianglesCenterlineDashedVertical,
  Ungroup,
} from "lucide";
import { tieAgents } from "../../document/commands/tie-agents";
import { groupWithSet } from "../../document/group-with-set";
import { groupAt } from "../../document/groups";
import { Icon } from "../../theme/icons";
import { IconAction } from "../action-button";
import { PopoverButton } from "../controls/popover";
import { useStudio } from "../studio";

const FACTORS = [2, 5, 10, 20, 50, 100] as const;
const USUAL_FACTOR = 10;

/** Group, mirror, line up, spread, tie: for several agents at the keyframe being edited. */
export function ContextActions({ agents }: { agents: ReadonlySet<number> }) {
  return (
    <>
      {/* Side by side: in one place, the second press of two would undo the first. */}
      <IconAction id="make-group" icon={Group} side="top" keepsFocus />
      <IconAction id="dissolve-group" icon={Ungroup} side="top" keepsFocus />
      <IconAction id="flip-horizontal" icon={TrianglesCenterlineDashedVertical} side="top" />
      <IconAction id="flip-vertical" icon={TrianglesCenterlineDashedHorizontal} side="top" />
      <PopoverButton
        label="Align and distribute"
        buttonClass="icon-button"
        side="above"
        tip="Align and distribute"
        tipSide="top"
        face={<Icon node={AlignCenterVertical} />}
      >
        {() => (
          <div class="align-grid">
            <IconAction id="align-left" icon={AlignStartVertical} />
            <IconAction id="align-center" icon={AlignCenterVertical} />
            <IconAction id="align-right" icon={AlignEndVertical} />
            <IconAction id="distribute-horizontally" icon={AlignHorizontalDistributeCenter} />
            <IconAction id="align-top" icon={AlignStartHorizontal} />
            <IconAction id="align-middle" icon={AlignCenterHorizontal} />
            <IconAction id="align-bottom" icon={AlignEndHorizontal} />
            <IconAction id="distribute-vertically" icon={AlignVerticalDistributeCenter} />
          </div>
        )}
      </PopoverButton>
      <span class="separator" />
      <TieMenu agents={agents} />
    </>
  );
}

function TieMenu({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const { groups } = document.scene.value;
  const path = groupWithSet(groups, agents);
  const factor = path ? (groupAt(groups, path)?.tieWeight ?? null) : null;
  return (
    <PopoverButton
      label={factor === null ? "Tie together" : `Tied ×${factor}`}
      buttonClass="button quiet tie-menu"
      side="above"
      face={
        <>
          {factor === null ? `Tie ×${USUAL_FACTOR}` : `Tied ×${factor}`} <Icon node={ChevronDown} size={14} />
        </>
      }
    >
      {(close) => (
        <div class="menu tie-factors">
          {FACTORS.map((choice) => (
            <button
              key={choice}
              type="button"
              class="menu-item"
              aria-pressed={choice === factor}
              onClick={() => {
                document.perform(tieAgents(agents, choice));
                close();
              }}
            >
              Tie ×{choice}
              {choice === USUAL_FACTOR && <span class="keys">usual</span>}
            </button>
          ))}
        </div>
      )}
    </PopoverButton>
  );
}
