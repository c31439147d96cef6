import { selectedRun } from "../../document/run";
import type { Selection } from "../../document/selection";
import { AgentPanel } from "./agent-panel";
import { AgentsPanel } from "./agents-panel";
import { GroupPanel } from "./group-panel";
import { KeyframePanel } from "./keyframe-panel";
import { ObstaclePanel } from "./obstacle-panel";
import { RunPanel } from "./run-panel";
import { TiePanel } from "./tie-panel";
import { TransitionPanel } from "./transition-panel";

/** The panel of what is selected. */
export function SelectedPanel({ selection }: { selection: Selection }) {
  switch (selection.kind) {
    case "none":
      return null;
    case "agents": {
      const [only] = selection.agents;
      if (only === undefined) return null;
      return selection.agents.size === 1 ? <AgentPanel agent={only} /> : <AgentsPanel agents={selection.agents} />;
    }
    case "tie":
      return <TiePanel a={selection.a} b={selection.b} />;
    case "group":
      return <GroupPanel path={selection.path} />;
    case "keyframe": {
      const run = selectedRun(selection);
      return run ? <RunPanel run={run} /> : <KeyframePanel index={selection.index} />;
    }
    case "obstacle":
      return <ObstaclePanel index={selection.index} />;
    case "transition":
      return <TransitionPanel index={selection.index} />;
  }
}
