import { unchosen } from "./fixtures/scene-file";
import { expect, test, textOf } from "./fixtures/studio";

test("a saved scene opens again as it was, by choosing the file and by dropping it", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.title.fill("Rain, second part");
  await studio.title.press("Enter");
  await studio.planned();
  const download = await studio.downloadOf(() => studio.button("Save").click());
  expect(download.suggestedFilename()).toBe("Rain-second-part.eigenform.json");
  const text = await textOf(download);

  await studio.button("New").click();
  await expect(studio.keyframes).toHaveCount(1);
  const choosing = page.waitForEvent("filechooser");
  await studio.button("Open").click();
  await (await choosing).setFiles({
    name: "rain.eigenform.json",
    mimeType: "application/json",
    buffer: Buffer.from(text),
  });
  await expect(studio.title).toHaveValue("Rain, second part");
  await studio.planned();
  expect(await studio.sceneFile()).toEqual(JSON.parse(text));

  await studio.button("Undo").click();
  await expect(studio.keyframes).toHaveCount(1);
  await studio.drop("rain.eigenform.json", text);
  await expect(studio.title).toHaveValue("Rain, second part");
  await studio.planned();
  expect(await studio.sceneFile()).toEqual(JSON.parse(text));
});

test("a keyframe CSV that is dropped opens with its groups, and says what it could not hold", async ({ studio }) => {
  await studio.openFirst();
  const rows = [
    "keyframe,time,agent,group,x,y",
    "Start,0,Ada,Band/Brass,-4,0",
    "Start,0,Ben,Band/Drums,0,0",
    "Start,0,Cleo,Band/Drums,4,0",
    "Turn,3.5,Ada,Band/Drums,0,4",
    "Turn,3.5,Ben,Band/Drums,0,0",
    "Turn,3.5,Cleo,Band/Drums,0,-4",
  ];
  await studio.drop("evening.csv", rows.join("\n"));
  await expect(studio.message(/evening\.csv is open/)).toContainText(/1 .*change.* group.* keeps its first/);
  await expect(studio.title).toHaveValue("evening");
  await expect(studio.keyframes).toHaveCount(2);
  await expect(studio.keyframes.nth(1)).toHaveAccessibleName("Turn");
  const file = await studio.sceneFile();
  expect(file.agents?.map(({ name }) => name)).toEqual(["Ada", "Ben", "Cleo"]);
  expect(file.groups?.[0]?.name).toBe("Band");
  expect(file.keyframes[1]?.time).toBe(3.5);
});

/** What a person may bring by mistake, and the words that must tell them what it is and where. */
const BAD_FILES: readonly (readonly [name: string, content: string | { bytes: number }, says: RegExp])[] = [
  ["broken.json", '{ "format": "eigenform", "version": 1, "keyframes": [', /not well-formed JSON.*line 1/i],
  ["newer.json", '{ "format": "eigenform", "version": 2, "keyframes": [] }', /made by a newer version/i],
  ["other.json", '{ "format": "sheet music", "version": 1 }', /not a scene.*sheet music/i],
  [
    "typo.json",
    '{ "format": "eigenform", "version": 1, "keyframes": [{ "positions": [[0, 0]], "tmie": 2 }] }',
    /"tmie" is no field.*keyframes\[0\]/i,
  ],
  [
    "later.json",
    '{ "format": "eigenform", "version": 1, "recordings": [{}], "keyframes": [{ "positions": [[0, 0]] }] }',
    /not supported yet.*recordings/i,
  ],
  ["twice.csv", "keyframe,time,agent,group,x,y\n0,0,Ada,,0,0\n0,0,Ben,,1,0\n0,0,Ada,,2,0\n", /row 4.*agent Ada twice/i],
  ["words.csv", "keyframe,time,agent,group,x,y\n0,0,Ada,,left,0\n", /row 2.*"left".*must be a number/i],
  ["empty.json", "", /nothing to read/i],
  ["huge.json", { bytes: 65 * 1024 * 1024 }, /at most 64 MiB/i],
  ["sound.ogg", "OggS\u0000\u0002\u0000\u0000\u0000\u0000", /not text/i],
  ["letter.txt", "Dear Ada,\nwe meet at nine.\n", /no scene.*scene file.*keyframe CSV.*recording/i],
];

test("who opens a table is told that it names no distance, and keeps agents apart with one press", async ({
  studio,
}) => {
  await studio.openFirst();
  const rows = ["keyframe,time,agent,x,y", "0,0,Ada,-4,0", "0,0,Ben,4,0", "1,8,Ada,4,0", "1,8,Ben,-4,0"];
  await studio.drop("crossing.csv", rows.join("\n"));
  await studio.button("Keep 0.50 m apart").click();
  const file = await studio.sceneFile();
  expect(file.minimumDistance).toBe(0.5);
  expect(file.segments?.map(({ avoidance }) => avoidance)).toEqual([true]);
});

test("a bad file says what is wrong and where, and leaves the scene as it was", async ({ studio }) => {
  await studio.makeShow();
  await studio.planned();
  const before = await studio.sceneFile();
  for (const [name, content, says] of BAD_FILES) {
    await studio.drop(name, content);
    const message = studio.message(`${name} was not opened`);
    await expect(message).toContainText(says);
    await expect(message).toContainText("Your scene is unchanged");
  }
  expect(await studio.sceneFile()).toEqual(before);
  await expect(studio.button("Undo")).toBeEnabled();
  await studio.button("Undo").click();
  expect(unchosen(await studio.sceneFile())).not.toEqual(unchosen(before));
});

test("the hint of a first visit makes room for what went wrong", async ({ studio, page }) => {
  await studio.openEmpty();
  const hint = page.getByRole("note").filter({ hasText: "Start with Draw." });
  await expect(hint).toBeVisible();
  await studio.drop("broken.json", "{");
  await expect(studio.message("broken.json was not opened.")).toBeVisible();
  await expect(hint).toHaveCount(0);
  await studio.stage.getByRole("button", { name: "Dismiss" }).click();
  await expect(hint).toBeVisible();
});

test("keyframes and motion are exported for other tools", async ({ studio, page }) => {
  await studio.makeShow();
  await studio.planned();
  const scene = await studio.sceneFile();
  const [first, second] = scene.keyframes;
  await studio.button("Export").click();
  const exported = async (name: string): Promise<string> =>
    textOf(await studio.downloadOf(() => studio.button(`Download ${name}`).click()));

  const keyframes = table(await exported("Keyframes, CSV"));
  expect(keyframes.header).toEqual(["keyframe", "time", "agent", "group", "x", "y"]);
  expect(keyframes.rows).toHaveLength(24);
  expect(keyframes.rows.slice(0, 12).map(([, , , , x, y]) => [Number(x), Number(y)])).toEqual(first?.positions);

  const end = second?.time ?? 0;
  const frameCount = Math.floor(end * 30 + 1e-9) + 1;
  const motion = table(await exported("Motion, CSV"));
  expect(motion.header).toEqual(["frame", "time", "agent", "x", "y", "z"]);
  expect(motion.rows).toHaveLength(12 * frameCount);
  expect(new Set(motion.rows.map(([, , , , , z]) => Number(z)))).toEqual(new Set([0]));

  const sampled = JSON.parse(await exported("Motion, JSON")) as { times: number[]; positions: [number, number][][] };
  expect(sampled.times).toHaveLength(frameCount);
  expect(sampled.times.at(-1)).toBeCloseTo(end, 9);
  expectPlaces(sampled.positions[0], first?.positions);
  expectPlaces(sampled.positions.at(-1), second?.positions);
  expectPlaces(
    motion.rows.slice(0, 12).map(([, , , x, y]) => [Number(x), Number(y)]),
    first?.positions,
  );

  await page.keyboard.press("Escape");
  await expect(studio.dialog).toHaveCount(0);
});

test("a keyframe CSV that was exported opens again with the same formations", async ({ studio }) => {
  await studio.makeShow();
  await studio.button("Export").click();
  const text = await textOf(await studio.downloadOf(() => studio.button("Download Keyframes, CSV").click()));
  await studio.page.keyboard.press("Escape");
  const before = await studio.sceneFile();
  await studio.button("New").click();
  await studio.drop("again.csv", text);
  await expect(studio.keyframes).toHaveCount(2);
  const after = await studio.sceneFile();
  expect(after.keyframes.map(({ positions }) => positions)).toEqual(before.keyframes.map(({ positions }) => positions));
});

interface Table {
  readonly header: readonly string[];
  readonly rows: readonly (readonly string[])[];
}

/** None of these tables quotes a field. */
function table(text: string): Table {
  const [header = "", ...rows] = text.trimEnd().split(/\r?\n/);
  return { header: header.split(","), rows: rows.map((row) => row.split(",")) };
}

type Places = readonly (readonly [x: number, y: number])[];

/** Ends are exact to a billionth of the extent; the stage is a hundred meters wide. */
function expectPlaces(found: Places | undefined, wanted: Places | undefined): void {
  expect(found).toHaveLength(wanted?.length ?? -1);
  for (const [agent, [x, y]] of (wanted ?? []).entries()) {
    expect(found?.[agent]?.[0]).toBeCloseTo(x, 6);
    expect(found?.[agent]?.[1]).toBeCloseTo(y, 6);
  }
}
