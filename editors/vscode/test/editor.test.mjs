// The extension in a real editor, as a user works with it. `OBJDICT_CODE_SERVER` names `out/node/entry.js` of
// code-server 4.100.3, as `.ci/run editor` installs it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { lineOf, withEditor } from "./editor.mjs";
import { fixture } from "./objdict.mjs";

const entry = process.env.OBJDICT_CODE_SERVER;
const skip = entry === undefined && "only with OBJDICT_CODE_SERVER=…/code-server/out/node/entry.js";
const drive = readFileSync(fixture("eds/drive-402.eds"));
const latin1 = Buffer.from(drive.toString("latin1").replace("ParameterName=Device type", "ParameterName=Ger\xe4tetyp"), "latin1");

const files = { "drive-402.eds": drive, "latin1.eds": latin1, "node.dcf": readFileSync(fixture("dcf/drive-402-node8.dcf")), "node.eds": "mine" };

test("a user checks, fixes, converts and reads a description in the editor", { skip, timeout: 600_000 }, (t) =>
  withEditor(entry, files, async (editor) => {
    const { page } = editor;
    page.setDefaultTimeout(60_000);
    const notice = (text) => page.locator(".notification-list-item", { hasText: text });

    await t.test("the server answers, a finding is underlined, and its fix is offered", async () => {
      await editor.open("drive-402.eds");
      await editor.goTo(lineOf(drive.toString(), "1A00sub1", "DefaultValue="), 24);
      await page.locator(".breadcrumbs-control", { hasText: "1A00:01" }).waitFor();
      await editor.keys("Backspace", "Backspace");
      await page.keyboard.type("08");
      await page.locator(".squiggly-error").first().waitFor();
      const fix = page.locator(".action-widget", { hasText: "write `0x60410010`" });
      // a slow server is still about the text of a moment before
      for (let turn = 0; turn < 20 && !(await fix.isVisible()); turn++) {
        await editor.keys("Escape", "Control+.");
        await fix.waitFor({ timeout: 3000 }).catch(() => {});
      }
      await editor.keys("Enter");
      await page.locator(".squiggly-error").first().waitFor({ state: "detached" });
      await editor.keys("Control+s");
      await page.locator(".tab.active.dirty").waitFor({ state: "detached" });
      assert.deepEqual(readFileSync(editor.path("drive-402.eds")), drive);
    });

    await t.test("the documentation has the whole width of the editor", async () => {
      await editor.run("objdict: Show documentation");
      await editor.webview().locator("h1").first().waitFor();
      assert.equal(await page.locator(".editor-group-container").count(), 1);
      const [shown, group] = await Promise.all([page.locator("iframe.webview.ready"), page.locator(".editor-group-container")].map((element) => element.boundingBox()));
      assert.ok(shown.width > 0.95 * group.width, `${shown.width} of ${group.width} px`);
    });

    await t.test("from the page too, a conversion offers other formats, asks for the node-ID and refuses a wrong one", async () => {
      await editor.run("objdict: Convert to another format");
      const row = (name) => page.locator(".quick-input-list .monaco-list-row").filter({ has: page.getByText(name, { exact: true }) });
      await row("dcf").waitFor();
      await row("xdd").waitFor();
      assert.equal(await row("eds").count(), 0);
      assert.match(await row("dcf").textContent(), /asks for its node-ID/);
      await page.locator(".quick-input-widget input").fill("dcf");
      await editor.keys("Enter");
      const field = page.locator(".quick-input-widget input[aria-label*='node' i]");
      await field.waitFor();
      await field.fill("128");
      await page.locator(".quick-input-widget", { hasText: "a node-ID is a number from 1 to 127" }).waitFor();
      await field.fill("5");
      await editor.keys("Enter");
      await page.locator(".tab.active", { hasText: "drive-402.dcf" }).waitFor();
      assert.match(readFileSync(editor.path("drive-402.dcf"), "latin1"), /\[DeviceComissioning\][^[]*NodeID=(0x0)?5\s/);
    });

    await t.test("a file that exists is replaced only after a question", async () => {
      await editor.open("node.dcf");
      const convert = async () => {
        await editor.run("objdict: Convert to another format");
        await page.locator(".quick-input-list .monaco-list-row", { hasText: "xdd" }).waitFor();
        await page.locator(".quick-input-widget input").fill("eds");
        await editor.keys("Enter");
        await page.locator(".monaco-dialog-box", { hasText: "node.eds` exists. Replace it?" }).waitFor();
      };
      await convert();
      await editor.keys("Escape");
      await page.locator(".monaco-dialog-box").waitFor({ state: "detached" });
      assert.equal(readFileSync(editor.path("node.eds"), "utf8"), "mine");
      await convert();
      await page.locator(".monaco-dialog-box").getByRole("button", { name: "Replace" }).click();
      await page.locator(".tab.active", { hasText: "node.eds" }).waitFor();
      assert.match(readFileSync(editor.path("node.eds"), "latin1"), /\[DeviceInfo\]/);
    });

    await t.test("a Latin-1 file is read as it is, and saving keeps its letters", async () => {
      await editor.open("latin1.eds");
      await editor.goTo(lineOf(latin1.toString("latin1"), "1000", "ParameterName="), 1);
      await page.locator(".view-line", { hasText: /^ParameterName=Gerätetyp$/ }).waitFor();
      await page.locator(".statusbar-item", { hasText: "Windows 1252" }).waitFor();
      assert.equal(await notice("is not UTF-8").count(), 0);
      await editor.goTo(1, 1);
      await page.keyboard.type("; by hand");
      await editor.keys("Enter", "Control+s");
      await page.locator(".tab.active.dirty").waitFor({ state: "detached" });
      const saved = readFileSync(editor.path("latin1.eds"));
      assert.deepEqual(saved.subarray(saved.indexOf("\n") + 1), latin1);
    });
  }, { width: 1280, height: 800 }));
