// The table of the whole dictionary, and what stays when a part of the page is drawn again.

import assert from "node:assert/strict";
import { test } from "node:test";
import { changedLines, checked, open, saveAs, skip, view, withPage } from "./page.mjs";
import { fixture, large } from "./support.mjs";

const DRIVE = "drive-402.eds";
const original = fixture(`eds/${DRIVE}`);

/** Shows the table, with its rows. */
async function showTable(page, ...files) {
  await open(page, ...files);
  await view(page, "Table");
  await page.waitForSelector(".all input");
}

const cell = (page, place) => page.locator(`.all [data-key="${place}"]`);
const focused = (page, key) => page.waitForFunction((key) => document.activeElement.dataset.key === key, key);

/** The lines of what is saved that differ from the original. */
async function changes(page) {
  const saved = (await saveAs(page)).bytes;
  const lines = saved.toString("latin1").split(/\r?\n/);
  return changedLines(original, saved).map((line) => lines[line]);
}

test("all objects and entries are in one table, and each edit is one line", { skip }, () =>
  withPage(async (page) => {
    await showTable(page, [DRIVE, original]);
    assert.deepEqual(await page.locator(".all thead th > button, .all thead th:not(:has(button))").allTextContents(), ["Index", "Sub", "Name", "Type", "Access", "Default", "Lowest", "Highest", "PDO", "Flags", "Unit"]);
    const sections = original.toString("latin1").match(/^\[[0-9A-F]{4}(sub[0-9A-F]+)?\]/gim).length;
    assert.equal(await page.locator(".dictionary .count").textContent(), `${sections} rows`);
    await page.getByLabel("Search objects", { exact: true }).fill("heartbeat time");
    await page.waitForFunction(() => document.querySelectorAll(".all tbody tr.object").length === 2);
    await cell(page, "0x1017 / DefaultValue").fill("1234");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".document.current:has-text('•')");
    await cell(page, "0x1017 / AccessType").selectOption("ro");
    await page.waitForSelector(".all [data-key='0x1017 / AccessType']:not(.implied)");
    await page.getByRole("button", { name: "hex", exact: true }).locator("visible=true").click();
    await page.waitForFunction(() => document.querySelector(".all [data-key='0x1017 / DefaultValue']").value === "0x4D2");
    assert.deepEqual(await changes(page), ["AccessType=ro", "DefaultValue=1234"]);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await page.waitForFunction(() => document.querySelector(".all [data-key='0x1017 / DefaultValue']").value === "0x1F4");
    assert.deepEqual(await changes(page), []);
  }));

test("flags and units are columns of the table", { skip }, () =>
  withPage(async (page) => {
    await showTable(page, [DRIVE, original]);
    // `0x1` in the file
    assert.equal(await cell(page, "0x1010sub1 / ObjFlags").evaluate((select) => select.selectedOptions[0].textContent), "not written");
    await cell(page, "0x1000 / ObjFlags").selectOption({ label: "not written" });
    await page.waitForSelector(".document.current:has-text('•')");
    await cell(page, "0x1000 / Unit").fill("mm");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.querySelector(".all [data-key='0x1000 / Unit']").defaultValue === "mm");
    const section = /\[1000\][^[]*/.exec((await saveAs(page)).bytes.toString("latin1"))[0];
    assert.match(section, /ObjFlags=(0x)?1\s/);
  }));

test("each column of a node's table has its place", { skip }, () =>
  withPage(async (page) => {
    await showTable(page, ["node.dcf", fixture("dcf/drive-402-node8.dcf")]);
    assert.equal(await page.getByRole("button", { name: "Configured", exact: true }).count(), 1);
    const widths = await page.locator(".all thead th").evaluateAll((heads) => heads.map((head) => head.clientWidth));
    assert.ok(Math.min(...widths) >= 30 && widths[2] >= 100, `${widths}`);
  }));

test("the keyboard goes through the table, and a finding leads to its cell", { skip }, () =>
  withPage(async (page) => {
    const broken = original.toString("latin1").replace(/(\[6065\][^[]*?DefaultValue=)\S+/, "$10x1FFFFFFFF");
    await showTable(page, [DRIVE, broken]);
    await cell(page, "0x1000 / ParameterName").focus();
    await page.keyboard.press("ArrowDown");
    await focused(page, "0x1001 / ParameterName");
    await page.keyboard.press("PageDown");
    const at = () => page.evaluate(() => document.activeElement.closest("tr").getBoundingClientRect().top);
    const place = await page.evaluate(() => document.activeElement.closest("tr").dataset.place);
    assert.notEqual(place, "0x1001");
    const last = original.toString("latin1").match(/^\[[0-9A-F]{4}(sub[0-9A-F]+)?\]/gim).map((name) => `0x${name.slice(1, -1)}`).sort().at(-1);
    // a key that is held repeats faster than rows are drawn
    for (let turn = 0; turn < 60 && !(await page.evaluate((last) => document.activeElement.dataset.key === `${last} / ParameterName`, last)); turn++) {
      await page.keyboard.press("PageDown");
      await page.waitForTimeout(30);
    }
    await focused(page, `${last} / ParameterName`);
    assert.ok((await at()) < 800);
    await page.keyboard.press("PageUp");
    // a select has its own arrows: with Ctrl it leads to the next one
    await page.locator(".all tr:focus-within .AccessType select").focus();
    const before = await page.evaluate(() => document.activeElement.dataset.key);
    await page.keyboard.press("Control+ArrowDown");
    await page.waitForFunction((before) => document.activeElement.dataset.key !== before && /AccessType$/.test(document.activeElement.dataset.key), before);
    await checked(page);
    await page.locator(".finding.error .where").first().click();
    await focused(page, "0x6065 / DefaultValue");
    assert.equal(await page.getByRole("button", { name: "Table", exact: true }).getAttribute("aria-pressed"), "true");
    await page.locator(".all [data-key='show-0x6065']").click();
    await page.waitForSelector(".form:not([hidden]) h2:has-text('6065h')");
  }));

test("a cell that is scrolled away gives its text to the file", { skip }, () =>
  withPage(async (page) => {
    await showTable(page, [DRIVE, original]);
    await cell(page, "0x1000 / ParameterName").fill("What it is");
    await page.locator(".dictionary .scroll").evaluate((scroll) => (scroll.scrollTop = scroll.scrollHeight));
    await page.waitForFunction(() => !document.querySelector(".all [data-place='0x1000']"));
    await page.waitForSelector(".document.current:has-text('•')");
    assert.deepEqual(await changes(page), ["ParameterName=What it is"]);
  }));

test("the table of a file of 500 KB asks and draws for the rows in sight", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["large.eds", large(500_000)]);
    await checked(page);
    const [times, asked] = await page.evaluate(async () => {
      const send = Worker.prototype.postMessage;
      const asked = [0];
      Worker.prototype.postMessage = function (message, ...more) {
        if (message.request?.do === "form") asked[asked.length - 1]++;
        send.call(this, message, ...more);
      };
      const until = async (isThere) => {
        const start = performance.now();
        while (!isThere()) await new Promise((resolve) => requestAnimationFrame(resolve));
        return Math.round(performance.now() - start);
      };
      const scroll = () => document.querySelector(".dictionary .scroll");
      const isDrawn = () => {
        const { left, bottom } = scroll().getBoundingClientRect();
        return document.elementFromPoint(left + 200, bottom - 40)?.closest("tr")?.querySelector("input");
      };
      [...document.querySelectorAll(".views button")].find((button) => button.textContent === "Table").click();
      const times = [await until(isDrawn)];
      for (const part of [0.3, 0.7, 1]) {
        asked.push(0);
        scroll().scrollTop = scroll().scrollHeight * part;
        times.push(await until(isDrawn));
      }
      return [times, asked];
    });
    console.log(`table of 500 KB: shown in ${times[0]} ms, scrolled in ${times.slice(1).join(", ")} ms`);
    const [drawn, rows, last] = await page.evaluate(() => [document.querySelectorAll(".all tbody tr").length, parseInt(document.querySelector(".dictionary .count").textContent), [...document.querySelectorAll(".all tbody tr")].at(-1).dataset.place]);
    assert.ok(rows > 3000 && drawn < 120, `${drawn} of ${rows}`);
    assert.match(last, /^0x[2-9A-F]/);
    const bottom = await page.locator(".all tbody tr").last().evaluate((row) => row.getBoundingClientRect().bottom - row.closest(".scroll").getBoundingClientRect().bottom);
    assert.ok(Math.abs(bottom) < 20, `${bottom} px from the end`);
    assert.ok(Math.max(...asked) < 120, `${asked}`);
  }));

test("what is drawn again keeps an open help, the selection, the scroll and what was typed", { skip }, () =>
  withPage(async (page) => {
    await page.setViewportSize({ width: 1280, height: 420 });
    await open(page, [DRIVE, original]);
    await checked(page);
    await view(page, "Object");
    await page.getByLabel("Search objects", { exact: true }).fill("1A00");
    await page.getByRole("option", { name: /1A00h/ }).click();
    await page.waitForSelector(".form h2:has-text('1A00h')");
    await page.getByLabel("How many sub-indexes to add").fill("7");
    const name = page.getByLabel("Name, sub-index 01");
    await name.fill("Half a na");
    await name.evaluate((input) => input.setSelectionRange(2, 6));
    await page.evaluate(() => {
      window.former = { help: document.querySelector("#help-object-DefaultValue"), field: document.activeElement, finding: document.querySelector(".findings ul").firstElementChild };
      window.former.help.showPopover();
      document.querySelector(".form").scrollTop = 60;
      document.querySelector("[data-key=base-hex]").click();
    });
    await page.waitForSelector(".form [data-key=base-hex][aria-pressed=true]");
    const kept = await page.evaluate(() => {
      const { help, field, finding } = window.former;
      return [help.isConnected && help.matches(":popover-open"), document.activeElement === field, field.value, field.selectionStart, field.selectionEnd, document.querySelector(".form").scrollTop, document.querySelector("[data-key=add-count]").value, finding.isConnected];
    });
    assert.deepEqual(kept, [true, true, "Half a na", 2, 6, 60, "7", true]);
    // the same for a change of the text, which brings a form, objects and findings
    await page.getByLabel("Name, sub-index 02").evaluate((input) => {
      input.value = "Another name";
      input.dispatchEvent(new Event("change", { bubbles: true }));
    });
    await page.waitForSelector(".document.current:has-text('•')");
    await checked(page);
    assert.equal(await page.evaluate(() => window.former.help.matches(":popover-open") && window.former.field.value), "Half a na");
  }));

test("the changes of a text are drawn once", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await page.getByLabel("Search objects", { exact: true }).fill("1017");
    await page.getByRole("option", { name: /1017h/ }).click();
    await page.getByLabel("Default value").first().fill("1234");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".document.current:has-text('•')");
    await view(page, "Changes");
    await page.waitForSelector(".diff .cm-changedLine");
    await page.evaluate(() => (window.former = document.querySelector(".diff .cm-editor")));
    await page.getByLabel("Search objects", { exact: true }).fill("1018");
    await page.waitForFunction(() => document.querySelectorAll(".row[data-index]").length === 1);
    assert.ok(await page.evaluate(() => window.former.isConnected));
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await page.waitForSelector(".diff .nothing:has-text('Nothing was changed')");
  }));

test("what is opened in a network stays open when a description changes", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["island.eds", fixture("network/island.eds")], ["servo.eds", fixture("network/servo.eds")], ["line.toml", fixture("network/line.toml")]);
    await page.waitForSelector(".network details");
    const details = page.locator(".network details").first();
    await details.locator("summary").click();
    await details.evaluate((element) => (window.former = element));
    await page.locator(".document button", { hasText: "servo.eds" }).first().click();
    await view(page, "Device");
    const box = page.getByLabel("10 kbit/s", { exact: true });
    await box.click();
    await page.waitForSelector(".document.current:has-text('•')");
    await page.locator(".document button", { hasText: "line.toml" }).click();
    await page.waitForFunction(() => window.former.isConnected && window.former.open);
  }));
