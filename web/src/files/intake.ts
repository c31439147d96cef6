import type { Signal } from "@preact/signals";
import { openScene } from "../document/open-scene";
import type { Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { type Engine, EngineError, type EngineProblem, type Opened } from "../engine/api";
import type { Aside } from "../panels/aside";
import type { Messages } from "../panels/messages";

/** Larger files are refused before they are read; the engine has the same limit. */
const FILE_LIMIT = 64 * 1024 * 1024;

/** Everything that comes from outside: files, drops, links, examples. A refusal leaves the scene as it was. */
export interface Intake {
  /** Opens text as a new scene; answers whether it did. */
  openText(text: string, name: string): Promise<boolean>;
  openFile(file: File): Promise<boolean>;
  /** Reads text through the engine without opening it; null after saying why not. */
  read(text: string, name: string): Promise<Opened | null>;
}

export interface IntakeParts {
  readonly engine: Engine;
  readonly document: DocumentStore;
  readonly messages: Messages;
  readonly aside: Signal<Aside | null>;
  /** The scene was replaced: show all of it from its start. */
  onOpened(): void;
  /** A picture is no scene: a formation can be made from it. */
  onPicture(file: File): void;
}

/** The problem as a person reads it, what and where: a sentence, of which the engine says the words only. */
export function sentence({ what, where }: EngineProblem): string {
  const said = what.charAt(0).toUpperCase() + what.slice(1).replace(/\.$/, "");
  return where ? `${said} (${where}).` : `${said}.`;
}

/** A table has no title: it is called by its file. */
function titled({ scene, source }: Opened, name: string): Scene {
  if (source !== "csv" || scene.title !== "") return scene;
  return { ...scene, title: name.replace(/\.[a-z]+$/i, "").slice(0, 200) };
}

export function problemFrom(error: unknown): EngineProblem {
  if (error instanceof EngineError) return error.problem;
  return { code: "unexpected", what: error instanceof Error ? error.message : String(error), where: "" };
}

function isPicture({ type, name }: File): boolean {
  return type.startsWith("image/") || /\.(?:png|jpe?g|webp|svg)$/i.test(name);
}

/** How the engine refuses a motion where a scene is wanted. */
const IS_RECORDING = "recording";

export function createIntake({ engine, document, messages, aside, onOpened, onPicture }: IntakeParts): Intake {
  function refuse(name: string, problem: EngineProblem): void {
    messages.say({
      tone: "problem",
      title: `${name} was not opened.`,
      text: `${sentence(problem)} Your scene is unchanged.`,
    });
  }

  async function read(text: string, name: string): Promise<Opened | null> {
    try {
      return await engine.open(text);
    } catch (error) {
      refuse(name, problemFrom(error));
      return null;
    }
  }

  async function openRecorded(text: string, name: string): Promise<boolean> {
    try {
      const recorded = await engine.openRecording(text);
      (await import("../panels/recording/state")).openRecording(name, recorded);
      aside.value = { kind: "recording" };
      return true;
    } catch (error) {
      refuse(name, problemFrom(error));
      return false;
    }
  }

  async function openText(text: string, name: string): Promise<boolean> {
    let opened: Opened;
    try {
      opened = await engine.open(text);
    } catch (error) {
      const problem = problemFrom(error);
      if (problem.code === IS_RECORDING) return openRecorded(text, name);
      refuse(name, problem);
      return false;
    }
    openScene(document, titled(opened, name), `Open ${name}`);
    onOpened();
    const notes = opened.notes.join(" ");
    messages.say({ tone: "good", title: `${name} is open.`, text: notes || "The scene before it is one undo away." });
    return true;
  }

  return {
    read,
    openText,
    async openFile(file) {
      if (isPicture(file)) {
        onPicture(file);
        return true;
      }
      if (file.size > FILE_LIMIT) {
        refuse(file.name, { code: "file-too-large", what: "A file may have at most 64 MiB.", where: "" });
        return false;
      }
      try {
        return await openText(await file.text(), file.name);
      } catch (error) {
        refuse(file.name, problemFrom(error));
        return false;
      }
    },
  };
}
