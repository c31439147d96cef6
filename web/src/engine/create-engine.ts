import type { Formation } from "../document/formation";
import type { Scene } from "../document/scene";
import type { Engine } from "./api";
import { EngineError } from "./api";
import type { Crew } from "./crew";
import { type Ledger, sceneFrom } from "./ledger";
import { WorkerGone, type WorkerLink } from "./link";
import type { CallName, Calls } from "./protocol";
import { createWorkshop } from "./workshop";

/** A question that dies with its worker is asked once more of the next. */
const TRIES = 2;

async function ask<Name extends CallName>(
  crew: Pick<Crew, "desk">,
  name: Name,
  askOf: (link: WorkerLink) => Calls[Name]["ask"],
): Promise<Calls[Name]["answer"]> {
  for (let tries = 1; ; tries += 1) {
    try {
      const link = await crew.desk();
      return await link.call(name, askOf(link)).answer;
    } catch (error) {
      if (!(error instanceof WorkerGone)) throw error;
      if (tries >= TRIES) {
        throw new EngineError({
          code: "engine-stopped",
          what: "The engine stopped while it worked on this.",
          where: "",
        });
      }
    }
  }
}

/** The ledger of a worker whose steps are heard. */
function listening(link: WorkerLink, tell: (progress: number) => void): Ledger {
  link.onPlan = (message) => {
    if (message.kind === "progress") tell(message.progress);
  };
  return link.ledger;
}

export function createEngine(crew: Crew): Engine {
  const workshop = createWorkshop();
  return {
    health: crew.health,
    async open(text) {
      const of = () => ({ text });
      // Tables are read by the workshop: a first visit carries no reader of them.
      const opened = (await ask(crew, "open", of)) ?? (await ask(workshop, "openAny", of));
      return { scene: sceneFrom(opened.scene), source: opened.source, notes: opened.notes };
    },
    openRecording: (text) => ask(workshop, "openRecording", () => ({ text })),
    writeScene: (scene: Scene) => ask(crew, "writeScene", (link) => ({ scene: link.ledger.message(scene) })),
    writeKeyframes: (scene: Scene) =>
      ask(workshop, "writeKeyframes", (link) => ({ scene: link.ledger.message(scene) })),
    writeMotion: (scene: Scene, format) =>
      ask(workshop, "writeMotion", (link) => ({ scene: link.ledger.message(scene), format })),
    link: (scene: Scene, precision) =>
      ask(crew, "link", (link) => ({ scene: link.ledger.message(scene), isShort: precision === "short" })),
    assign: (source: Formation, target: Formation) =>
      ask(crew, "assign", () => ({ source: source.xy, target: target.xy })),
    async findPlaces(scene, question, tell) {
      const of = (link: WorkerLink) => ({ ...question, scene: listening(link, tell).message(scene) });
      return JSON.parse((await ask(workshop, "assignment", of)) ?? "null");
    },
    async findAlike(scene, question, tell) {
      const of = (link: WorkerLink) => ({ ...question, scene: listening(link, tell).message(scene) });
      return JSON.parse((await ask(workshop, "affinity", of)) ?? "null");
    },
    stopErrand: () => void workshop.opened()?.then((link) => link.call("cancel", null).answer.catch(() => {})),
    async proposeGroups(scene: Scene, keyframe, agents, way) {
      const of = (link: WorkerLink) => ({ scene: link.ledger.message(scene), keyframe, agents, way });
      return JSON.parse(await ask(workshop, "proposeGroups", of));
    },
  };
}
