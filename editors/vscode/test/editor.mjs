// A real editor with the packaged extension: code-server, driven by Chromium and the playwright-core that is installed beside it.
import { execFileSync, spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { objdict } from "./objdict.mjs";

const extension = fileURLToPath(new URL("..", import.meta.url));

/** Starts the editor in a folder of its own with these files, and ends it after `use`. */
export async function withEditor(entry, files, use, { width = 960, height = 450 } = {}) {
  const { chromium } = createRequire(resolve(entry))("playwright-core");
  const work = mkdtempSync(join(tmpdir(), "objdict-"));
  const [device, user] = [join(work, "device"), join(work, "data/User")];
  for (const folder of [device, user]) mkdirSync(folder, { recursive: true });
  for (const [name, bytes] of Object.entries(files)) writeFileSync(join(device, name), bytes);
  const quiet = { "workbench.startupEditor": "none", "workbench.colorTheme": "Default Light Modern", "editor.minimap.enabled": false };
  const trusted = { "security.workspace.trust.enabled": false, "files.autoSave": "off", "objdict.server.path": objdict };
  writeFileSync(join(user, "settings.json"), JSON.stringify({ ...quiet, ...trusted }));
  const vsix = join(work, "objdict.vsix");
  execFileSync("npm", ["run", "--silent", "package", "--", "--out", vsix], { cwd: extension });
  const editor = [resolve(entry), "--config", join(work, "config.yaml"), "--user-data-dir", join(work, "data"), "--extensions-dir", join(work, "extensions")];
  execFileSync(process.execPath, [...editor, "--install-extension", vsix], { stdio: "pipe" });
  const server = spawn(process.execPath, [...editor, "--auth", "none", "--bind-addr", "127.0.0.1:0", "--disable-update-check"]);
  let browser;
  try {
    const address = await new Promise((found, failed) => {
      let said = "";
      for (const stream of [server.stdout, server.stderr])
        stream.on("data", (part) => {
          said += part;
          const at = /listening on (http:\S+)/.exec(said);
          if (at) found(at[1]);
        });
      server.on("exit", () => failed(new Error(`the editor did not start: ${said}`)));
    });
    browser = await chromium.launch({ executablePath: process.env.OBJDICT_CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"] });
    const page = await browser.newPage({ viewport: { width, height } });
    await page.goto(`${address}?folder=${encodeURIComponent(device)}`);
    const editor = new Editor(page, device);
    await use(editor).finally(() => process.env.OBJDICT_VIEWS && page.screenshot({ path: join(process.env.OBJDICT_VIEWS, "editor.png") }));
  } finally {
    await browser?.close();
    server.kill();
    rmSync(work, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Editor {
  constructor(page, folder) {
    Object.assign(this, { page, folder });
  }

  path = (name) => join(this.folder, name);

  async keys(...names) {
    for (const name of names) await this.page.keyboard.press(name);
  }

  async open(name) {
    await this.page.getByRole("treeitem", { name, exact: true }).dblclick();
    await this.page.locator(".tab.active", { hasText: name }).waitFor();
    await this.page.locator(".view-line").first().waitFor();
  }

  /** Runs a command of the palette. */
  async run(name) {
    await this.keys("F1");
    await this.page.locator(".quick-input-widget input").fill(`>${name}`);
    await this.page.locator(".quick-input-list .monaco-list-row", { hasText: name }).first().waitFor();
    await this.keys("Enter");
  }

  async goTo(line, column) {
    await this.keys("Control+g");
    await this.page.locator(".quick-input-widget input").fill(`:${line}:${column}`);
    await this.keys("Enter");
  }

  /** The line of the first text in a section, counted from 1. */
  static lineOf(text, section, start) {
    const lines = text.split(/\r?\n/);
    const first = lines.indexOf(`[${section}]`);
    return lines.findIndex((row, at) => at >= first && row.startsWith(start)) + 1;
  }

  /** What a page of the extension shows. */
  webview = () => this.page.frameLocator("iframe.webview.ready").frameLocator("iframe");
}
export const { lineOf } = Editor;
