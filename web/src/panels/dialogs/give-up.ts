import { sayNotLoaded } from "../lazily";
import type { Studio } from "../studio";
import type { Dialogs } from "./dialogs";

/** A dialog that does not come is closed, so that the next wish for it tries again. */
export function giveUp(studio: Studio, { dialogs }: { readonly dialogs: Dialogs }): void {
  sayNotLoaded(studio);
  dialogs.close();
}
