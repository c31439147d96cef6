import { EngineError } from "./api";
import { Ledger } from "./ledger";
import type { Answer, CallName, Calls, PlanMessage, Question } from "./protocol";

/** A worker that does not start within this many milliseconds never will. */
const START_LIMIT = 20_000;

interface Waiting {
  resolve(value: never): void;
  reject(reason: unknown): void;
}

/** The worker a call went to is gone; the call may be asked again elsewhere. */
export class WorkerGone extends Error {}

let lockCount = 0;

/** One engine worker: typed calls out, plan messages in, and word of its death. */
export class WorkerLink {
  readonly ledger = new Ledger();
  readonly started: Promise<void>;
  onPlan: (message: PlanMessage) => void = () => {};
  onDeath: (why: string) => void = () => {};
  readonly #worker: Worker;
  readonly #waiting = new Map<number, Waiting>();
  #lastId = 0;
  #isDead = false;
  #settleStart: { resolve(): void; reject(reason: unknown): void } = { resolve: () => {}, reject: () => {} };

  /** `module` is the compiled engine, or the compiled workshop for one that answers everything. */
  constructor(module: WebAssembly.Module, name: "engine" | "workshop" = "engine") {
    // A bundler sees a worker only where its address stands.
    this.#worker =
      name === "engine"
        ? new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name })
        : new Worker(new URL("./workshop-worker.ts", import.meta.url), { type: "module", name });
    this.started = new Promise((resolve, reject) => {
      this.#settleStart = { resolve, reject };
    });
    this.started.catch(() => {});
    lockCount += 1;
    const lock = `eigenform-engine-${performance.timeOrigin}-${lockCount}`;
    const timer = setTimeout(() => this.#die("the engine did not start in time"), START_LIMIT);
    this.started.then(
      () => {
        clearTimeout(timer);
        this.#watch(lock);
      },
      () => clearTimeout(timer),
    );
    this.#worker.onmessage = ({ data }: MessageEvent<Answer>) => this.#hear(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#die(event.message || "the engine's worker failed");
    };
    this.#send({ kind: "start", module, lock });
  }

  get isDead(): boolean {
    return this.#isDead;
  }

  /** The id under which plan messages of a `plan` call arrive is the id of that call. */
  call<Name extends CallName>(
    name: Name,
    ask: Calls[Name]["ask"],
  ): { id: number; answer: Promise<Calls[Name]["answer"]> } {
    this.#lastId += 1;
    const id = this.#lastId;
    const answer = new Promise<Calls[Name]["answer"]>((resolve, reject) => {
      if (this.#isDead) reject(new WorkerGone("the engine is restarting"));
      else this.#waiting.set(id, { resolve, reject });
    });
    if (!this.#isDead) this.#send({ kind: "call", id, name, ask } as Question);
    return { id, answer };
  }

  terminate(why: string): void {
    this.#die(why);
  }

  #send(question: Question): void {
    this.#worker.postMessage(question);
  }

  #hear(answer: Answer): void {
    switch (answer.kind) {
      case "started":
        this.#settleStart.resolve();
        break;
      case "answer":
        this.#settle(answer.id)?.resolve(answer.value as never);
        break;
      case "refusal":
        this.#settle(answer.id)?.reject(new EngineError(answer.problem));
        break;
      case "crashed":
        this.#die(answer.message);
        break;
      default:
        this.onPlan(answer);
    }
  }

  #settle(id: number): Waiting | undefined {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    return waiting;
  }

  /** A worker that closes itself or is killed fires no event, but its lock comes free. */
  #watch(lock: string): void {
    navigator.locks?.request(lock, () => this.#die("the engine's worker ended")).catch(() => {});
  }

  #die(why: string): void {
    if (this.#isDead) return;
    this.#isDead = true;
    this.#worker.terminate();
    const gone = new WorkerGone(why);
    this.#settleStart.reject(gone);
    for (const waiting of this.#waiting.values()) waiting.reject(gone);
    this.#waiting.clear();
    this.onDeath(why);
  }
}
