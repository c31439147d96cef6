import { expect, test } from "vitest";
import { createDialogs } from "./dialogs";

test("leaving a question takes its last choice", async () => {
  const dialogs = createDialogs();
  const answer = dialogs.ask({ title: "Open the linked scene?", text: "" }, ["Open the linked scene", "Keep mine"]);
  dialogs.close();
  expect(await answer).toBe("Keep mine");
  expect(dialogs.shown.value).toBeNull();
});

test("a question that another dialog pushes aside is answered", async () => {
  const dialogs = createDialogs();
  const answer = dialogs.ask({ title: "Open the linked scene?", text: "" }, ["Open the linked scene", "Keep mine"]);
  dialogs.show({ kind: "share" });
  expect(await answer).toBe("Keep mine");
  expect(dialogs.shown.value).toEqual({ kind: "share" });
});

test("a choice answers the question", async () => {
  const dialogs = createDialogs();
  const answer = dialogs.ask({ title: "Open the linked scene?", text: "" }, ["Open the linked scene", "Keep mine"]);
  const request = dialogs.shown.value;
  const choice = request?.kind === "question" && request.choices[0];
  if (choice) dialogs.answer(choice);
  expect(await answer).toBe("Open the linked scene");
  expect(dialogs.shown.value).toBeNull();
});
