import { defineConfig, type Plugin } from "vite";

/** Modules that the page needs before anything is opened: what the entry imports, and what that imports, at once. */
const first = new Set<string>();

/** Many small shared chunks compress worse than one, so what is needed at first travels in one piece. */
function firstLoad(): Plugin {
  return {
    name: "first-load",
    buildEnd() {
      const visit = (id: string): void => {
        if (first.has(id)) return;
        first.add(id);
        for (const imported of this.getModuleInfo(id)?.importedIds ?? []) visit(imported);
      };
      for (const id of this.getModuleIds()) if (this.getModuleInfo(id)?.isEntry) visit(id);
    },
  };
}

export default defineConfig({
  root: "web",
  base: "./",
  publicDir: "../public",
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  worker: { format: "es" },
  plugins: [firstLoad()],
  build: {
    outDir: "dist",
    emptyOutDir: true,
    manifest: true,
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: "first", test: (id: string) => first.has(id) }] } },
    },
  },
});
