import { access } from "node:fs/promises";
import { join } from "node:path";
import { ask, root, run, Stop, step } from "./run.mjs";
import { hashOf, once } from "./stamp.mjs";

const NODE = [20, 19];
const CARGO = [1, 95];

export const WASM_TARGET = "wasm32-unknown-unknown";

function isOlder(version, [major, minor]) {
  const [a = 0, b = 0] = version.split(".").map(Number);
  return a < major || (a === major && b < minor);
}

function checkNode() {
  if (isOlder(process.versions.node, NODE)) {
    throw new Stop(
      `Node ${NODE.join(".")} or newer is needed, this is ${process.versions.node}: install it from nodejs.org.`,
    );
  }
}

async function checkCargo() {
  const version = await ask("cargo", ["--version"]);
  const number = version?.split(" ")[1];
  if (!number) throw new Stop("Rust is missing: install it with rustup (rustup.rs), then run this again.");
  if (isOlder(number, CARGO))
    throw new Stop(`Rust ${CARGO.join(".")} or newer is needed, this is ${number}: run "rustup update".`);
  return version;
}

async function checkTarget() {
  const libraries = await ask("rustc", ["--print", "target-libdir", "--target", WASM_TARGET]);
  const isThere =
    libraries !== null &&
    (await access(libraries).then(
      () => true,
      () => false,
    ));
  if (isThere) return;
  if ((await ask("rustup", ["--version"])) === null) {
    throw new Stop(
      `Rust cannot compile for the browser: install Rust with rustup (rustup.rs), or add the target ${WASM_TARGET}.`,
    );
  }
  await step("Adding Rust's browser target", () => run("rustup", ["target", "add", WASM_TARGET]));
}

/** Not `npm ci`: it insists on optional packages of systems other than this one. */
async function installPackages() {
  const hash = await hashOf(["package.json", "package-lock.json"], [process.versions.node]);
  const areThere = () =>
    access(join(root, "node_modules/vite/package.json")).then(
      () => true,
      () => false,
    );
  await once("packages", hash, areThere, () =>
    step("Installing npm packages", () =>
      run("npm", ["install", "--no-save", "--no-audit", "--no-fund", "--loglevel=error"]),
    ),
  );
}

/** Everything a build needs, installed where it can be; returns what the toolchain calls itself. */
export async function prepare() {
  checkNode();
  const cargo = await checkCargo();
  await checkTarget();
  await installPackages();
  return cargo;
}

/** What the checks need beside a build. */
export async function prepareChecks() {
  for (const [command, component] of [
    ["cargo-clippy", "clippy"],
    ["rustfmt", "rustfmt"],
  ]) {
    if ((await ask(command, ["--version"])) === null) {
      await step(`Adding Rust's ${component}`, () => run("rustup", ["component", "add", component]));
    }
  }
}
