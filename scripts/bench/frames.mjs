import { dropFile, planned, press, withPage } from "./built.mjs";
import { garbageAFrame } from "./garbage.mjs";
import { median } from "./median.mjs";
import { BROWSER_FLAGS } from "./rows.mjs";

const SECONDS = 5;

/** A show of agents strewn over a square, as keyframe CSV; x and y from a seeded generator. */
function showCsv(agentCount, keyframeCount) {
  let state = 1;
  const next = () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 0xffff_ffff;
  };
  const side = Math.sqrt(agentCount) * 1.5;
  const rows = ["keyframe,time,agent,group,x,y"];
  for (let k = 0; k < keyframeCount; k += 1) {
    for (let agent = 0; agent < agentCount; agent += 1) {
      rows.push(`${k},${k * 10},${agent},g${agent % 5},${(next() - 0.5) * side},${(next() - 0.5) * side}`);
    }
  }
  return rows.join("\n");
}

/** Gaps between animation frames over some seconds, milliseconds. */
function gaps(page, seconds) {
  return page.evaluate(
    (limit) =>
      new Promise((resolve) => {
        const found = [];
        const start = performance.now();
        let last = start;
        const step = (now) => {
          found.push(now - last);
          last = now;
          if (now - start > limit * 1000) resolve(found.slice(1));
          else requestAnimationFrame(step);
        };
        requestAnimationFrame(step);
      }),
    seconds,
  );
}

async function openShow(page, agentCount) {
  await page.getByRole("button", { name: "New", exact: true }).click();
  await dropFile(page, "show.csv", "text/csv", showCsv(agentCount, 2));
  await page.getByRole("listbox", { name: "Keyframes" }).getByRole("option").nth(1).waitFor();
}

/** What playing and planning cost the page, a line each. */
export function playbackRows(executablePath) {
  return withPage(executablePath, BROWSER_FLAGS, async (newPage) => {
    const lines = [];
    for (const agentCount of [300, 1260]) {
      const page = await newPage();
      await openShow(page, agentCount);
      const planning = await gaps(page, 4);
      await planned(page);
      await press(page, "Loop");
      await press(page, "Play");
      const playing = await gaps(page, SECONDS);
      const garbage = await garbageAFrame(page);
      const late = playing.filter((gap) => gap > 25).length;
      lines.push(
        `${agentCount} agents: ${(1000 / median(playing)).toFixed(0)} frames/s playing, ${late} of ${playing.length} frames late (> 25 ms), longest gap ${Math.max(...playing).toFixed(0)} ms; longest gap while planning ${Math.max(...planning).toFixed(0)} ms; ${(garbage / 1000).toFixed(2)} kB of garbage a frame`,
      );
      await page.close();
    }
    return lines;
  });
}

/** What 1,260 agents in perspective cost, on whatever draws here; a line a kind of body. */
export function perspectiveRows(executablePath) {
  const flags = BROWSER_FLAGS.filter((flag) => flag !== "--disable-gpu");
  return withPage(executablePath, flags, async (newPage) => {
    const page = await newPage();
    await openShow(page, 1260);
    await planned(page);
    await press(page, "Perspective");
    await page.getByRole("application").waitFor();
    const device = await page.evaluate(() => {
      const context = document.createElement("canvas").getContext("webgl2");
      const names = context?.getExtension("WEBGL_debug_renderer_info");
      return context && names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : "an unnamed device";
    });
    await press(page, "Loop");
    const lines = [];
    for (const bodies of ["Figures", "Cones", "Discs"]) {
      await page.getByRole("combobox", { name: "Show agents as" }).selectOption(bodies);
      await press(page, "Play");
      const playing = await gaps(page, SECONDS);
      await press(page, "Pause");
      const rate = (1000 / median(playing)).toFixed(1);
      lines.push(`1260 agents in perspective as ${bodies.toLowerCase()}: ${rate} frames/s (≥ 30 on a GPU)`);
    }
    return [...lines, `drawn by ${device}`];
  });
}
