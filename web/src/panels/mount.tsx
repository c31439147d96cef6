import "../theme/tokens.css";
import "../theme/base.css";
import "../theme/buttons.css";
import "../theme/fields.css";
import "../theme/overlays.css";
import "../theme/status.css";
import { effect } from "@preact/signals";
import { render } from "preact";
import { Layout, type Parts } from "./layout";
import { type Studio, StudioContext } from "./studio";

/**
 * Puts the page into `root` at once. The regions "Stage", "Inspector" and the top bar are drawn here; `parts` brings
 * the rest. `parts.stageHost` may be given to the stage before or after: it sits in the page when this returns.
 * Gives back what takes everything down again.
 */
export function mountPanels(root: HTMLElement, studio: Studio, parts: Parts): () => void {
  const stopTheme = effect(() => {
    const theme = studio.view.theme.value;
    if (theme === "system") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
  });
  const stopTitle = effect(() => {
    const title = studio.document.scene.value.title.trim();
    document.title = title ? `${title} · Eigenform` : "Eigenform";
  });
  render(
    <StudioContext.Provider value={studio}>
      <Layout parts={parts} />
    </StudioContext.Provider>,
    root,
  );
  return () => {
    stopTheme();
    stopTitle();
    render(null, root);
  };
}
