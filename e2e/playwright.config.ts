import { defineConfig, devices } from "@playwright/test";

const executablePath = process.env.EIGENFORM_BROWSER ?? "/usr/bin/chromium";
/** Two runs beside each other need a port each. */
const port = Number(process.env.EIGENFORM_PORT ?? 4180);
const baseURL = `http://127.0.0.1:${port}`;
const launchOptions = {
  executablePath,
  args: [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    // Else every page comes with two more, of the browser's own, that nobody sees.
    "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup",
  ],
};

export default defineConfig({
  testDir: ".",
  outputDir: "../test-results",
  fullyParallel: true,
  workers: 2,
  retries: 0,
  forbidOnly: true,
  timeout: 120_000,
  // A story waits for what it wants to see and never for a time, so a slow machine may take its own.
  expect: { timeout: 20_000 },
  reporter: [["list"]],
  use: {
    baseURL,
    launchOptions,
    // Nothing plays by itself or glides, which half of the time would go to; stories of motion ask for it.
    contextOptions: { reducedMotion: "reduce" },
    // A seventh of the time; `--trace retain-on-failure` where a failure is looked into.
    trace: "off",
    screenshot: "only-on-failure",
  },
  webServer: {
    command: `npx vite preview --host 127.0.0.1 --port ${port} --strictPort`,
    cwd: "..",
    url: baseURL,
    reuseExistingServer: false,
  },
  projects: [
    {
      name: "desktop",
      use: { ...devices["Desktop Chrome"], viewport: { width: 1440, height: 900 } },
      testIgnore: /phone/,
    },
    { name: "phone", use: { ...devices["Pixel 7"] }, testMatch: /phone/ },
  ],
});
