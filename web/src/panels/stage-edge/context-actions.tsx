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
  type IconNode,
  TrianglesCenterlineDashedHorizontal,
  TrianglesCenterlineDashedVertical,
  Ungroup,
} from "lucide";
import { dissolveGroup, makeGroup } from "../../document/commands/groups";
import { tieAgents } from "../../document/commands/tie-agents";
import { alignAgents, distributeAgents, type Edge, flipAgents } from "../../document/commands/transform";
import { groupAt, groupWithSet } from "../../document/groups";
import type { Command } from "../../document/store";
import { Icon } from "../../theme/icons";
import { PopoverButton } from "../controls/popover";
import { useStudio } from "../studio";

const FACTORS = [2, 5, 10, 20, 50, 100] as const;
const USUAL_FACTOR = 10;

const EDGES: readonly { readonly edge: Edge; readonly name: string; readonly icon: IconNode }[] = [
  { edge: "left", name: "Align left", icon: AlignStartVertical },
  { edge: "center", name: "Align centers", icon: AlignCenterVertical },
  { edge: "right", name: "Align right", icon: AlignEndVertical },
  { edge: "top", name: "Align top", icon: AlignStartHorizontal },
  { edge: "middle", name: "Align middles", icon: AlignCenterHorizontal },
  { edge: "bottom", name: "Align bottom", icon: AlignEndHorizontal },
];

/** Group, mirror, line up, spread, tie: for several agents at the keyframe being edited. */
export function ContextActions({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const keyframe = document.activeKeyframe.value;
  const perform = (command: Command) => () => document.perform(command);
  return (
    <>
      <GroupButton agents={agents} />
      <BarButton
        name="Flip horizontally"
        icon={TrianglesCenterlineDashedVertical}
        onPress={perform(flipAgents(keyframe, agents, "horizontal"))}
      />
      <BarButton
        name="Flip vertically"
        icon={TrianglesCenterlineDashedHorizontal}
        onPress={perform(flipAgents(keyframe, agents, "vertical"))}
      />
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
            {EDGES.map(({ edge, name, icon }) => (
              <BarButton key={edge} name={name} icon={icon} onPress={perform(alignAgents(keyframe, agents, edge))} />
            ))}
            <BarButton
              name="Distribute across"
              icon={AlignHorizontalDistributeCenter}
              isDisabled={agents.size < 3}
              onPress={perform(distributeAgents(keyframe, agents, "x"))}
            />
            <BarButton
              name="Distribute up and down"
              icon={AlignVerticalDistributeCenter}
              isDisabled={agents.size < 3}
              onPress={perform(distributeAgents(keyframe, agents, "y"))}
            />
          </div>
        )}
      </PopoverButton>
      <span class="separator" />
      <TieMenu agents={agents} />
    </>
  );
}

function GroupButton({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const path = groupWithSet(document.scene.value.groups, agents);
  if (path) {
    return <BarButton name="Dissolve group" icon={Ungroup} onPress={() => document.perform(dissolveGroup(path))} />;
  }
  return (
    <BarButton
      name="Make group"
      icon={Group}
      onPress={() => {
        document.perform(makeGroup(agents));
        const made = groupWithSet(document.scene.peek().groups, agents);
        if (made) document.selection.value = { kind: "group", path: made };
      }}
    />
  );
}

function TieMenu({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const { groups } = document.scene.value;
  const path = groupWithSet(groups, agents);
  const factor = path ? (groupAt(groups, path)?.tieWeight ?? null) : null;
  const shown = factor ?? USUAL_FACTOR;
  return (
    <PopoverButton
      label={factor === null ? "Tie together" : `Tied ×${factor}`}
      buttonClass="button quiet tie-menu"
      side="above"
      face={
        <>
          {factor === null ? "Tie" : "Tied"} ×{shown} <Icon node={ChevronDown} size={14} />
        </>
      }
    >
      {(close) => (
        <div class="menu">
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

function BarButton(props: { name: string; icon: IconNode; isDisabled?: boolean; onPress(): void }) {
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={props.name}
      data-tip={props.name}
      data-tip-side="top"
      disabled={props.isDisabled ?? false}
      onClick={props.onPress}
    >
      <Icon node={props.icon} />
    </button>
  );
}
