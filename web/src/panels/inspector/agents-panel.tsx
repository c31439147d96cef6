import { colorAgents } from "../../document/commands/agents";
import { agentColors } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { formatCount } from "../../document/units";
import { AgentDot } from "../agent-dot";
import { ColorRow } from "../controls/color-row";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { BodyRows } from "./body-rows";
import { Head } from "./head";
import { HeightRow } from "./height-row";
import { MembershipRow } from "./membership-row";
import { PositionRow } from "./position-row";
import { Section } from "./section";

const AbsenceRow = lazily(() => import("../absence/absence-row").then((part) => part.AbsenceRow));

/** Several agents at once. */
export function AgentsPanel({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const all = mainTrack(scene).agents;
  const colors = agentColors(scene);
  const shown = new Set([...agents].map((agent) => colors[agent] ?? ""));
  const own = new Set([...agents].map((agent) => all[agent]?.color ?? ""));
  const [firstShown = ""] = shown;
  const [firstOwn = ""] = own;
  return (
    <>
      <Head kind="Agents" aside={<span class="number">{`of ${formatCount(all.length)}`}</span>}>
        {[...shown].slice(0, 3).map((color) => (
          <AgentDot key={color} color={color} />
        ))}
        <span>{formatCount(agents.size)} agents</span>
      </Head>
      <Section>
        <MembershipRow agents={agents} />
        <PositionRow agents={agents} label="Center" />
        <HeightRow agents={agents} />
        <BodyRows agents={agents} />
        <AbsenceRow agents={agents} />
        <ColorRow
          label="Color"
          color={own.size === 1 ? firstOwn : ""}
          shown={shown.size === 1 ? firstShown : null}
          onChoose={(color) => document.perform(colorAgents(agents, color))}
        />
      </Section>
    </>
  );
}
