import type { ExampleSection } from "../../panels/dialogs/services";
import { CROWDS } from "./crowds";
import { FORMATION_CONTROL } from "./formation-control";
import { SHOWS } from "./shows";

/** What the gallery lists, in its order; a card's `id` names its files. */
export const SECTIONS: readonly ExampleSection[] = [
  { title: "Shows", cards: SHOWS },
  {
    title: "Formation control",
    source: "Figures of Spectral-Based Group Formation Control, 2009",
    cards: FORMATION_CONTROL,
  },
  { title: "Crowds", source: "Figures of Collective Crowd Formation Transform, 2015", cards: CROWDS },
];
