import type { ComponentType } from "preact";
import { lazily } from "../lazily";
import { IS_SAFE, Safely, WENT_WRONG } from "../safely";
import type { DialogRequest, Dialogs } from "./dialogs";
import { Frame } from "./frame";
import { giveUp } from "./give-up";
import type { DialogServices } from "./services";

/** What every dialog is given. */
export interface DialogProps<Request extends DialogRequest = DialogRequest> {
  readonly request: Request;
  readonly services: DialogServices;
  readonly dialogs: Dialogs;
}

type Kind = DialogRequest["kind"];
type OfKind<K extends Kind> = Extract<DialogRequest, { readonly kind: K }>;

const DIALOGS: { readonly [K in Kind]: ComponentType<DialogProps<OfKind<K>>> } = {
  share: lazily(() => import("./share").then((part) => part.ShareDialog), giveUp),
  examples: lazily(() => import("./examples").then((part) => part.ExamplesDialog), giveUp),
  help: lazily(() => import("./help").then((part) => part.HelpDialog), giveUp),
  palette: lazily(() => import("./palette").then((part) => part.PaletteDialog), giveUp),
  export: lazily(() => import("./export").then((part) => part.ExportDialog), giveUp),
  compare: lazily(() => import("../compare/compare").then((part) => part.CompareDialog), giveUp),
  shape: lazily(() => import("../shape-dialog/shape-dialog").then((part) => part.ShapeDialog), giveUp),
  question: lazily(() => import("./question").then((part) => part.QuestionDialog), giveUp),
  problem: lazily(() => import("./question").then((part) => part.ProblemDialog), giveUp),
};

/** Shows the dialog asked for, one at a time; each is fetched when it is first opened. */
export function DialogHost({ dialogs, services }: { dialogs: Dialogs; services: DialogServices }) {
  const request = dialogs.shown.value;
  if (!request) return null;
  // The dialog is the one of the request's kind, which the types of a record by kind cannot say.
  const Dialog = DIALOGS[request.kind] as ComponentType<DialogProps>;
  return (
    <Safely key={request.kind} instead={(again) => <Failed onAgain={again} onClose={dialogs.close} />}>
      <Dialog request={request} services={services} dialogs={dialogs} />
    </Safely>
  );
}

function Failed({ onAgain, onClose }: { onAgain(): void; onClose(): void }) {
  return (
    <Frame title={WENT_WRONG} size="small" onClose={onClose}>
      <p class="dialog-text">{IS_SAFE}</p>
      <div class="dialog-answers">
        <button type="button" class="button primary" autofocus onClick={onAgain}>
          Try again
        </button>
      </div>
    </Frame>
  );
}
