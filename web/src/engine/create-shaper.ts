import type { ShapeAnswer, ShapeQuestion, ShapeRequest } from "./shape-protocol";

/** Finds places in shapes, for as long as somebody makes one. */
export interface Shaper {
  /** Answers come one by one, the last of them slots or a refusal; none more for a request before it. */
  ask(request: ShapeRequest, onAnswer: (answer: ShapeAnswer) => void): void;
  /** Ends the worker and whatever it was at. */
  end(): void;
}

export function createShaper(): Shaper {
  const worker = new Worker(new URL("./shape-worker.ts", import.meta.url), { type: "module", name: "shapes" });
  let last = 0;
  let hear: (answer: ShapeAnswer) => void = () => {};
  worker.onmessage = ({ data }: MessageEvent<ShapeAnswer>) => {
    if (data.id === last) hear(data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    const what = "the part of the engine that finds places did not start; check the connection and try again";
    hear({ kind: "refused", id: last, problem: { code: "engine-stopped", what, where: "" } });
  };
  return {
    ask(request, onAnswer) {
      last += 1;
      hear = onAnswer;
      const question: ShapeQuestion = { id: last, request };
      worker.postMessage(question);
    },
    end: () => worker.terminate(),
  };
}
