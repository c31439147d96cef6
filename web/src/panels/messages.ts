import { type ReadonlySignal, signal } from "@preact/signals";

/** What the person should know: happened, and what to do. */
export interface Message {
  readonly id: number;
  readonly tone: "good" | "problem" | "question";
  /** What it is about, the title unless told: the newest takes the place of others about the same. */
  readonly about: string;
  /** What happened, in a few words. */
  readonly title: string;
  /** What to do, or the details. */
  readonly text: string;
  readonly actions: readonly { readonly label: string; run(): void }[];
}

/** Read out by the status region, shown nowhere. */
export interface Announcement {
  readonly id: number;
  readonly text: string;
}

/** Toasts at the bottom of the stage; announced to screen readers. */
export interface Messages {
  readonly shown: ReadonlySignal<readonly Message[]>;
  /** The last few: each is read out as it comes, also what is said again or in the same breath. */
  readonly announcements: ReadonlySignal<readonly Announcement[]>;
  say(message: Pick<Message, "tone" | "title" | "text"> & Partial<Pick<Message, "about" | "actions">>): number;
  announce(text: string): void;
  dismiss(id: number): void;
  /** Takes back what was said about something. */
  withdraw(about: string): void;
}

/** What is said when a part that is fetched later did not come. */
export const NOT_LOADED = {
  tone: "problem",
  title: "A part of the page did not load.",
  text: "Check the connection and try it again; nothing is lost.",
} as const;

/** Toasts that are seen at once, and announcements that are kept. */
const FEW = 3;

/** What is about opening a scene, whichever and however it went. */
export const OPENING = "opening";

export function createMessages(): Messages {
  const shown = signal<readonly Message[]>([]);
  const announcements = signal<readonly Announcement[]>([]);
  let last = 0;

  function announce(text: string): void {
    last += 1;
    announcements.value = [...announcements.peek(), { id: last, text }].slice(-FEW);
  }

  return {
    shown,
    announcements,
    announce,
    say(message) {
      announce(`${message.title} ${message.text}`);
      const about = message.about ?? message.title;
      const others = shown.peek().filter((other) => other.about !== about);
      shown.value = [...others, { actions: [], ...message, about, id: last }].slice(-FEW);
      return last;
    },
    dismiss(id) {
      shown.value = shown.peek().filter((message) => message.id !== id);
    },
    withdraw(about) {
      shown.value = shown.peek().filter((message) => message.about !== about);
    },
  };
}
