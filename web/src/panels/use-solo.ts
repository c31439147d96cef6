import { useEffect, useState } from "preact/hooks";
import { createSolo, type Solo } from "../engine/solo";

/** An engine for as long as the view is open. */
export function useSolo(): Solo {
  const [solo] = useState(createSolo);
  useEffect(() => () => solo.end(), [solo]);
  return solo;
}
