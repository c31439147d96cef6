import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { usePlanningWorthSaying } from "./use-planning-worth-saying";

/** What says that a part did not come does not say so of itself: it would come to that again and again. */
const Toast = lazily(
  () => import("./toast").then((part) => part.Toast),
  () => {},
);
const PlanningToast = lazily(() => import("./planning-toast").then((part) => part.PlanningToast));

/** What happened and what to do about it, at the foot of the stage. */
export function Toasts() {
  const { messages } = useStudio();
  const isPlanning = usePlanningWorthSaying();
  return (
    <div class="toasts">
      {messages.shown.value.map((message) => (
        <Toast key={message.id} message={message} />
      ))}
      {isPlanning.value && <PlanningToast />}
    </div>
  );
}
