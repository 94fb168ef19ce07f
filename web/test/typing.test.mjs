// What is typed goes where it was typed, however fast what comes next.

import assert from "node:assert/strict";
import { test } from "node:test";
import { browser, changedLines, download, kept, newPage, open, saveAs, server, skip, view, withPage } from "./page.mjs";
import { fixture } from "./support.mjs";

const DRIVE = "drive-402.eds";
const original = fixture(`eds/${DRIVE}`);

/** Has the keyboard in the text, which is there with the next frame only. */
async function focusText(page) {
  await view(page, "Text");
  await page.waitForFunction(() => {
    const text = document.querySelector(".text:not([hidden]) .cm-content");
    text?.focus();
    return text && document.activeElement === text;
  });
}

/** Puts the cursor at the beginning of a line, counted from 0, and types at once. */
async function typeAt(page, line, text) {
  await focusText(page);
  await page.keyboard.press("Control+Home");
  for (let at = 0; at < line; at++) await page.keyboard.press("ArrowDown");
  await page.keyboard.insertText(text);
}

async function press(page, keys) {
  await focusText(page);
  await page.keyboard.press(keys);
}

async function showObject(page, index) {
  await view(page, "Object");
  await page.getByLabel("Search objects", { exact: true }).fill(index);
  await page.getByRole("option", { name: new RegExp(`${index}h`) }).first().click();
}

async function setDefault(page, index, value) {
  await showObject(page, index);
  const field = page.locator(".form").getByLabel("Default value").first();
  await field.fill(value);
  await field.press("Enter");
}

test("a field that is left takes nothing, from the click on", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await view(page, "Object");
    await page.waitForSelector(".form h2:has-text('1000h')");
    await page.getByLabel("Search objects", { exact: true }).fill("1017");
    const option = page.getByRole("option", { name: /1017h/ });
    await option.waitFor();
    const isLocked = await option.evaluate((row) => {
      row.click();
      return [...document.querySelectorAll(".form :is(input, select)")].every((field) => field.disabled);
    });
    assert.ok(isLocked);
    await page.waitForSelector(".form h2:has-text('1017h')");
    assert.equal(await page.locator(".form :is(input, select):disabled").count(), 0);
  }));

for (const pause of [0, 100, 400]) {
  test(`undo takes back what was typed ${pause} ms before`, { skip }, () =>
    withPage(async (page) => {
      await open(page, [DRIVE, original]);
      await typeAt(page, 0, "; one\n");
      await page.waitForSelector(".document.current:has-text('•')");
      await page.keyboard.insertText("; two");
      await page.waitForTimeout(pause);
      await page.keyboard.press("Control+z");
      await page.waitForFunction(() => !document.querySelector(".cm-content").textContent.includes("; two"));
      const saved = (await saveAs(page)).bytes.toString("latin1").split(/\r?\n/);
      assert.deepEqual(saved.slice(0, 2), ["; one", original.toString("latin1").split(/\r?\n/)[0]]);
    }));
}

test("another file at once gets nothing of what was typed, and the first has it", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original], ["io-401.eds", fixture("eds/io-401.eds")]);
    const tab = (name) => page.locator(".document button", { hasText: name }).click();
    await tab(DRIVE);
    await typeAt(page, 0, "; by hand ");
    await tab("io-401.eds");
    assert.ok((await saveAs(page)).bytes.equals(fixture("eds/io-401.eds")));
    await tab(DRIVE);
    assert.equal((await saveAs(page)).bytes.toString("latin1"), `; by hand ${original.toString("latin1")}`);
  }));

test("a character that the encoding lacks stays, and UTF-8 is offered", { skip }, () =>
  withPage(async (page) => {
    const latin1 = Buffer.from(original.toString("latin1").replace("ParameterName=Device type", "ParameterName=Ger\xe4t"), "latin1");
    await open(page, [DRIVE, latin1]);
    await typeAt(page, 0, "; \u{4e2d} ");
    await page.locator(".notice").getByRole("button", { name: "Write the file in UTF-8" }).click();
    await page.waitForSelector(".document.current:has-text('•')");
    const saved = (await saveAs(page)).bytes.toString();
    assert.ok(saved.startsWith("; \u{4e2d} ;"), saved.slice(0, 20));
    assert.ok(saved.includes("ParameterName=Ger\u{e4}t"));
  }));

test("a redrawn form keeps what is being typed", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await page.getByLabel("Search objects", { exact: true }).fill("1017");
    await page.getByRole("option", { name: /1017h/ }).click();
    await page.waitForSelector(".form h2:has-text('1017h')");
    const field = page.getByLabel("Default value").first();
    await field.fill("12");
    await page.evaluate(() => document.querySelector('[data-key="base-hex"]').click());
    await page.waitForSelector('.form [data-key="base-hex"][aria-pressed="true"]');
    assert.equal(await page.locator(".document.current:has-text('•')").count(), 0);
    await page.keyboard.type("34");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".document.current:has-text('•')");
    const saved = (await saveAs(page)).bytes.toString("latin1").split(/\r?\n/);
    assert.deepEqual(changedLines(original, Buffer.from(saved.join("\r\n"), "latin1")).map((line) => saved[line]), ["DefaultValue=1234"]);
  }));

test("closing a file with changes asks", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    const close = page.getByRole("button", { name: `Close ${DRIVE}` });
    await typeAt(page, 0, "; by hand ");
    await close.click();
    await page.waitForSelector("dialog[open]:has-text('has changes that are not saved')");
    await page.locator("dialog[open] button", { hasText: "Cancel" }).click();
    assert.equal(await page.locator(".document").count(), 1);
    await close.click();
    await page.locator("dialog[open] button[type=submit]").click();
    await page.waitForFunction(() => document.querySelectorAll(".document").length === 0);
  }));

test("a dialog takes input when it is filled in, and keeps it when it is refused", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["coupler-modular.eds", fixture("eds/coupler-modular.eds")]);
    const isLocked = await page.getByRole("button", { name: "Configure …" }).evaluate((button) => {
      button.click();
      return [...document.querySelectorAll("dialog[open] :is(input, select, textarea)")].every((field) => field.matches(":disabled"));
    });
    assert.ok(isLocked);
    await page.fill("#configure-node-id", "10");
    await page.fill("#configure-settings", "9999=1");
    await page.getByRole("button", { name: "Plug in" }).click();
    const submit = page.locator("dialog[open] button[type=submit]");
    await submit.click();
    await page.waitForSelector("dialog[open] [role=alert]:has-text('9999')");
    assert.equal(await page.inputValue("#configure-node-id"), "10");
    assert.equal(await page.locator(".rack li").count(), 1);
    await page.fill("#configure-settings", "");
    // twice in one moment is once
    await submit.evaluate((button) => (button.click(), button.click()));
    await page.waitForSelector(".document.current:has-text('coupler-modular-node.dcf')");
    assert.equal(await page.locator("dialog[open]").count(), 0);
    assert.equal(await page.locator(".document").count(), 2);
  }));

test("changes survive a reload, as long as they are in no file", { skip }, async () => {
  const context = await browser.newContext({ acceptDownloads: true });
  const page = await newPage(context);
  page.on("dialog", (dialog) => dialog.accept());
  await page.goto(server.address);
  const latin1 = Buffer.from(original.toString("latin1").replace("ParameterName=Device type", "ParameterName=Ger\xe4t"), "latin1");
  await open(page, [DRIVE, latin1], ["io-401.eds", fixture("eds/io-401.eds")]);
  await page.locator(".document button", { hasText: DRIVE }).click();
  await typeAt(page, 0, "; by hand ");
  await kept(page, 1);
  // another page that is open keeps its own
  const second = await newPage(context);
  await second.goto(server.address);
  await open(second, ["io-401.eds", fixture("eds/io-401.eds")]);
  assert.equal(await second.locator(".document").count(), 1);
  await page.reload();
  await page.waitForSelector(`.notice:has-text('Opened again with changes that were not saved: ${DRIVE}')`);
  assert.equal(await page.locator(".document").count(), 1);
  await page.waitForSelector(".document.current:has-text('•')");
  assert.equal((await saveAs(page)).bytes.toString("latin1"), `; by hand ${latin1.toString("latin1")}`);
  await kept(page, 0);
  await page.reload();
  await page.waitForSelector(".welcome:not([hidden])");
  await context.close();
});

test("a dialog is about the file that it was opened for", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await page.getByRole("button", { name: "Save as …" }).click();
    await open(page, ["io-401.eds", fixture("eds/io-401.eds")]);
    await page.waitForSelector(".document.current:has-text('io-401.eds')");
    const saved = await download(page, () => page.locator("dialog[open] button[type=submit]").click());
    assert.equal(saved.name, DRIVE);
    assert.ok(saved.bytes.equals(original));
  }));

test("a file is saved as it is, whatever its name", { skip }, async () => {
  const node = fixture("dcf/drive-402-node8.dcf");
  const without = Buffer.from(node.toString("latin1").replace(/^NodeID=.*\r?\n/m, ""), "latin1");
  assert.ok(without.length < node.length);
  const files = [["node8.dcf", node], ["node", node], ["node.dcf.bak", node], ["none.dcf", without], ["io.xdc", fixture("xdc/io-401-node5.xdc")]];
  for (const [name, bytes] of files) {
    await withPage(async (page) => {
      await open(page, [name, bytes]);
      const saved = await saveAs(page);
      assert.equal(saved.name, name);
      assert.ok(saved.bytes.equals(bytes), name);
    });
  }
});

test("a file that is saved has no changes, and a refused dialog stays", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await setDefault(page, "1017", "1234");
    await page.waitForSelector(".document.current:has-text('•')");
    await saveAs(page);
    await page.waitForSelector(".document.current:not(:has-text('•'))");
    // what is refused keeps what was filled in
    await page.getByRole("button", { name: "Save as …" }).click();
    await page.selectOption("#save-format", "dcf");
    const lefts = await page.locator("dialog[open] label:visible").evaluateAll((labels) => labels.map((label) => label.getBoundingClientRect().left));
    assert.deepEqual([lefts.length, new Set(lefts).size], [5, 1]);
    await page.locator("dialog[open] button[type=submit]").click();
    await page.waitForSelector("dialog[open] [role=alert]:has-text('a DCF or XDC is for one node')");
    assert.equal(await page.locator("#save-format").inputValue(), "dcf");
  }));

test("two objects mapped at once are both in the PDO", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await page.getByRole("option", { name: /^TPDO 1 / }).click();
    const before = await page.locator(".pdo .mapped").count();
    const candidates = page.locator("button.mappable");
    await candidates.first().waitFor();
    await candidates.first().evaluate((button) => {
      button.click();
      button.click();
    });
    await page.waitForFunction((wanted) => document.querySelectorAll(".pdo .mapped").length === wanted, before + 2);
  }));

/** A generator of numbers below a bound, the same for the same seed (xorshift). */
function random(seed) {
  let state = seed * 2654435761 || 1;
  return (below) => {
    for (const by of [13, -17, 5]) state ^= by > 0 ? state << by : state >>> -by;
    return (state >>> 0) % below;
  };
}

/** What a document may be: text that is typed in two moments may be one step or two. */
class Model {
  constructor(text) {
    this.worlds = [{ before: [], now: text, after: [] }];
    this.isTyping = false;
  }
  edit(change, isTyped) {
    // what is as wanted already is no step
    const step = (world) => (change(world.now) === world.now ? world : { before: [...world.before, world.now], now: change(world.now), after: [] });
    const joined = ({ before, now }) => ({ before, now: change(now), after: [] });
    this.worlds = this.worlds.flatMap((world) => (isTyped && this.isTyping ? [step(world), joined(world)] : [step(world)]));
    this.isTyping = isTyped;
  }
  undo() {
    this.isTyping = false;
    this.worlds = this.worlds.map(({ before, now, after }) => (before.length ? { before: before.slice(0, -1), now: before.at(-1), after: [now, ...after] } : { before, now, after }));
  }
  redo() {
    this.isTyping = false;
    this.worlds = this.worlds.map(({ before, now, after }) => (after.length ? { before: [...before, now], now: after[0], after: after.slice(1) } : { before, now, after }));
  }
  saved(text) {
    this.isTyping = false;
    const expected = new Set(this.worlds.map(({ now }) => now));
    const [lines, wanted] = [text, [...expected][0]].map((one) => one.split("\r\n"));
    const differing = lines.filter((line) => !wanted.includes(line));
    assert.ok(expected.has(text), `saved, but not expected: ${JSON.stringify(differing)}; expected: ${JSON.stringify(wanted.filter((line) => !lines.includes(line)))}`);
    this.worlds = this.worlds.filter(({ now }) => now === text);
  }
}

const HEAD = 5;
const start = `${Array.from({ length: HEAD }, (_, line) => `; line ${line}\r\n`).join("")}${original.toString("latin1")}`;
const heartbeat = /(\[1017\][^[]*?DefaultValue=)[^\r\n]*/;

async function sequence(page, seed, done) {
  const next = random(seed);
  const names = ["one.eds", "two.eds"];
  await open(page, ...names.map((name) => [name, Buffer.from(start, "latin1")]));
  const models = Object.fromEntries(names.map((name) => [name, new Model(start)]));
  let current = names[1];
  await page.locator(".document button", { hasText: current }).click();
  const actions = [
    async (number) => {
      const [line, text] = [next(HEAD), `; typed ${number} `];
      await typeAt(page, line, text);
      models[current].edit((now) => now.split("\r\n").with(line, text + now.split("\r\n")[line]).join("\r\n"), true);
    },
    async (number) => {
      await setDefault(page, "1017", String(2000 + number));
      models[current].edit((now) => now.replace(heartbeat, `$1${2000 + number}`), false);
    },
    () => press(page, "Control+z").then(() => models[current].undo()),
    () => press(page, "Control+Shift+z").then(() => models[current].redo()),
    async () => {
      current = names.find((name) => name !== current);
      await page.locator(".document button", { hasText: current }).click();
    },
    async () => models[current].saved((await saveAs(page)).bytes.toString("latin1")),
    async (number) => {
      const value = ["rw", "ro", "const"][number % 3];
      await showObject(page, "1017");
      await page.locator(".form").getByLabel("Access").selectOption(value);
      models[current].edit((now) => now.replace(/(\[1017\][^[]*?AccessType=)[^\r\n]*/, `$1${value}`), false);
    },
    // in the table, and left without Enter: what comes next takes it
    async (number) => {
      await page.getByLabel("Search objects", { exact: true }).fill("1018");
      await view(page, "Table");
      await page.locator('.all [data-key="0x1018sub1 / ParameterName"]').fill(`Vendor ${number}`);
      models[current].edit((now) => now.replace(/(\[1018sub1\][^[]*?ParameterName=)[^\r\n]*/, `$1Vendor ${number}`), false);
    },
  ];
  for (let number = 0; number < 20; number++) {
    const action = [0, 0, 0, 1, 1, 2, 2, 3, 4, 5, 6, 7, 7][next(13)];
    const delay = next(3) === 0 ? next(400) : 0;
    done.push(`${action}+${delay}`);
    await actions[action](number);
    await page.waitForTimeout(delay);
  }
  for (const name of names) {
    current = name;
    await page.locator(".document button", { hasText: name }).click();
    await actions[5]();
  }
}

// `OBJDICT_SEQUENCES` is how many, from the seed `OBJDICT_SEED` on
const sequences = Number(process.env.OBJDICT_SEQUENCES ?? 2);
const first = Number(process.env.OBJDICT_SEED ?? 1);
test(`${sequences} sequences of typing, fields, undo, redo, files and saving give what was done`, { skip }, async () => {
  for (let seed = first; seed < first + sequences; seed++) {
    const done = [];
    await withPage((page) => sequence(page, seed, done)).catch((error) => {
      error.message += `\nseed ${seed}: ${done.join(" ")}`;
      throw error;
    });
  }
});

test("a default that is set twice by keys is one step", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, original]);
    await setDefault(page, "1017", "1234");
    await press(page, "Control+z");
    await page.waitForSelector(".document.current:not(:has-text('•'))");
    assert.equal(changedLines(original, (await saveAs(page)).bytes).length, 0);
  }));
