import { computed } from "@preact/signals";
import { agentsAsText, pasteAt, textAsKeyframes } from "../document/clipboard";
import { selectedAgents } from "../document/queries";
import { EngineError } from "../engine/api";
import type { AgentClipboard } from "./clipboard-events";
import { type ActionParts, type Doings, here, performOrSay } from "./doing";

/** Larger pastes are files: they are opened, not pasted. */
const LONGEST_PASTE = 1_000_000;

export function createAgentClipboard(parts: ActionParts): AgentClipboard {
  const { document, engine, messages } = parts;
  const refuse = (text: string) => void messages.say({ tone: "problem", title: "Nothing was pasted.", text });
  return {
    copied() {
      const { scene, selection, keyframe } = here(document);
      return agentsAsText(scene, keyframe, selectedAgents(scene, selection));
    },
    async paste(text) {
      const table = text.length <= LONGEST_PASTE ? textAsKeyframes(text) : null;
      if (!table) {
        refuse("Agents are pasted as lines of name, x and y in meters, parted by tabs.");
        return;
      }
      try {
        const { scene: pasted } = await engine.open(table);
        const { scene, selection, keyframe } = here(document);
        const pasting = pasteAt(scene, keyframe, selection, pasted);
        if (pasting.kind === "refused") refuse(pasting.reason);
        else if (performOrSay(parts, pasting.command, "They are there already, or the show has no room for more.")) {
          document.selection.value = { kind: "agents", agents: new Set(pasting.agents) };
        }
      } catch (error) {
        if (!(error instanceof EngineError)) throw error;
        refuse(`${error.problem.what} (${error.problem.where})`);
      }
    },
  };
}

export function clipboardActions(parts: ActionParts, agents: AgentClipboard): Doings<"copy" | "paste"> {
  const { document, messages, clipboard } = parts;
  const blocked = () =>
    messages.say({
      tone: "problem",
      title: "The browser keeps the clipboard to itself.",
      text: "Use the keys instead.",
    });
  return {
    copy: {
      isEnabled: computed(() => selectedAgents(document.scene.value, document.selection.value).size > 0),
      run() {
        const text = agents.copied();
        clipboard.writeText(text).then(() => messages.announce("Copied"), blocked);
      },
    },
    paste: {
      run() {
        clipboard.readText().then((text) => agents.paste(text), blocked);
      },
    },
  };
}
