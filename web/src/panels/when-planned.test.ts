import { signal } from "@preact/signals";
import { expect, test, vi } from "vitest";
import { emptyScene } from "../document/defaults";
import type { Planning } from "../engine/api";
import { whenPlanned } from "./when-planned";

const UNDER_WAY: Planning = { kind: "planning", progress: 0.3, motion: null, isCurrent: false, stale: null };

function studio(...states: Planning[]) {
  const scene = signal(emptyScene());
  const segments = signal<readonly Planning[]>(states);
  const run = vi.fn();
  const given = vi.fn();
  const parts = { document: { scene }, planner: { segments } } as unknown as Parameters<typeof whenPlanned>[0];
  return { scene, segments, run, given, ask: () => whenPlanned(parts, 0, run, given) };
}

test("what needs a motion that is there runs at once", () => {
  for (const state of [{ kind: "canceled" }, { kind: "ready" }, { kind: "failed" }] as Planning[]) {
    const { ask, run } = studio(state);
    expect(ask()).toBe(true);
    expect(run).toHaveBeenCalledOnce();
  }
});

test("while it is planned it waits, and runs once", () => {
  const { ask, run, given, segments } = studio(UNDER_WAY);
  expect(ask()).toBe(false);
  segments.value = [{ ...UNDER_WAY, progress: 0.6 }];
  expect(run).not.toHaveBeenCalled();
  segments.value = [{ kind: "canceled" }];
  segments.value = [{ kind: "canceled" }];
  expect(run).toHaveBeenCalledOnce();
  expect(given).not.toHaveBeenCalled();
});

test("it is given up when the scene changes before", () => {
  const { ask, run, given, scene, segments } = studio(UNDER_WAY);
  expect(ask()).toBe(false);
  scene.value = emptyScene();
  segments.value = [{ kind: "canceled" }];
  expect(run).not.toHaveBeenCalled();
  expect(given).toHaveBeenCalledOnce();
});
