// What a new user does, with as few clicks and keys as it takes: a broken EDS is opened, fixed, extended, mapped and saved.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { checked, download, skip, withPage } from "./page.mjs";
import { fixture } from "./support.mjs";

/** Clicks and keys beyond the texts. */
const MAX_STEPS = 40;

const NAME = "drive-402.eds";
const original = fixture(`eds/${NAME}`).toString("latin1");
const broken = original
  .replace("SupportedObjects=18", "SupportedObjects=17")
  .replace(/(\[2001\][^[]*?SubNumber=)8/, "$17")
  .replace(/(\[1017\][^[]*?DefaultValue=)500/, "$170000");

test("a new user repairs, extends and saves an EDS in forty clicks and keys", { skip }, () =>
  withPage(async (page) => {
    const steps = [];
    const see = async (name) => process.env.OBJDICT_VIEWS && (await page.waitForTimeout(400), await page.screenshot({ path: join(process.env.OBJDICT_VIEWS, `step-${name}.png`) }));
    const click = async (what, target) => (steps.push(what), await target.click());
    const press = async (what, key) => (steps.push(`${what} (${key})`), await page.keyboard.press(key));
    /** A select takes a click to open it, and one for the option. */
    const choose = async (what, target, option) => (steps.push(what, what), await target.selectOption(option));
    const write = (text) => page.keyboard.type(text);
    const button = (name, within = page) => within.getByRole("button", { name, exact: true });
    const dialog = page.locator("dialog[open]");

    await see("start");
    const chooser = page.waitForEvent("filechooser");
    await click("choose files", button("Choose files …"));
    steps.push("the file", "open");
    await (await chooser).setFiles([{ name: NAME, mimeType: "application/octet-stream", buffer: Buffer.from(broken, "latin1") }]);
    await page.waitForSelector(".overview .card");
    await checked(page);
    await page.waitForSelector(".summary:has-text('3 errors')");
    await see("opened");

    await click("make all safe fixes", page.locator(".findings").getByRole("button", { name: "Make all safe fixes" }));
    await page.waitForSelector(".summary:has-text('1 error')");
    await click("the error that is left", page.locator(".finding.error .where"));
    await page.waitForFunction(() => document.activeElement?.dataset?.key === "0x1017 / DefaultValue");
    await see("error");
    await write("500");
    await press("take it", "Enter");
    await page.waitForSelector(".summary:has-text('0 errors')");
    await see("fixed");

    await click("add an object", button("Add object …"));
    await page.waitForFunction(() => document.querySelector("dialog[open] #own-kind") && !document.querySelector("dialog[open] fieldset.body").disabled);
    await click("its name", dialog.getByLabel("Name", { exact: true }));
    await write("Zone limits");
    await choose("a RECORD", dialog.locator("#own-kind"), "RECORD");
    await choose("of bytes", dialog.getByLabel("Data type"), "UNSIGNED8");
    await click("PDOs may carry it", dialog.getByLabel("PDOs may carry it"));
    await see("add");
    await click("add", dialog.locator("button[type=submit]"));
    await page.waitForFunction(() => document.activeElement?.dataset?.key?.endsWith("sub1 / ParameterName"));
    for (const [name, key] of [["Lower limit", "ArrowDown"], ["Upper limit", "ArrowDown"], ["Hysteresis", "Enter"]]) {
      await write(name);
      await press("next name", key);
    }
    await page.waitForSelector("input[value='Hysteresis']");
    await see("record");

    await press("search", "Control+k");
    await write("TPDO 3");
    await press("show it", "Enter");
    await page.waitForFunction(() => document.activeElement?.dataset?.key === "mappable-search");
    await write("Zone");
    const before = await page.locator(".pdo .mapped").count();
    for (let mapped = 1; mapped <= 3; mapped++) {
      await press("map the next entry", "Enter");
      await page.waitForFunction((wanted) => document.querySelectorAll(".pdo .mapped").length === wanted, before + mapped);
    }
    await see("mapped");

    await click("device", button("Device", page.locator(".views")));
    await click("without 10 kbit/s", page.getByLabel("10 kbit/s", { exact: true }));
    await click("without 20 kbit/s", page.getByLabel("20 kbit/s", { exact: true }));
    await page.waitForFunction(() => document.querySelector('[data-key="DeviceInfo / BaudRate_20"]')?.checked === false);
    assert.equal(await page.locator(".notice.error:visible").count(), 0);
    await see("rates");

    await press("save", "Control+s");
    await page.waitForFunction(() => document.activeElement?.id === "save-name");
    const eds = await download(page, () => press("as it is", "Enter"));
    await press("save", "Control+s");
    await dialog.waitFor();
    await choose("as DCF", dialog.locator("#save-format"), "dcf");
    await click("node-ID", dialog.getByLabel("Node-ID"));
    await write("5");
    await click("bit rate", dialog.getByLabel("Bit rate in kbit/s"));
    await write("250");
    await see("save");
    const dcf = await download(page, () => press("save", "Enter"));
    await click("compare with the original", button("Changes", page.locator(".views")));
    await page.waitForSelector(".diff .cm-changedLine");
    await see("changes");

    console.log(`${steps.length} clicks and keys: ${steps.join(", ")}`);
    assert.ok(steps.length <= MAX_STEPS, `${steps.length}`);
    const text = eds.bytes.toString("latin1");
    const section = (text, name) => new RegExp(`\\[${name}\\][^[]*`, "i").exec(text)?.[0] ?? "";
    const [, index] = /\[([0-9A-F]{4})\]\s+ParameterName=Zone limits/.exec(text);
    assert.match(section(text, "ManufacturerObjects"), new RegExp(`SupportedObjects=19\\s[^[]*=0x${index}\\s`));
    assert.match(section(text, "2001"), /SubNumber=8\s/);
    assert.match(section(text, "1017"), /DefaultValue=500\s/);
    for (const [at, name] of ["Lower limit", "Upper limit", "Hysteresis"].entries()) {
      assert.match(section(text, `${index}sub${at + 1}`), new RegExp(`ParameterName=${name}\\s[^[]*DataType=0x0005\\s[^[]*PDOMapping=1\\s`));
      assert.match(text, new RegExp(`\\[1A02sub\\d\\][^[]*DefaultValue=0x${index}0${at + 1}08`, "i"));
    }
    assert.match(section(text, "DeviceInfo"), /BaudRate_10=0\s+BaudRate_20=0\s+BaudRate_50=1\s/);
    assert.equal(dcf.name, "drive-402.dcf");
    assert.match(dcf.bytes.toString("latin1"), /\[DeviceComissioning\][^[]*NodeID=(5|0x05)\s/);
    // all that was not touched stays, but for the numbers in the list of objects
    const now = new Set(text.split(/\r?\n/));
    const gone = original.split(/\r?\n/).filter((line) => !now.has(line) && !/^\d+=0x[0-9A-F]{4}$/.test(line));
    assert.deepEqual(gone, ["BaudRate_10=1", "BaudRate_20=1", "SupportedObjects=18"]);
  }));
