import { expect, test } from "vitest";
import { createMessages } from "./messages";

const stopped = { tone: "problem", title: "The engine stopped.", text: "Your scene is untouched." } as const;
const copied = { tone: "good", title: "Link copied.", text: "" } as const;

test("the same thing said again is shown once, as the newest", () => {
  const messages = createMessages();
  messages.say(stopped);
  messages.say(copied);
  messages.say(stopped);
  expect(messages.shown.value.map((message) => message.title)).toEqual([copied.title, stopped.title]);
});

test("no more than three messages are shown, the newest ones", () => {
  const messages = createMessages();
  for (const title of ["one", "two", "three", "four"]) messages.say({ tone: "good", title, text: "" });
  expect(messages.shown.value.map((message) => message.title)).toEqual(["two", "three", "four"]);
});

test("what is said is announced, and a dismissed message is gone", () => {
  const messages = createMessages();
  const id = messages.say(copied);
  expect(messages.announcement.value).toContain(copied.title);
  messages.dismiss(id);
  expect(messages.shown.value).toEqual([]);
});
