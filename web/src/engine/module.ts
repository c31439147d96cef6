import engineUrl from "./pkg/engine_bg.wasm?url";
import workshopUrl from "./pkg/workshop_bg.wasm?url";

let workshop: Promise<WebAssembly.Module> | null = null;

/** Compiled once for all workers. */
export function compileEngine(): Promise<WebAssembly.Module> {
  return compile(engineUrl);
}

/** The engine with what a first visit does not ask for: fetched when it is first wanted, and again where that failed. */
export function workshopModule(): Promise<WebAssembly.Module> {
  workshop ??= compile(workshopUrl).catch((error: unknown) => {
    workshop = null;
    throw error;
  });
  return workshop;
}

async function compile(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the engine was not found (${response.status})`);
  const isTyped = response.headers.get("content-type")?.startsWith("application/wasm");
  if (isTyped) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
