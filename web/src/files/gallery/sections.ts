import type { ExampleSection } from "../../panels/dialogs/services";
import { CROWDS } from "./crowds";
import { FORMATION_CONTROL } from "./formation-control";
import { SHOWS } from "./shows";

/** What the gallery lists, in its order; a card's `id` names its files. */
export const SECTIONS: readonly ExampleSection[] = [
  { title: "Shows", cards: SHOWS },
  { title: "Formation control", cards: FORMATION_CONTROL },
  { title: "Crowds", cards: CROWDS },
];
