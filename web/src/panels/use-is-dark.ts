import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { useStudio } from "./studio";

/** Whether the page is dark, by the person's choice or the system's. */
export function useIsDark(): boolean {
  const { view } = useStudio();
  const isSystemDark = useSignal(false);
  useEffect(() => {
    const query = matchMedia("(prefers-color-scheme: dark)");
    const follow = () => {
      isSystemDark.value = query.matches;
    };
    follow();
    query.addEventListener("change", follow);
    return () => query.removeEventListener("change", follow);
  }, [isSystemDark]);
  const theme = view.theme.value;
  return theme === "system" ? isSystemDark.value : theme === "dark";
}
