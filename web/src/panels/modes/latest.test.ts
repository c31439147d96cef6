import { expect, test } from "vitest";
import { createQueue, type Latest } from "./latest";

function bench() {
  const told: Latest<string>[] = [];
  const queue = createQueue<string>((latest) => told.push(latest));
  const asked: string[] = [];
  const answers = new Map<string, () => void>();
  const want = (name: string) =>
    queue.want(() => {
      asked.push(name);
      return new Promise((resolve) => answers.set(name, () => resolve(name)));
    });
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  return { told, asked, want, settle, queue, answer: (name: string) => answers.get(name)?.() };
}

test("while one is asked only the newest of the others waits", async () => {
  const { told, asked, want, answer, settle } = bench();
  for (const name of ["first", "second", "third"]) want(name);
  answer("first");
  await settle();
  answer("third");
  await settle();
  expect(asked).toEqual(["first", "third"]);
  expect(told.at(-1)).toEqual({ value: "third", isWaiting: false, problem: null });
});

test("the answer before stays until the next one comes", async () => {
  const { told, want, answer, settle } = bench();
  want("first");
  answer("first");
  await settle();
  want("second");
  expect(told.at(-1)).toEqual({ value: "first", isWaiting: true, problem: null });
});

test("a refusal is told, and the next question is asked all the same", async () => {
  const { told, queue, want, answer, settle } = bench();
  queue.want(() => Promise.reject(new Error("no engine")));
  await settle();
  expect(told.at(-1)?.problem?.what).toBe("no engine");
  want("again");
  answer("again");
  await settle();
  expect(told.at(-1)?.value).toBe("again");
});
