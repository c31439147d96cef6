import { useEffect, useState } from "preact/hooks";
import { createSolo, type Solo } from "../engine/solo";
import { useStudio } from "./studio";

/** An engine for as long as the view is open. */
export function useSolo(): Solo {
  const { engineModule } = useStudio();
  const [solo] = useState(() => createSolo(engineModule));
  useEffect(() => () => solo.end(), [solo]);
  return solo;
}
