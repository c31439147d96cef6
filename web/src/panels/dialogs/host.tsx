import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { DialogRequest, Dialogs } from "./dialogs";
import type { DialogServices } from "./services";

/** What every dialog is given. */
export interface DialogProps<Request extends DialogRequest = DialogRequest> {
  readonly request: Request;
  readonly services: DialogServices;
  readonly dialogs: Dialogs;
}

type Kind = DialogRequest["kind"];
type OfKind<K extends Kind> = Extract<DialogRequest, { readonly kind: K }>;
type Dialog = ComponentType<DialogProps<never>>;

/** Each dialog is a chunk of its own, fetched when it is first opened. */
const CHUNKS: { readonly [K in Kind]: () => Promise<ComponentType<DialogProps<OfKind<K>>>> } = {
  share: () => import("./share").then((chunk) => chunk.ShareDialog),
  examples: () => import("./examples").then((chunk) => chunk.ExamplesDialog),
  help: () => import("./help").then((chunk) => chunk.HelpDialog),
  palette: () => import("./palette").then((chunk) => chunk.PaletteDialog),
  export: () => import("./export").then((chunk) => chunk.ExportDialog),
  question: () => import("./question").then((chunk) => chunk.QuestionDialog),
  problem: () => import("./question").then((chunk) => chunk.ProblemDialog),
};

const loaded = new Map<Kind, Dialog>();

/** Shows the dialog asked for, one at a time. */
export function DialogHost({ dialogs, services }: { dialogs: Dialogs; services: DialogServices }) {
  const request = dialogs.shown.value;
  const Shown = useChunk(request?.kind ?? null);
  if (!request || !Shown) return null;
  // The chunk is the one of the request's kind.
  const Dialog = Shown as ComponentType<DialogProps>;
  return <Dialog request={request} services={services} dialogs={dialogs} />;
}

function useChunk(kind: Kind | null): Dialog | null {
  const [, setArrived] = useState(0);
  useEffect(() => {
    if (kind === null || loaded.has(kind)) return;
    let isWanted = true;
    void CHUNKS[kind]().then((chunk) => {
      loaded.set(kind, chunk as Dialog);
      if (isWanted) setArrived((count) => count + 1);
    });
    return () => {
      isWanted = false;
    };
  }, [kind]);
  return kind === null ? null : (loaded.get(kind) ?? null);
}
