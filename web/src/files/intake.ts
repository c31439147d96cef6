import { effect, type Signal } from "@preact/signals";
import { NEW_MINIMUM_DISTANCE } from "../document/defaults";
import { openScene } from "../document/open-scene";
import { isWithoutDistance } from "../document/queries";
import { mainTrack, type Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { lengthWithUnit } from "../document/units";
import type { Engine, Opened } from "../engine/api";
import type { Aside } from "../panels/aside";
import { type Message, type Messages, OPENING } from "../panels/messages";
import { problemFrom, type Reader } from "./reader";

/** Larger files are refused before they are read; the engine has the same limit. */
const FILE_LIMIT = 64 * 1024 * 1024;

/** What a person brings from outside becomes the scene: files and drops. A refusal leaves it as it was. */
export interface Intake {
  /** Opens text as a new scene; answers whether it did. */
  openText(text: string, name: string): Promise<boolean>;
  openFile(file: File): Promise<boolean>;
  /** Opens the first of them, and says so where there are more. */
  openFiles(files: readonly File[]): Promise<boolean>;
}

export interface IntakeParts {
  readonly engine: Engine;
  readonly reader: Reader;
  readonly document: DocumentStore;
  readonly messages: Messages;
  readonly aside: Signal<Aside | null>;
  /** The scene was replaced: show all of it from its start. */
  onOpened(): void;
  /** A picture is no scene: a formation can be made from it. */
  onPicture(file: File): void;
}

/** A table has no title: it is called by its file. */
function titled({ scene, source }: Opened, name: string): Scene {
  if (source !== "csv" || scene.title !== "") return scene;
  return { ...scene, title: name.replace(/\.[a-z]+$/i, "").slice(0, 200) };
}

function isPicture({ type, name }: File): boolean {
  return type.startsWith("image/") || /\.(?:png|jpe?g|webp|svg)$/i.test(name);
}

/** How the engine refuses a motion where a scene is wanted. */
const IS_RECORDING = "recording";

export function createIntake(parts: IntakeParts): Intake {
  const { engine, document, messages, aside, onOpened, onPicture } = parts;
  const { refuse } = parts.reader;

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
    const scene = titled(opened, name);
    openScene(document, scene, `Open ${name}`);
    onOpened();
    const notes = [...opened.notes, ...(await crossings(scene))];
    const said = { tone: "good", about: OPENING, title: `${name} is open.` } as const;
    const offers = opened.source === "csv" && isWithoutDistance(scene) ? await keepingApart(scene) : null;
    if (offers) {
      const text = [...notes, "A table names no distance, so nobody is kept apart on the way."].join(" ");
      dismissOnceApart(messages.say({ ...said, text, actions: offers }));
    } else {
      messages.say({ ...said, text: notes.join(" ") || "The scene before it is one undo away." });
    }
    return true;
  }

  /** What is said of paths that cross themselves; nothing where they cannot be looked at. */
  async function crossings(scene: Scene): Promise<readonly string[]> {
    if (mainTrack(scene).segments.every(({ path }) => path === null)) return [];
    try {
      return (await import("../panels/travel/crossings")).crossings(scene);
    } catch {
      return [];
    }
  }

  /** At the distance of new scenes; nothing where the command does not come. */
  async function keepingApart({ stage }: Scene): Promise<Message["actions"] | null> {
    try {
      const { keepApart } = await import("../document/commands/keep-apart");
      const run = () => document.perform(keepApart(NEW_MINIMUM_DISTANCE));
      return [{ label: `Keep ${lengthWithUnit(NEW_MINIMUM_DISTANCE, stage.units)} apart`, run }];
    } catch {
      return null;
    }
  }

  /** Whoever gives the scene a distance needs no offer of one. */
  function dismissOnceApart(message: number): void {
    const stop = effect(() => {
      if (isWithoutDistance(document.scene.value)) return;
      messages.dismiss(message);
      queueMicrotask(() => stop());
    });
  }

  async function openFile(file: File): Promise<boolean> {
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
  }

  return {
    openText,
    openFile,
    async openFiles(files) {
      const [first] = files;
      if (!first) return false;
      if (files.length > 1) {
        const text = `Of ${files.length} files only ${first.name} is opened.`;
        messages.say({ tone: "problem", title: "One file at a time.", text });
      }
      return openFile(first);
    },
  };
}
