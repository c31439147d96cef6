import "./inspector.css";
import { type Signal, useSignal, useSignalEffect } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { mainTrack } from "../../document/scene";
import { formatCount } from "../../document/units";
import { lazily } from "../lazily";
import { moveFocus } from "../roving";
import { Safely } from "../safely";
import { useStudio } from "../studio";

type Tab = "inspector" | "agents";

const ScenePanel = lazily(() => import("./scene-panel").then((part) => part.ScenePanel));
const SelectedPanel = lazily(() => import("./selected-panel").then((part) => part.SelectedPanel));
const SheetGrip = lazily(() => import("../sheet-grip").then((part) => part.SheetGrip));
const AgentsTable = lazily(() => import("../agents-table/agents-table").then((part) => part.AgentsTable));

/** What is selected and what can be changed about it; beside it, everybody in a table. */
export function Inspector({ isSheetOpen }: { isSheetOpen: Signal<boolean> }) {
  const { document, aside } = useStudio();
  const tab = useSignal<Tab>("inspector");
  const hasBeenSheet = useRef(false);
  hasBeenSheet.current ||= isSheetOpen.value || aside.value !== null;
  // A tie or a transition is looked at here alone; agents and groups may have been picked in the table.
  useSignalEffect(() => {
    const { kind } = document.selection.value;
    if (kind === "transition" || kind === "tie") tab.value = "inspector";
  });
  const count = mainTrack(document.scene.value).agents.length;
  return (
    <section
      class="side"
      aria-label="Inspector"
      onKeyDown={(event) => {
        if (event.key === "Escape" && !event.defaultPrevented) isSheetOpen.value = false;
      }}
    >
      {hasBeenSheet.current && <SheetGrip isOpen={isSheetOpen} />}
      <div class="tabs" role="tablist" onKeyDown={(event) => moveFocus(event, "button")}>
        <TabButton tab="inspector" shown={tab}>
          Inspector
        </TabButton>
        <TabButton tab="agents" shown={tab}>
          Agents <span class="number unit">{formatCount(count)}</span>
        </TabButton>
      </div>
      <div class="tab-panel" id="inspector-panel" role="tabpanel" aria-labelledby={`tab-${tab.value}`}>
        {tab.value === "agents" ? (
          <Safely key="table">
            <AgentsTable />
          </Safely>
        ) : (
          // Another kind of selection is another try.
          <Safely key={document.selection.value.kind}>
            <Panel />
          </Safely>
        )}
      </div>
    </section>
  );
}

function TabButton({ tab, shown, children }: { tab: Tab; shown: Signal<Tab>; children: ComponentChildren }) {
  const isShown = tab === shown.value;
  const show = () => {
    shown.value = tab;
  };
  return (
    <button
      type="button"
      role="tab"
      id={`tab-${tab}`}
      class="tab"
      aria-selected={isShown}
      aria-controls="inspector-panel"
      tabIndex={isShown ? 0 : -1}
      onFocus={show}
      onClick={show}
    >
      {children}
    </button>
  );
}

function Panel() {
  const selection = useStudio().document.selection.value;
  const isNothing = selection.kind === "none" || (selection.kind === "agents" && selection.agents.size === 0);
  return isNothing ? <ScenePanel /> : <SelectedPanel selection={selection} />;
}
