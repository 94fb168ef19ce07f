// Makes the pictures of docs/guides/editors.md and of the README in a real editor: `node test/pictures.mjs ENTRY`, where ENTRY is
// `out/node/entry.js` of code-server 4.100.3, as `.ci/run editor` installs it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { lineOf, withEditor } from "./editor.mjs";
import { fixture } from "./objdict.mjs";

const images = fileURLToPath(new URL("../../../docs/images/", import.meta.url));
const drive = readFileSync(fixture("eds/drive-402.eds"));

await withEditor(process.argv[2] ?? "", { "drive-402.eds": drive }, async (editor) => {
  const { page } = editor;
  const picture = (name) => page.screenshot({ path: join(images, `vscode-${name}.png`) });
  await editor.open("drive-402.eds");
  await editor.keys("Control+b");
  await editor.goTo(lineOf(drive.toString(), "1A00sub1", "DefaultValue="), 24);
  // the path above the text is an answer of the server
  await page.locator(".breadcrumbs-control", { hasText: "1A00:01" }).waitFor({ timeout: 60_000 });

  // a mapping of 8 of the 16 bits of the statusword
  await editor.keys("Backspace", "Backspace");
  await page.keyboard.type("08");
  await page.locator(".squiggly-error").first().waitFor();
  await editor.run("Show or Focus Hover");
  await page.locator(".monaco-hover", { hasText: /Quick Fix\.\.\./ }).first().waitFor();
  await picture("findings");
  await editor.keys("Escape", "Control+.");
  await page.locator(".action-widget", { hasText: "write `0x60410010`" }).waitFor();
  await editor.keys("Enter");
  await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
  await editor.keys("Control+s");
  await page.locator(".tab.dirty").waitFor({ state: "detached" });
  assert.deepEqual(readFileSync(editor.path("drive-402.eds")), drive);

  await editor.run("objdict: Show the PDO under the cursor");
  const drawing = editor.webview().locator("svg[role=img]");
  await drawing.waitFor();
  await picture("pdo");
  await drawing.locator("a").first().click();
  await page.locator(".breadcrumbs-control", { hasText: "6041" }).waitFor();
});
