// Makes the pictures of docs/guides/editors.md and of the README in a real editor, with the packaged extension and the debug build:
// `node test/pictures.mjs ENTRY`, where ENTRY is `out/node/entry.js` of the package `code-server` 4.100.3. The tests do without it,
// because the editor compiles native modules when it is installed. Chromium is driven by playwright-core of `web`.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { fixture, objdict } from "./objdict.mjs";

const { chromium } = createRequire(new URL("../../../web/package.json", import.meta.url))("playwright-core");
const images = fileURLToPath(new URL("../../../docs/images/", import.meta.url));
const extension = fileURLToPath(new URL("..", import.meta.url));
const work = mkdtempSync(join(tmpdir(), "objdict-"));
const [device, user] = [join(work, "device"), join(work, "data/User")];
const drive = join(device, "drive-402.eds");
mkdirSync(device);
mkdirSync(user, { recursive: true });
copyFileSync(fixture("eds/drive-402.eds"), drive);
const quiet = { "workbench.startupEditor": "none", "workbench.colorTheme": "Default Light Modern", "editor.minimap.enabled": false };
const trusted = { "security.workspace.trust.enabled": false, "files.autoSave": "off", "objdict.server.path": objdict };
writeFileSync(join(user, "settings.json"), JSON.stringify({ ...quiet, ...trusted }));
const vsix = join(work, "objdict.vsix");
execFileSync("npm", ["run", "--silent", "package", "--", "--out", vsix], { cwd: extension });

const folders = ["--user-data-dir", join(work, "data"), "--extensions-dir", join(work, "extensions")];
const editor = [resolve(process.argv[2] ?? ""), ...folders];
execFileSync(process.execPath, [...editor, "--install-extension", vsix]);
const server = spawn(process.execPath, [...editor, "--auth", "none", "--bind-addr", "127.0.0.1:0", "--disable-update-check"]);
const address = await new Promise((found) => {
  let said = "";
  server.stdout.on("data", (part) => {
    said += part;
    const at = /listening on (http:\S+)/.exec(said);
    if (at) found(at[1]);
  });
});
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
try {
  const page = await browser.newPage({ viewport: { width: 960, height: 450 } });
  const key = (...keys) => keys.reduce((before, name) => before.then(() => page.keyboard.press(name)), Promise.resolve());
  const choose = async (name) => {
    await key("F1");
    await page.locator(".quick-input-widget input").fill(`>${name}`);
    await page.locator(".quick-input-list .monaco-list-row", { hasText: name }).first().waitFor();
    await key("Enter");
  };
  const lines = readFileSync(drive, "utf8").split(/\r?\n/);
  const goTo = async (section, start, column) => {
    const first = lines.indexOf(`[${section}]`);
    const line = lines.findIndex((row, at) => at >= first && row.startsWith(start)) + 1;
    await key("Control+g");
    await page.locator(".quick-input-widget input").fill(`:${line}:${column}`);
    await key("Enter");
  };
  const picture = (name) => page.screenshot({ path: join(images, `vscode-${name}.png`) });
  await page.goto(`${address}?folder=${encodeURIComponent(device)}`);
  await page.getByRole("treeitem", { name: "drive-402.eds" }).dblclick();
  await page.locator(".view-line").first().waitFor();
  await key("Control+b");
  await goTo("1A00sub1", "DefaultValue=", 24);
  // the path above the text is an answer of the server
  await page.locator(".breadcrumbs-control", { hasText: "1A00:01" }).waitFor({ timeout: 60_000 });

  // a mapping of 8 of the 16 bits of the statusword
  await key("Backspace", "Backspace");
  await page.keyboard.type("08");
  await page.locator(".squiggly-error").first().waitFor();
  await choose("Show or Focus Hover");
  await page.locator(".monaco-hover", { hasText: /Quick Fix\.\.\./ }).first().waitFor();
  await picture("findings");
  await key("Escape", "Control+.");
  await page.locator(".action-widget", { hasText: "write `0x60410010`" }).waitFor();
  await key("Enter");
  await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
  await key("Control+s");
  await page.locator(".tab.dirty").waitFor({ state: "detached" });
  assert.equal(readFileSync(drive, "utf8"), readFileSync(fixture("eds/drive-402.eds"), "utf8"));

  await choose("objdict: Show the PDO under the cursor");
  const drawing = page.frameLocator("iframe.webview.ready").frameLocator("iframe").locator("svg[role=img]");
  await drawing.waitFor();
  await picture("pdo");
  await drawing.locator("a").first().click();
  await page.locator(".breadcrumbs-control", { hasText: "6041" }).waitFor();
} finally {
  await browser.close();
  server.kill();
  rmSync(work, { recursive: true, force: true });
}
