import "./inspector.css";
import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren, ComponentType } from "preact";
import { mainTrack } from "../../document/scene";
import type { Selection } from "../../document/selection";
import { formatCount } from "../../document/units";
import { moveFocus } from "../roving";
import { SheetGrip } from "../sheet";
import { useStudio } from "../studio";
import { AgentPanel } from "./agent-panel";
import { AgentsPanel } from "./agents-panel";
import { GroupPanel } from "./group-panel";
import { KeyframePanel } from "./keyframe-panel";
import { ScenePanel } from "./scene-panel";
import { TiePanel } from "./tie-panel";
import { TransitionPanel } from "./transition-panel";

type Tab = "inspector" | "agents";

/** What is selected and what can be changed about it; beside it, everybody in a table. */
export function Inspector({ isSheetOpen }: { isSheetOpen: Signal<boolean> }) {
  const { document } = useStudio();
  const tab = useSignal<Tab>("inspector");
  const table = useSignal<{ readonly Table: ComponentType } | null>(null);
  const count = mainTrack(document.scene.value).agents.length;

  async function show(next: Tab): Promise<void> {
    tab.value = next;
    if (next === "agents" && !table.peek()) {
      const { AgentsTable } = await import("../agents-table/agents-table");
      table.value = { Table: AgentsTable };
    }
  }

  const Table = table.value?.Table;
  return (
    <section
      class="side"
      aria-label="Inspector"
      onKeyDown={(event) => {
        if (event.key === "Escape" && !event.defaultPrevented) isSheetOpen.value = false;
      }}
    >
      <SheetGrip isOpen={isSheetOpen} />
      <div class="tabs" role="tablist" onKeyDown={(event) => moveFocus(event, "button")}>
        <TabButton tab="inspector" shown={tab.value} onShow={show}>
          Inspector
        </TabButton>
        <TabButton tab="agents" shown={tab.value} onShow={show}>
          Agents <span class="number unit">{formatCount(count)}</span>
        </TabButton>
      </div>
      <div class="tab-panel" id="inspector-panel" role="tabpanel" aria-labelledby={`tab-${tab.value}`}>
        {tab.value === "inspector" && <Panel selection={document.selection.value} />}
        {tab.value === "agents" && Table && <Table />}
      </div>
    </section>
  );
}

function TabButton(props: { tab: Tab; shown: Tab; onShow(tab: Tab): void; children: ComponentChildren }) {
  const isShown = props.tab === props.shown;
  return (
    <button
      type="button"
      role="tab"
      id={`tab-${props.tab}`}
      class="tab"
      aria-selected={isShown}
      aria-controls="inspector-panel"
      tabIndex={isShown ? 0 : -1}
      onFocus={() => props.onShow(props.tab)}
      onClick={() => props.onShow(props.tab)}
    >
      {props.children}
    </button>
  );
}

function Panel({ selection }: { selection: Selection }) {
  switch (selection.kind) {
    case "none":
      return <ScenePanel />;
    case "agents": {
      const [only] = selection.agents;
      if (only === undefined) return <ScenePanel />;
      return selection.agents.size === 1 ? <AgentPanel agent={only} /> : <AgentsPanel agents={selection.agents} />;
    }
    case "tie":
      return <TiePanel a={selection.a} b={selection.b} />;
    case "group":
      return <GroupPanel path={selection.path} />;
    case "keyframe":
      return <KeyframePanel index={selection.index} />;
    case "transition":
      return <TransitionPanel index={selection.index} />;
  }
}
