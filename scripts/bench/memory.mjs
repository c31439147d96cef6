import { dropFile, planned, press, withPage } from "./built.mjs";
import { BROWSER_FLAGS } from "./rows.mjs";

const AGENTS = 1936;
const MEGABYTE = 2 ** 20;

/** The bench's marching block as a scene file: a crowd in four groups that turns upside down while it moves on for 10 s. */
function crowdScene(agentCount) {
  const columns = Math.ceil(Math.sqrt(agentCount));
  const places = Array.from({ length: agentCount }, (_, k) => [k % columns, Math.floor(k / columns)]);
  const members = (part) => [...places.keys()].filter((k) => Math.floor((k * 4) / agentCount) === part);
  return JSON.stringify({
    format: "eigenform",
    version: 1,
    frameRate: 30,
    agents: places.map(() => ({})),
    groups: [0, 1, 2, 3].map((part) => ({ members: members(part) })),
    keyframes: [
      { time: 0, positions: places },
      { time: 10, positions: places.map(([x, y]) => [x + 20, columns - y]) },
    ],
    segments: [{ method: "crowd" }],
  });
}

/** Sends commands to one target among those that a browser's session has attached. */
function commands(session, sessionId) {
  let last = 0;
  const waiting = new Map();
  session.on("Target.receivedMessageFromTarget", (event) => {
    const message = JSON.parse(event.message);
    if (event.sessionId !== sessionId || !waiting.has(message.id)) return;
    waiting.get(message.id)(message.result);
    waiting.delete(message.id);
  });
  return (method, params = {}) =>
    new Promise((resolve) => {
      last += 1;
      waiting.set(last, resolve);
      session.send("Target.sendMessageToTarget", { sessionId, message: JSON.stringify({ id: last, method, params }) });
    });
}

/** Bytes of JavaScript's heap and of WebAssembly memories of one page or worker, garbage collected. */
async function bytesOf(send) {
  await send("HeapProfiler.collectGarbage");
  const { usedSize } = await send("Runtime.getHeapUsage");
  const { result } = await send("Runtime.evaluate", { expression: "WebAssembly.Memory.prototype" });
  const { objects } = await send("Runtime.queryObjects", { prototypeObjectId: result.objectId });
  const sum = "function () { return this.reduce((bytes, memory) => bytes + memory.buffer.byteLength, 0); }";
  const memories = await send("Runtime.callFunctionOn", {
    objectId: objects.objectId,
    functionDeclaration: sum,
    returnByValue: true,
  });
  return { heap: usedSize, wasm: memories.result.value };
}

/** What the page and its workers hold once a crowd of 1,936 is planned and measured; a line. */
export function memoryRow(executablePath) {
  return withPage(executablePath, BROWSER_FLAGS, async (newPage) => {
    const page = await newPage();
    const session = await page.context().newCDPSession(page);
    const workers = [];
    session.on("Target.attachedToTarget", ({ sessionId }) => workers.push(commands(session, sessionId)));
    await session.send("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
    await press(page, "New");
    await dropFile(page, "crowd.eigenform.json", "application/json", crowdScene(AGENTS));
    await page.getByRole("listbox", { name: "Keyframes" }).getByRole("option").nth(1).waitFor();
    await planned(page);
    const all = [(method, params) => session.send(method, params), ...workers];
    const bytes = await Promise.all(all.map(bytesOf));
    const sum = (part) => bytes.reduce((total, one) => total + one[part], 0) / MEGABYTE;
    const [heap, wasm] = [sum("heap"), sum("wasm")];
    const whole = (heap + wasm).toFixed(0);
    return `${AGENTS} agents as a crowd: ${whole} MB, ${heap.toFixed(0)} of JavaScript and ${wasm.toFixed(0)} of WebAssembly in the page and ${workers.length} workers (≤ 150)`;
  });
}
