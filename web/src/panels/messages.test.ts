import { expect, test } from "vitest";
import { createMessages, OPENING } from "./messages";

const stopped = { tone: "problem", title: "The engine stopped.", text: "Your scene is untouched." } as const;
const copied = { tone: "good", title: "Link copied.", text: "" } as const;

test("the newest about the same thing takes the place of those before it, and comes last", () => {
  const messages = createMessages();
  messages.say(stopped);
  messages.say(copied);
  messages.say({ ...stopped, text: "It starts again." });
  expect(messages.shown.value.map((message) => message.title)).toEqual([copied.title, stopped.title]);
  expect(messages.shown.value.at(-1)?.text).toBe("It starts again.");
});

test("whatever is opened one after another, only how the last went is seen", () => {
  const messages = createMessages();
  for (const name of ["a.json", "b.json"]) {
    messages.say({ tone: "problem", about: OPENING, title: `${name} was not opened.`, text: "" });
  }
  messages.say({ tone: "good", about: OPENING, title: "c.json is open.", text: "" });
  expect(messages.shown.value.map((message) => message.title)).toEqual(["c.json is open."]);
});

test("no more than three messages are shown, the newest ones", () => {
  const messages = createMessages();
  for (const title of ["one", "two", "three", "four"]) messages.say({ tone: "good", title, text: "" });
  expect(messages.shown.value.map((message) => message.title)).toEqual(["two", "three", "four"]);
});

test("everything said is announced, also at once and again, and a dismissed message is gone", () => {
  const messages = createMessages();
  messages.say(stopped);
  messages.announce("Agent 3 selected");
  const id = messages.say(stopped);
  const words = messages.announcements.value.map(({ text }) => text);
  expect(words).toEqual([
    expect.stringContaining(stopped.text),
    "Agent 3 selected",
    expect.stringContaining(stopped.text),
  ]);
  expect(new Set(messages.announcements.value.map((announcement) => announcement.id)).size).toBe(3);
  messages.dismiss(id);
  expect(messages.shown.value).toEqual([]);
});
