import { computed, effect, signal } from "@preact/signals";
import { h } from "preact";
import { createDocument } from "./document/create-store";
import { emptyScene } from "./document/defaults";
import { Formation } from "./document/formation";
import { laterAutosave } from "./document/later-autosave";
import { openScene } from "./document/open-scene";
import { mainTrack } from "./document/scene";
import { createEngine } from "./engine/create-engine";
import { createPlanner } from "./engine/create-planner";
import { createCrew } from "./engine/crew";
import { compileEngine } from "./engine/module";
import { type ArrivalParts, arrive, hasAgents, linkIn, openLink } from "./files/arrival";
import type { Desk } from "./files/desk";
import { FIRST_EXAMPLE, readExample } from "./files/examples";
import type { IntakeParts } from "./files/intake";
import { keepScene, sayWhenNotKept } from "./files/keep";
import { withdrawOutdated } from "./files/outdated";
import { createReader, problemFrom, sentence } from "./files/reader";
import type { Aside } from "./panels/aside";
import { createActions } from "./panels/create-actions";
import { createDialogs, type Dialogs } from "./panels/dialogs/dialogs";
import { giveUp } from "./panels/dialogs/give-up";
import type { ActionParts } from "./panels/doing";
import { followPlayhead } from "./panels/follow-playhead";
import { laterHandiwork } from "./panels/later-handiwork";
import { lazily } from "./panels/lazily";
import { createMessages, NOT_LOADED, OPENING } from "./panels/messages";
import { mountPanels } from "./panels/mount";
import { releaseFocus } from "./panels/release-focus";
import { createSeen, frontWhenAsked } from "./panels/seen";
import { showOf } from "./panels/show-of";
import type { Studio } from "./panels/studio";
import { Timeline } from "./panels/timeline/timeline";
import { createPlayback } from "./playback/playback";
import { showDuration } from "./playback/show";
import { createView } from "./stage/create-view";
import { createStage } from "./stage/stage";
import type { Projection } from "./stage/view";
import { rememberRuler, rememberTheme } from "./theme/remember";
import { createToolbox } from "./tools/create-toolbox";

/** The composition root: the only file that knows every folder. */

const store = createDocument(emptyScene());
/** What need not be kept on this device: nothing yet, what lies there already, an example nobody has touched. */
let settled = store.scene.peek();
/** Whether the person was quicker than the engine: what they drew is not to be lost to what was on its way. */
const hasBegun = () => store.undoLabel.peek() !== null;
const playback = createPlayback(computed(() => showDuration(mainTrack(store.scene.value))));
const messages = createMessages();
const dialogs = createDialogs();
const autosave = laterAutosave();
followPlayhead(store, playback);
sayWhenNotKept(autosave, messages);

const aside = signal<Aside | null>(null);
const crew = createCrew(compileEngine(), (title, text) => messages.say({ tone: "problem", title, text }));
const engine = createEngine(crew);
const planner = createPlanner({ scene: store.scene, isDragging: store.isDragging, time: playback.time, crew });

const projection = signal<Projection>("plan");
const fetchFront = () => import("./front").then((part) => part.front);
const front = frontWhenAsked(projection, fetchFront, () => messages.say(NOT_LOADED));
const seen = createSeen(store, planner, front);
const view = createView(seen.document.scene, projection);
rememberTheme(view.theme);
rememberRuler(view.ruler);
effect(() => {
  void front.value;
  view.fit();
});

function positionsAt(time: number): Formation {
  const show = showOf(seen).peek();
  const xy = new Float32Array(show.agentCount * 2);
  const heights = show.isSpatial ? new Float32Array(show.agentCount) : null;
  show.positionsInto(time, xy);
  if (heights) show.heightsInto(time, heights);
  return new Formation(Float64Array.from(xy), heights && Float64Array.from(heights));
}

const toolbox = createToolbox({
  document: seen.document,
  view,
  playback,
  engine,
  ties: planner.ties,
  shownXy: () => positionsAt(playback.time.peek()).xy,
  announce: messages.announce,
  warn: (title, text) => messages.say({ tone: "problem", title, text }),
});

const reader = createReader(engine, messages);
const intake: IntakeParts = {
  engine,
  reader,
  document: store,
  messages,
  aside,
  onOpened: showOpened,
  onPicture: (file) => dialogs.show({ kind: "shape", from: "picture", file }),
};

function showFromStart(): void {
  playback.pause();
  playback.seek(0);
  view.fit();
  view.lens.peek()?.fit();
}

/** Somebody opened another scene: what lay beside the one before, such as a recording, belongs to that one. */
function showOpened(): void {
  aside.value = null;
  releaseFocus();
  showFromStart();
}

/** Nothing moves by itself for a person who asked for less motion. */
function playWhereWelcome(): void {
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) playback.play();
}

async function fetchDesk(): Promise<Desk> {
  const { createDesk } = await import("./files/desk");
  const address = location.origin + location.pathname;
  const onExample = () => {
    showOpened();
    playWhereWelcome();
  };
  return createDesk({ document: store, engine, planner, messages, intake, address, onExample });
}

function atDesk(act: (desk: Desk) => void): void {
  fetchDesk().then(act, () => messages.say(NOT_LOADED));
}

const DialogHost = lazily<{ dialogs: Dialogs }>(async () => {
  const [{ DialogHost: Host }, { services }] = await Promise.all([import("./panels/dialogs/host"), fetchDesk()]);
  return (props) => h(Host, { ...props, services });
}, giveUp);

const actionParts: ActionParts = {
  document: seen.document,
  playback,
  view,
  toolbox,
  messages,
  aside,
  engine,
  planner,
  clipboard: navigator.clipboard,
  positionsAt,
  cancelGesture: toolbox.cancel,
  files: {
    new: () => {
      openScene(store, emptyScene(), "New scene");
      showOpened();
    },
    open: () => atDesk((desk) => desk.open()),
    save: () => atDesk((desk) => void desk.save()),
    export: () => dialogs.show({ kind: "export" }),
    share: () => dialogs.show({ kind: "share" }),
    examples: () => dialogs.show({ kind: "examples" }),
    help: () => dialogs.show({ kind: "help" }),
    palette: () => dialogs.show({ kind: "palette" }),
    compare: () => dialogs.show({ kind: "compare", segments: null }),
    picture: () => dialogs.show({ kind: "shape", from: "picture", file: null }),
    text: () => dialogs.show({ kind: "shape", from: "text", file: null }),
  },
};
const handiwork = laterHandiwork(actionParts);
const actions = createActions(actionParts, handiwork);
const studio: Studio = {
  document: store,
  seen,
  playback,
  view,
  planner,
  engine,
  toolbox,
  actions,
  messages,
  aside,
};

const stageHost = document.createElement("div");
const isSettled = signal(false);
createStage(stageHost, {
  scene: seen.document.scene,
  isSettled,
  selection: store.selection,
  segments: seen.planner.segments,
  ties: planner.ties,
  playback,
  view,
  toolbox,
});

const root = document.getElementById("app");
if (!root) throw new Error("the page has a place for the app");
mountPanels(root, studio, {
  stageHost,
  savedText: autosave.words,
  Timeline,
  Dialogs: () => (dialogs.shown.value ? h(DialogHost, { dialogs }) : null),
});

/** The page is drawn; now it can be touched. */
async function attachHands(): Promise<void> {
  try {
    const hands = await import("./hands");
    hands.attachHands({
      stageHost,
      toolbox,
      view,
      actions,
      clipboard: handiwork.clipboard,
      intake,
      typeAhead: dialogs.typeAhead,
    });
  } catch {
    messages.say(NOT_LOADED);
  }
}

const OPEN_LINKED = "Open the linked scene";

const arrival: ArrivalParts = {
  reader,
  async saved() {
    const restored = await autosave.restore();
    if (restored.kind === "text") {
      if (restored.isNewestDamaged) {
        messages.say({
          tone: "problem",
          title: "Your last change could not be read back.",
          text: "This is the scene as it was kept before it.",
        });
      }
      return restored.text;
    }
    if (restored.kind === "damaged") {
      messages.say({
        tone: "problem",
        title: "Your last scene could not be read back.",
        text: "Its copy on this device is damaged.",
      });
    }
    return null;
  },
  restore(scene) {
    if (hasBegun()) openScene(store, scene, "Open your last scene");
    else store.start(scene);
    settled = scene;
    isSettled.value = true;
    showFromStart();
  },
  open(scene, label) {
    openScene(store, scene, label);
    showOpened();
    playWhereWelcome();
  },
  async showFirstExample() {
    const opened = await reader.read(await readExample(FIRST_EXAMPLE), "The example");
    if (!opened || hasBegun()) return;
    store.start(opened.scene);
    settled = opened.scene;
    showFromStart();
    playWhereWelcome();
    // That a link was refused is worth more.
    if (messages.shown.peek().length > 0) return;
    const text = "Press New to draw formations of your own.";
    messages.say({ tone: "good", about: OPENING, title: "This is an example.", text });
  },
  hasOwn: () => hasAgents(store.scene.peek()),
  async askToOpen() {
    const question = {
      title: "Open the linked scene?",
      text: "Yours stays on this device, one undo away.",
    };
    return (await dialogs.ask(question, [OPEN_LINKED, "Keep mine"])) === OPEN_LINKED;
  },
};

addEventListener("hashchange", () => {
  const link = linkIn(location.hash);
  if (link) void openLink(link, arrival);
});

/** Not awaited: what is fetched later may need this module, which ends only when nothing in it is waited for. */
async function begin(): Promise<void> {
  await attachHands();
  try {
    await arrive(arrival);
  } catch (error) {
    messages.say({ tone: "problem", title: "The first scene did not open.", text: sentence(problemFrom(error)) });
  }
  isSettled.value = true;
  keepScene(store, autosave, engine, settled);
  withdrawOutdated(store, messages);
}

void begin();
