import { effect, type ReadonlySignal, signal } from "@preact/signals";
import { type Palette, paletteOf } from "./palette";
import type { View } from "./view";

/** The look as an element inherits it. */
export interface PaletteWatch {
  /** Null until the element has come into the page and was read. */
  readonly palette: ReadonlySignal<Palette | null>;
  /** Reads it now. */
  read(): void;
  stop(): void;
}

/** Reads the look of `element` again whenever the theme changes. */
export function watchPalette(element: HTMLElement, theme: View["theme"]): PaletteWatch {
  const palette = signal<Palette | null>(null);
  const read = () => {
    if (element.isConnected) palette.value = paletteOf(element);
  };
  const systemTheme = matchMedia("(prefers-color-scheme: dark)");
  systemTheme.addEventListener("change", read);
  const stopTheme = effect(() => {
    void theme.value;
    // The page's theme attribute follows the same signal; by the next frame it is set.
    requestAnimationFrame(read);
  });
  return {
    palette,
    read,
    stop() {
      stopTheme();
      systemTheme.removeEventListener("change", read);
    },
  };
}
