import { computed, type ReadonlySignal } from "@preact/signals";
import { useEffect, useMemo, useState } from "preact/hooks";
import { agentColors } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { type Palette, paletteOf } from "../../stage/palette";
import { useStudio } from "../studio";

/** Stored colors by agent; the same list until an agent's color or group changes, whatever else does. */
export function useAgentColors(): ReadonlySignal<readonly string[]> {
  const { document } = useStudio();
  return useMemo(() => {
    const groups = computed(() => document.scene.value.groups);
    const agents = computed(() => mainTrack(document.scene.value).agents);
    return computed(() => {
      void groups.value;
      void agents.value;
      return agentColors(document.scene.peek());
    });
  }, [document]);
}

/** The look as the page shows it now; read again when the theme changes, by choice or with the system. */
export function usePalette(): Palette {
  const { view } = useStudio();
  const theme = view.theme.value;
  const [isSystemDark, setSystemDark] = useState(() => systemDark().matches);
  useEffect(() => {
    const query = systemDark();
    const listen = () => setSystemDark(query.matches);
    query.addEventListener("change", listen);
    return () => query.removeEventListener("change", listen);
  }, []);
  const isDark = theme === "dark" || (theme === "system" && isSystemDark);
  return useMemo(() => {
    // The page's theme attribute follows the signal before any panel renders.
    void isDark;
    return paletteOf(document.documentElement);
  }, [isDark]);
}

function systemDark(): MediaQueryList {
  return matchMedia("(prefers-color-scheme: dark)");
}
