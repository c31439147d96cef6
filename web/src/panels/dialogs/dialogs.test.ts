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

test("what is typed while a dialog is on its way is its first text, and nobody else's", () => {
  const dialogs = createDialogs();
  expect(dialogs.typeAhead("k")).toBe(false);
  dialogs.show({ kind: "palette" });
  const keys = ["k", "e", "Shift", "y", " "];
  expect(keys.map(dialogs.typeAhead)).toEqual(keys.map(() => true));
  expect(dialogs.takeTyped()).toBe("key ");
  expect(dialogs.takeTyped()).toBe("");
  dialogs.typeAhead("x");
  dialogs.close();
  expect(dialogs.typeAhead("k")).toBe(false);
  dialogs.show({ kind: "palette" });
  expect(dialogs.takeTyped()).toBe("");
});
