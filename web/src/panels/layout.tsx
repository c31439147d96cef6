import "./layout.css";
import "./stage-edge/stage-edge.css";
import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { mainTrack } from "../document/scene";
import { Inspector } from "./inspector/inspector";
import { lazily, sayNotLoaded } from "./lazily";
import { Rail } from "./rail";
import { ContextBar } from "./stage-edge/context-bar";
import { Toasts } from "./stage-edge/toasts";
import { ToolOptions } from "./stage-edge/tool-options";
import { useStudio } from "./studio";
import { TopBar } from "./top-bar";
import { useSheet } from "./use-sheet";

const Asides = lazily(() => import("./asides").then((part) => part.Asides));
const Hint = lazily(() => import("./stage-edge/hint").then((part) => part.Hint));
const ViewPills = lazily(() => import("./stage-edge/view-pills").then((part) => part.ViewPills));
const PerspectiveView = lazily(
  () => import("./perspective/perspective-view").then((part) => part.PerspectiveView),
  (studio) => {
    sayNotLoaded(studio);
    studio.view.projection.value = "plan";
  },
);

/** What the page is put together from, beside the panels of this folder. */
export interface Parts {
  /** What the stage draws in; it fills the region "Stage", below the rail and the pills. */
  readonly stageHost: HTMLElement;
  /** Where the scene is kept, in words: `Saved on this device`. */
  readonly savedText: ReadonlySignal<string>;
  /** The region "Timeline", itself included. */
  readonly Timeline: ComponentType;
  /** Everything that opens over the page. */
  readonly Dialogs: ComponentType;
}

/** The regions of the page and nothing else. */
export function Layout({ parts }: { parts: Parts }) {
  const { Timeline, Dialogs } = parts;
  const { aside, view } = useStudio();
  const isSheetOpen = useSheet();
  const hasBegunEmpty = useHasBegunEmpty();
  const hasAside = aside.value !== null;
  return (
    <div class={isSheetOpen.value ? "app sheet-open" : "app"}>
      <TopBar savedText={parts.savedText} />
      <main class="work">
        <section class="stage" aria-label="Stage">
          <StageHost element={parts.stageHost} />
          {hasAside && <Asides place="stage" />}
          {view.projection.value === "perspective" && <PerspectiveView />}
          <Rail />
          <ToolOptions />
          <ViewPills isSheetOpen={isSheetOpen} />
          <ContextBar />
          <Toasts />
        </section>
        <Inspector isSheetOpen={isSheetOpen} />
        {hasAside && <Asides place="side" />}
        <div class="time">
          <Timeline />
        </div>
        {hasBegunEmpty.value && <Hint />}
      </main>
      <Dialogs />
      <Announcer />
    </div>
  );
}

/** Whether the person has emptied the stage to start on: whoever does may want a hint. The page itself begins empty. */
function useHasBegunEmpty(): ReadonlySignal<boolean> {
  const { document } = useStudio();
  const hasBegun = useSignal(false);
  useSignalEffect(() => {
    const isEmpty = mainTrack(document.scene.value).agents.length === 0;
    if (isEmpty && document.undoLabel.value !== null) hasBegun.value = true;
  });
  return hasBegun;
}

function StageHost({ element }: { element: HTMLElement }) {
  return (
    <div
      class="stage-host"
      ref={(place) => {
        if (place && element.parentElement !== place) place.append(element);
      }}
    />
  );
}

function Announcer() {
  const { messages } = useStudio();
  return (
    <div class="unseen" role="status" aria-live="polite" aria-atomic="false">
      {messages.announcements.value.map(({ id, text }) => (
        <div key={id}>{text}</div>
      ))}
    </div>
  );
}
