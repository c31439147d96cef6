/** Bytes between two looks of the profiler on average: seldom enough to leave frames their pace. */
const INTERVAL = 256;
const FRAMES = 240;

/** Until so many frames have been drawn. */
function drawn(page, count) {
  return page.evaluate(
    (wanted) =>
      new Promise((resolve) => {
        let left = wanted;
        const step = () => {
          left -= 1;
          if (left < 0) resolve();
          else requestAnimationFrame(step);
        };
        requestAnimationFrame(step);
      }),
    count,
  );
}

const bytesOf = (node) => node.children.reduce((bytes, child) => bytes + bytesOf(child), node.selfSize);

/** What JavaScript allocates a frame while the page plays, bytes: also what is collected again at once. */
export async function garbageAFrame(page) {
  const session = await page.context().newCDPSession(page);
  const isCounted = { includeObjectsCollectedByMajorGC: true, includeObjectsCollectedByMinorGC: true };
  await session.send("HeapProfiler.startSampling", { samplingInterval: INTERVAL, ...isCounted });
  await drawn(page, FRAMES);
  const { profile } = await session.send("HeapProfiler.stopSampling");
  await session.detach();
  return bytesOf(profile.head) / FRAMES;
}
