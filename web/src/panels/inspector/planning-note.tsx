import { TriangleAlert } from "lucide";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import type { PlanningView } from "./planning-view";

/** Why there is no motion to judge, and the way back to one. */
export function PlanningNote({ view }: { view: PlanningView }) {
  const { planner } = useStudio();
  if (!view.problem && !view.isCanceled) return null;
  return (
    <div class={view.problem ? "note clash" : "note"}>
      {view.problem && <Icon node={TriangleAlert} />}
      <p>
        {view.problem ? `${view.problem.what} ` : "Planning was canceled; agents move in straight lines meanwhile. "}
        <button type="button" class="link" onClick={() => planner.resume()}>
          Plan it
        </button>
      </p>
    </div>
  );
}
