import { type ReadonlySignal, signal } from "@preact/signals";

/** Something to decide, in words; leaving the dialog is the last choice. */
export interface Question {
  readonly kind: "question";
  readonly title: string;
  readonly text: string;
  readonly choices: readonly QuestionChoice[];
}

export interface QuestionChoice {
  readonly label: string;
  run(): void;
}

/** What went wrong, with all that is known of it. */
export interface ProblemDetails {
  readonly kind: "problem";
  readonly title: string;
  readonly text: string;
  /** What and where, a line each. */
  readonly details: readonly string[];
}

/** Ways side by side or in a table: the transition at hand, or transitions between the same formations. */
export interface Comparison {
  readonly kind: "compare";
  /** Two at least, which may be one twice; null: whichever is at hand. */
  readonly segments: readonly number[] | null;
  /** What is tried side by side first; absent: the transitions as they are. */
  readonly preset?: string;
  /** What the table is of first; absent: all methods. */
  readonly table?: string;
  /** It opens with the table. */
  readonly isTable?: boolean;
}

/** A formation from a picture, text or a path; the picture, when it came with the wish. */
export interface ShapeOrigin {
  readonly kind: "shape";
  readonly from: "picture" | "text";
  readonly file: File | null;
}

export type DialogRequest =
  | { readonly kind: "share" | "examples" | "help" | "palette" | "export" }
  | Comparison
  | ShapeOrigin
  | Question
  | ProblemDetails;

/** What is open over the page: one dialog at a time. */
export interface Dialogs {
  readonly shown: ReadonlySignal<DialogRequest | null>;
  show(request: DialogRequest): void;
  /** A key while a dialog is asked for and has not the focus yet: whether it is the dialog's, as the first of what is typed there. */
  typeAhead(key: string): boolean;
  /** What was typed ahead, once. */
  takeTyped(): string;
  /** Leaves the dialog; a question takes its last choice. */
  close(): void;
  /** Takes a question's choice, and that alone. */
  answer(choice: QuestionChoice): void;
  /** Answers with the label chosen. */
  ask(question: Omit<Question, "kind" | "choices">, labels: readonly string[]): Promise<string>;
}

export function createDialogs(): Dialogs {
  const shown = signal<DialogRequest | null>(null);
  let typed = "";

  function leave(): void {
    const request = shown.peek();
    shown.value = null;
    if (request?.kind === "question") request.choices.at(-1)?.run();
  }

  const dialogs: Dialogs = {
    shown,
    show(request) {
      // A question that is pushed aside is answered too, or whoever asked would wait for ever.
      leave();
      typed = "";
      shown.value = request;
    },
    typeAhead(key) {
      if (!shown.peek()) return false;
      if (key.length === 1) typed += key;
      return true;
    },
    takeTyped() {
      const taken = typed;
      typed = "";
      return taken;
    },
    close: leave,
    answer(choice) {
      shown.value = null;
      choice.run();
    },
    ask(question, labels) {
      return new Promise((resolve) => {
        const choices = labels.map((label) => ({ label, run: () => resolve(label) }));
        dialogs.show({ kind: "question", ...question, choices });
      });
    },
  };
  return dialogs;
}
