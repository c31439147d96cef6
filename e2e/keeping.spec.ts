import type { Page } from "@playwright/test";
import { unchosen } from "./fixtures/scene-file";
import { expect, Studio, test } from "./fixtures/studio";

const SAVED = "Saved on this device";

async function retitle(studio: Studio, title: string): Promise<void> {
  await studio.title.fill(title);
  await studio.title.press("Enter");
}

/** Another change, and it is saved. */
async function keepTitle(studio: Studio, title: string): Promise<void> {
  await retitle(studio, title);
  await expect(studio.page.getByText(SAVED)).toHaveCount(0);
  await expect(studio.page.getByText(SAVED)).toBeVisible();
}

test("work is there again after a reload", async ({ studio, page }) => {
  await studio.makeShow();
  await keepTitle(studio, "Mine");
  const before = unchosen(await studio.sceneFile());
  await page.reload();
  await expect(studio.title).toHaveValue("Mine");
  await expect(page.getByText(SAVED)).toBeVisible();
  expect(unchosen(await studio.sceneFile())).toEqual(before);
  await expect(studio.button("Undo")).toBeDisabled();
});

test("two tabs keep a scene each", async ({ studio, page, context }) => {
  await studio.makeShow();
  await keepTitle(studio, "First");
  const other = new Studio(await context.newPage());
  await other.open();
  await expect(other.title).toHaveValue("First");
  await keepTitle(other, "Second");
  await keepTitle(studio, "First again");
  await Promise.all([page.reload(), other.page.reload()]);
  await expect(studio.title).toHaveValue("First again");
  await expect(other.title).toHaveValue("Second");
});

test("a new scene is one undo away from the old one", async ({ studio }) => {
  await studio.makeShow();
  const before = unchosen(await studio.sceneFile());
  await studio.button("New").click();
  await expect(studio.keyframes).toHaveCount(1);
  await studio.button("Undo").click();
  await expect(studio.keyframes).toHaveCount(2);
  expect(unchosen(await studio.sceneFile())).toEqual(before);
  await studio.button("Redo").click();
  await expect(studio.keyframes).toHaveCount(1);
  expect((await studio.sceneFile()).keyframes[0]?.positions).toEqual([]);
});

test("a link asks before it takes the place of one's own scene", async ({ studio, visitor, page }) => {
  await visitor.openFirst();
  const theirs = await visitor.title.inputValue();
  const link = await visitor.link();

  await studio.makeShow();
  await keepTitle(studio, "Mine");
  const question = page.getByRole("dialog", { name: "Open the linked scene?" });

  await test.step("Keep mine keeps mine", async () => {
    await page.goto(link);
    await question.getByRole("button", { name: "Keep mine" }).click();
    await expect(studio.title).toHaveValue("Mine");
    await expect(page).not.toHaveURL(/#s=/);
  });

  await test.step("leaving the question keeps mine, after a reload, too", async () => {
    await page.goto("about:blank");
    await page.goto(link);
    await expect(question).toBeVisible();
    await expect(studio.title).toHaveValue("Mine");
    await page.keyboard.press("Escape");
    await expect(question).toHaveCount(0);
    await expect(studio.title).toHaveValue("Mine");
    await page.reload();
    await expect(studio.title).toHaveValue("Mine");
  });

  await test.step("opened, the own scene is one undo away", async () => {
    await page.goto(link);
    await question.getByRole("button", { name: "Open the linked scene" }).click();
    await expect(studio.title).toHaveValue(theirs);
    await studio.button("Undo").click();
    await expect(studio.title).toHaveValue("Mine");
  });
});

test("a link that is cut, damaged or newer says so and leaves the work", async ({ studio }) => {
  await studio.makeShow();
  const own = await studio.link();
  const before = unchosen(await studio.sceneFile());
  const fragment = own.slice(own.indexOf("#"));
  const middle = Math.floor(fragment.length / 2);
  const changed = fragment[middle] === "A" ? "B" : "A";
  const bad: readonly (readonly [fragment: string, says: RegExp])[] = [
    [fragment.slice(0, -1), /end of the link is missing/],
    [fragment.slice(0, middle), /end of the link is missing/],
    ["#s=1.", /end of the link is missing/],
    ["#s", /end of the link is missing/],
    [fragment.slice(0, middle) + changed + fragment.slice(middle + 1), /was changed on its way/],
    [fragment.replace("#s=1.", "#s=2."), /made by a newer version/],
  ];
  for (const [address, says] of bad) {
    await follow(studio.page, address);
    const message = studio.message(/That link was not opened/).last();
    await expect(message).toContainText(says);
    await message.locator("..").getByRole("button", { name: "Dismiss" }).click();
    await expect(studio.message(/That link was not opened/)).toHaveCount(0);
    await expect(studio.dialog).toHaveCount(0);
  }
  expect(unchosen(await studio.sceneFile())).toEqual(before);
});

test("what surrounds a pasted link does not harm it", async ({ studio }) => {
  await studio.makeShow();
  const own = await studio.link();
  const fragment = own.slice(own.indexOf("#"));
  for (const packed of [`${fragment})`, `${fragment}.`]) {
    await follow(studio.page, packed);
    await studio.button("Keep mine").click();
    await expect(studio.dialog).toHaveCount(0);
  }
});

test("a first visit by a cut link says so and shows an example", async ({ studio }) => {
  await studio.open("/#s=1.AAAA");
  await expect(studio.message(/That link was not opened/)).toContainText(/end of the link is missing/);
  await expect(studio.title).not.toHaveValue("");
});

test("what is drawn before the engine has come is not lost to what comes with it", async ({ studio, page }) => {
  let release = (): void => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/\.wasm$/, async (route) => {
    await held;
    await route.continue();
  });
  await studio.open();
  // The keys are let in a moment after the page is drawn.
  await expect(async () => {
    await page.keyboard.press("d");
    await expect(studio.tool("Draw")).toHaveAttribute("aria-pressed", "true", { timeout: 100 });
  }).toPass();
  await page.keyboard.press("Enter");
  const count = studio.tab("Agents");
  await expect(count).toContainText("12");
  release();
  await expect(page.getByText(SAVED)).toBeVisible();
  await expect(count).toContainText("12");
});

test("blocked storage is said, and everything else goes on", async ({ studio, page }) => {
  await page.addInitScript(() => {
    const refuse = (): never => {
      throw new DOMException("Access is denied for this document.", "SecurityError");
    };
    IDBFactory.prototype.open = refuse;
    Object.defineProperty(globalThis, "localStorage", { get: refuse });
    LockManager.prototype.request = async () => refuse();
  });
  await page.route(/worker-.*\.js$/, async (route) => {
    const response = await route.fetch();
    const refusing = "LockManager.prototype.request = () => Promise.reject(new DOMException('', 'SecurityError'));";
    await route.fulfill({ response, body: refusing + (await response.text()) });
  });
  await studio.makeShow();
  await expect(page.getByText("Not saved: the browser blocks storage")).toBeVisible();
  await expect(studio.message("The scene is not kept on this device.")).toBeVisible();
  await studio.planned();
  expect((await studio.sceneFile()).keyframes).toHaveLength(2);
});

test("full storage is said, and the change is kept once there is room", async ({ studio, page }) => {
  await studio.makeShow();
  await keepTitle(studio, "Before");
  await page.evaluate(() => {
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("There is no room left.", "QuotaExceededError");
    };
    addEventListener("roomagain", () => {
      IDBObjectStore.prototype.put = put;
    });
  });
  await retitle(studio, "During");
  await expect(page.getByText("Not saved: storage is full")).toBeVisible();
  await page.evaluate(() => dispatchEvent(new Event("roomagain")));
  await retitle(studio, "After");
  await expect(page.getByText(SAVED)).toBeVisible();
  await page.reload();
  await expect(studio.title).toHaveValue("After");
});

test("a damaged copy falls back to the one before it, and says so", async ({ studio, page }) => {
  await studio.makeShow();
  await keepTitle(studio, "First");
  await keepTitle(studio, "Second");
  await damageCopies(page, "newest");
  await page.reload();
  await expect(studio.title).toHaveValue("First");
  await expect(studio.message(/last change could not be read back/)).toBeVisible();

  await damageCopies(page, "all");
  await page.reload();
  await expect(studio.message(/last scene could not be read back/)).toBeVisible();
  await expect(studio.title).not.toHaveValue("First");
});

/** The address changes under the page, as when a link is pasted into its tab. */
async function follow(page: Page, fragment: string): Promise<void> {
  await page.evaluate((hash) => {
    location.hash = hash;
  }, fragment);
}

/** What a failing disk would do to the autosaved generations. */
async function damageCopies(page: Page, which: "newest" | "all"): Promise<void> {
  await page.evaluate(
    (chosen) =>
      new Promise<void>((resolve, reject) => {
        const opening = indexedDB.open("eigenform");
        opening.onerror = () => reject(opening.error);
        opening.onsuccess = () => {
          const transaction = opening.result.transaction("generations", "readwrite");
          const store = transaction.objectStore("generations");
          const reading = store.openCursor();
          const found: { key: IDBValidKey; value: { serial: number; text: string } }[] = [];
          reading.onsuccess = () => {
            const cursor = reading.result;
            if (cursor) {
              found.push({ key: cursor.key, value: cursor.value });
              cursor.continue();
              return;
            }
            found.sort((p, q) => q.value.serial - p.value.serial);
            for (const { key, value } of chosen === "newest" ? found.slice(0, 1) : found) {
              store.put({ ...value, text: value.text.replace("eigenform", "eigenfrom") }, key);
            }
          };
          transaction.oncomplete = () => {
            opening.result.close();
            resolve();
          };
          transaction.onabort = () => reject(transaction.error);
        };
      }),
    which,
  );
}
