import { defineConfig } from "vite";

/** What the inspector of a whole scene shows and does, and others too. */
const CONTROLS =
  /panels.controls|panels.inspector.(words|quantities|section|head|minimum|group-list|propose-groups)|document.(commands.scene|limits)|lucide/;

export default defineConfig({
  root: "web",
  base: "./",
  publicDir: "../public",
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  worker: { format: "es" },
  build: {
    outDir: "dist",
    emptyOutDir: true,
    manifest: true,
    target: "es2022",
    assetsInlineLimit: 0,
    // The perspective view brings three along, when it is opened.
    chunkSizeWarningLimit: 640,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      // What is needed at first travels in one piece, and so do controls and commands: many small chunks compress worse, ask
      // for more requests, and the first piece would have to name each.
      output: {
        codeSplitting: {
          groups: [
            { name: "first", tags: ["$initial"], priority: 1 },
            { name: "controls", test: CONTROLS, minShareCount: 2 },
            { name: "inspector", test: /panels.inspector/, minShareCount: 2 },
            { name: "edits", test: /document.(commands|box|snap|round|edit|parts|between|cut)/, minShareCount: 2 },
          ],
        },
      },
    },
  },
});
