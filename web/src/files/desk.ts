import { openScene } from "../document/open-scene";
import type { Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import type { Engine, Planner } from "../engine/api";
import { type DialogServices, NOT_ACCEPTED } from "../panels/dialogs/services";
import type { Messages } from "../panels/messages";
import { withChosen } from "./chosen";
import { download, fileName } from "./download";
import { pickFile } from "./drop";
import { readExample, readRecording } from "./examples";
import { createIntake, type IntakeParts } from "./intake";
import { problemFrom, sentence } from "./reader";

/** What is done with a scene as a whole when somebody asks: fetched then. */
export interface Desk {
  /** Asks for a file and opens it. */
  open(): void;
  /** Hands the person the scene as a file. */
  save(): Promise<void>;
  readonly services: DialogServices;
}

export interface DeskParts {
  readonly document: DocumentStore;
  readonly engine: Pick<Engine, "writeScene">;
  readonly planner: Pick<Planner, "segments">;
  readonly messages: Messages;
  readonly intake: IntakeParts;
  /** The page's address, without a fragment. */
  readonly address: string;
  /** An example took the scene's place: it is shown from its start. */
  onExample(): void;
}

export function createDesk({ document, engine, planner, messages, intake, address, onExample }: DeskParts): Desk {
  const { openFile, openText } = createIntake(intake);

  /** Nobody accepted what is only previewed; what auto takes for it says nothing of the scene without it. */
  function sceneToShare(): Scene {
    const accepted = document.accepted.peek();
    return isOnTrial() ? accepted : withChosen(accepted, planner.segments.peek());
  }

  function isOnTrial(): boolean {
    return document.scene.peek() !== document.accepted.peek();
  }

  function saveFile(ending: string, text: string, type: string): void {
    download(fileName(document.accepted.peek().title, ending), text, type);
  }

  return {
    open: () => pickFile((file) => void openFile(file)),
    async save() {
      try {
        const lacksTrial = isOnTrial();
        saveFile("eigenform.json", await engine.writeScene(sceneToShare()), "application/json");
        const title = "The scene file is in your downloads.";
        if (lacksTrial) messages.say({ tone: "good", title, text: NOT_ACCEPTED });
        else messages.announce(title);
      } catch (error) {
        messages.say({
          tone: "problem",
          title: "The scene was not saved as a file.",
          text: sentence(problemFrom(error)),
        });
      }
    },
    services: {
      address,
      sceneToShare,
      isOnTrial,
      loadExamples: async () => (await import("./gallery/sections")).SECTIONS,
      loadPreview: async (id) => (await import("./gallery/previews")).loadPreview(id),
      async openExample({ id, title, view }) {
        try {
          if (view?.kind === "recording") return await openText(await readRecording(id), title);
          const opened = await intake.reader.read(await readExample(id), title);
          if (!opened) return false;
          openScene(document, opened.scene, `Open ${title}`);
          onExample();
          return true;
        } catch (error) {
          intake.reader.refuse(title, problemFrom(error));
          return false;
        }
      },
      saveFile,
    },
  };
}
