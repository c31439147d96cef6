import { colorAgents, renameAgent } from "../../document/commands/agents";
import { agentColor, agentLabel } from "../../document/queries";
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
import { NameRow } from "./name-row";
import { PositionRow } from "./position-row";
import { Section } from "./section";

const AbsenceRow = lazily(() => import("../absence/absence-row").then((part) => part.AbsenceRow));

/** One agent. */
export function AgentPanel({ agent }: { agent: number }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const all = mainTrack(scene).agents;
  const itself = all[agent];
  if (!itself) return null;
  const agents = new Set([agent]);
  const color = agentColor(scene, agent);
  return (
    <>
      <Head
        kind="Agent"
        aside={<span class="number">{`${formatCount(agent + 1)} of ${formatCount(all.length)}`}</span>}
      >
        <AgentDot color={color} />
        <span class="ellipsis">{agentLabel(scene, agent)}</span>
      </Head>
      <Section>
        <NameRow
          key={agent}
          name={itself.name}
          label={agentLabel(scene, agent)}
          onCommit={(name) => document.perform(renameAgent(agent, name))}
        />
        <MembershipRow agents={agents} />
        <PositionRow agents={agents} label="Position" />
        <HeightRow agents={agents} />
        <BodyRows agents={agents} />
        <AbsenceRow agents={agents} />
        <ColorRow
          label="Color"
          color={itself.color}
          shown={color}
          onChoose={(chosen) => document.perform(colorAgents(agents, chosen))}
        />
      </Section>
    </>
  );
}
