import { type ReadonlySignal, signal } from "@preact/signals";

/** What the person should know: happened, and what to do. */
export interface Message {
  readonly id: number;
  readonly tone: "good" | "problem" | "question";
  /** What happened, in a few words. */
  readonly title: string;
  /** What to do, or the details. */
  readonly text: string;
  readonly actions: readonly { readonly label: string; run(): void }[];
}

/** Toasts at the bottom of the stage; announced to screen readers. */
export interface Messages {
  readonly shown: ReadonlySignal<readonly Message[]>;
  /** Read out by the status region, shown nowhere. */
  readonly announcement: ReadonlySignal<string>;
  say(message: Omit<Message, "id" | "actions"> & { readonly actions?: Message["actions"] }): number;
  announce(text: string): void;
  dismiss(id: number): void;
}

/** What is said when a part that is fetched later did not come. */
export const NOT_LOADED = {
  tone: "problem",
  title: "A part of the page did not load.",
  text: "Check the connection and try it again; the scene is unchanged.",
} as const;

export function createMessages(): Messages {
  const shown = signal<readonly Message[]>([]);
  const announcement = signal("");
  let last = 0;
  return {
    shown,
    announcement,
    say(message) {
      last += 1;
      // The same thing said again moves down instead of piling up.
      const others = shown.value.filter((other) => other.title !== message.title || other.text !== message.text);
      shown.value = [...others.slice(-2), { actions: [], ...message, id: last }];
      announcement.value = `${message.title} ${message.text}`;
      return last;
    },
    announce(text) {
      announcement.value = text;
    },
    dismiss(id) {
      shown.value = shown.value.filter((message) => message.id !== id);
    },
  };
}
