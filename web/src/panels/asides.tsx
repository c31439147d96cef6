import type { Aside } from "./aside";
import { lazily } from "./lazily";
import { Safely } from "./safely";
import { useStudio } from "./studio";

const ModesPanel = lazily(() => import("./modes/modes-panel").then((part) => part.ModesPanel));
const ModesOverlay = lazily(() => import("./modes/modes-overlay").then((part) => part.ModesOverlay));
const RecordingPanel = lazily(() => import("./recording/recording-panel").then((part) => part.RecordingPanel));
const RecordingOverlay = lazily(() => import("./recording/recording-overlay").then((part) => part.RecordingOverlay));
const AssignmentOverlay = lazily(() =>
  import("./assignment/assignment-overlay").then((part) => part.AssignmentOverlay),
);

const PathOverlay = lazily(() => import("./travel/path-overlay").then((part) => part.PathOverlay));

/** What is open beside the show: over the drawing and below the pills that float there, or in the inspector's place. */
export function Asides({ place }: { place: "stage" | "side" }) {
  const kind = useStudio().aside.value?.kind;
  return (
    // One overlay serves both, with its panel and without.
    <Safely key={kind === "original" ? "recording" : kind} {...(place === "stage" ? { instead: () => null } : {})}>
      <Shown kind={kind} place={place} />
    </Safely>
  );
}

function Shown({ kind, place }: { kind: Aside["kind"] | undefined; place: "stage" | "side" }) {
  switch (kind) {
    case "modes":
      return place === "stage" ? <ModesOverlay /> : <ModesPanel />;
    case "recording":
      return place === "stage" ? <RecordingOverlay /> : <RecordingPanel />;
    case "original":
      return place === "stage" ? <RecordingOverlay /> : null;
    case "assignment":
      return place === "stage" ? <AssignmentOverlay /> : null;
    case "path":
      return place === "stage" ? <PathOverlay /> : null;
    default:
      return null;
  }
}
