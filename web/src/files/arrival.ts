import type { Scene } from "../document/scene";
import { mainTrack } from "../document/scene";
import type { Reader } from "./reader";

/** What a scene in a link is asked about before it takes the place of the person's own. */
export type Ask = (linked: Scene) => Promise<boolean>;

export interface ArrivalParts {
  readonly reader: Pick<Reader, "read">;
  /** Text of the autosaved scene; null when there is none. */
  readonly saved: () => Promise<string | null>;
  /** The scene as it was left: no step to undo, but what was begun meanwhile is one undo away. */
  readonly restore: (scene: Scene) => void;
  readonly open: (scene: Scene, label: string) => void;
  /** Unless the person has begun something meanwhile. */
  readonly showFirstExample: () => Promise<void>;
  /** Whether there is anything on the page that a link would take the place of. */
  readonly hasOwn: () => boolean;
  readonly askToOpen: Ask;
}

/** A link's part of an address, however much of it is left; the payload is judged by the engine alone. */
export function linkIn(hash: string): string | null {
  return hash === "#s" || hash.startsWith("#s=") ? hash : null;
}

/** Forgets the link in the address bar, so that a reload shows the person's own work. */
function clearAddress(): void {
  history.replaceState(null, "", location.pathname + location.search);
}

/** Opens what the address holds. The person's own scene stays until they say so, and one undo away after that. */
export async function openLink(link: string, parts: ArrivalParts): Promise<boolean> {
  const opened = await parts.reader.read(link, "That link");
  clearAddress();
  if (!opened) return false;
  if (parts.hasOwn() && !(await parts.askToOpen(opened.scene))) return false;
  parts.open(opened.scene, "Open link");
  return true;
}

/** The first thing on the page: a link, else the scene as it was left, else an example that plays. */
export async function arrive(parts: ArrivalParts): Promise<void> {
  const link = linkIn(location.hash);
  const own = await restored(parts);
  if (own) parts.restore(own);
  const isLinked = link !== null && (await openLink(link, parts));
  if (!own && !isLinked) await parts.showFirstExample();
}

async function restored({ saved, reader }: ArrivalParts): Promise<Scene | null> {
  const text = await saved();
  const opened = text === null ? null : await reader.read(text, "Your last scene");
  return opened?.scene ?? null;
}

export function hasAgents(scene: Scene): boolean {
  return mainTrack(scene).agents.length > 0;
}
