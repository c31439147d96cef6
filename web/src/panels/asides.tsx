import { lazily } from "./lazily";
import { useStudio } from "./studio";

const ModesPanel = lazily(() => import("./modes/modes-panel").then((part) => part.ModesPanel));
const ModesOverlay = lazily(() => import("./modes/modes-overlay").then((part) => part.ModesOverlay));

/** What is open beside the show: over the drawing and below the pills that float there, or in the inspector's place. */
export function Asides({ place }: { place: "stage" | "side" }) {
  switch (useStudio().aside.value?.kind) {
    case "modes":
      return place === "stage" ? <ModesOverlay /> : <ModesPanel />;
    default:
      return null;
  }
}
