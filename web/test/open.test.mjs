// The page that `objdict open` serves, in Chromium: files of the disk, which it saves in place.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { test } from "node:test";
import { browser, kept, newPage, skip as noBrowser } from "./page.mjs";
import { command, fixture, noCommand } from "./support.mjs";

const skip = noBrowser || noCommand;
// the command reads the page when it starts, so a new page needs no new command
const env = { ...process.env, OBJDICT_WORKBENCH: fileURLToPath(new URL("../dist/objdict-workbench.html", import.meta.url)) };

/** Opens what the command serves of a folder with these files; `use` gets the page and the folder. */
async function serving(files, args, use) {
  const folder = mkdtempSync(join(tmpdir(), "objdict-open-"));
  for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
  const server = spawn(command, ["open", "--no-browser", ...args], { cwd: folder, env, stdio: ["ignore", "pipe", "ignore"] });
  const ended = once(server, "exit");
  const context = await browser.newContext();
  try {
    const [address] = await once(createInterface({ input: server.stdout }), "line");
    const page = await newPage(context);
    const [requests, problems] = [[], []];
    page.on("request", (request) => requests.push(request.url()));
    page.on("pageerror", (error) => problems.push(String(error)));
    page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
    await page.goto(address);
    await use({ page, folder, stop: () => server.kill() && ended });
    assert.deepEqual(requests.filter((url) => !url.startsWith(address) && !/^(blob|data):/.test(url)), []);
    // a refusal of the server is shown, and Chromium logs it too
    assert.deepEqual(problems.filter((text) => !/the server responded with a status of 4\d\d|ERR_CONNECTION_|ERR_EMPTY_RESPONSE/.test(text)), []);
  } finally {
    await context.close();
    server.kill();
    await ended;
    rmSync(folder, { recursive: true });
  }
}

const isShown = (page, name) => page.waitForSelector(`.document.current:has-text("${name}")`);

/** Waits until the field has another value. */
async function isNot(field, value) {
  for (let turn = 0; (await field.inputValue()) === value; turn++) {
    assert.ok(turn < 300, `it is ${value} still`);
    await field.page().waitForTimeout(100);
  }
}

async function setDefault(page, index, value) {
  await page.getByLabel("Search objects", { exact: true }).fill(index);
  await page.getByRole("option", { name: new RegExp(`${index}h`) }).first().click();
  const field = page.getByLabel("Default value").first();
  await field.fill(value);
  await field.press("Enter");
  await page.waitForSelector(".document.current:has-text('•')");
}

async function save(page) {
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.locator("dialog[open] button[type=submit]").click();
}

/** The lines that differ. */
function changedLines(old, now) {
  const [before, after] = [old, now].map((bytes) => bytes.toString("latin1").split("\n"));
  assert.equal(before.length, after.length);
  return after.filter((line, number) => before[number] !== line);
}

test("an edited default is one changed line on the disk", { skip }, async () => {
  const drive = Buffer.from(fixture("eds/drive-402.eds").toString("latin1").replace("ParameterName=Device type", "ParameterName=Ger\xe4t"), "latin1");
  await serving({ "drive.eds": drive }, ["drive.eds"], async ({ page, folder }) => {
    const disk = () => readFileSync(join(folder, "drive.eds"));
    await isShown(page, "drive.eds");
    await setDefault(page, "1017", "1234");
    await page.keyboard.press("Control+s");
    await page.waitForSelector("dialog[open]:has-text('Replace drive.eds on the disk?')");
    assert.ok(disk().equals(drive), "nothing is written before the answer");
    await page.locator("dialog[open] button", { hasText: "Cancel" }).click();
    assert.ok(disk().equals(drive), "nothing is written after `Cancel`");
    await save(page);
    await page.waitForSelector(".notice.note:has-text('drive.eds is saved')");
    await page.waitForSelector(".document.current:not(:has-text('•'))");
    assert.deepEqual(changedLines(drive, disk()).map((line) => line.trim()), ["DefaultValue=1234"]);
    // and again, from what was saved
    await setDefault(page, "1017", "1235");
    await save(page);
    await page.waitForSelector(".document.current:not(:has-text('•'))");
    assert.deepEqual(changedLines(drive, disk()).map((line) => line.trim()), ["DefaultValue=1235"]);
  });
});

test("what another program wrote stays", { skip }, async () => {
  const dcf = fixture("dcf/drive-402-node8.dcf");
  await serving({ "node8.dcf": dcf }, ["node8.dcf"], async ({ page, folder, stop }) => {
    await isShown(page, "node8.dcf");
    await setDefault(page, "1017", "1234");
    const other = Buffer.concat([dcf, Buffer.from("; by hand\r\n")]);
    writeFileSync(join(folder, "node8.dcf"), other);
    await page.waitForSelector(".notice.error:has-text('has changes here')");
    await save(page);
    await page.waitForSelector(".notice.error:has-text('so it was not saved')");
    assert.ok(readFileSync(join(folder, "node8.dcf")).equals(other));
    await isShown(page, "•");
    writeFileSync(join(folder, "node8.dcf"), dcf);
    await save(page);
    await page.waitForSelector(".notice.note:has-text('node8.dcf is saved')");
    assert.equal(changedLines(dcf, readFileSync(join(folder, "node8.dcf"))).length, 1);
    await stop();
    await setDefault(page, "1017", "1235");
    await save(page);
    await page.waitForSelector(".notice.error:has-text('objdict open does not answer')");
  });
});

test("a file that another program changes is shown anew, or asked about", { skip }, async () => {
  const drive = fixture("eds/drive-402.eds");
  await serving({ "drive.eds": drive }, ["drive.eds"], async ({ page, folder }) => {
    const text = drive.toString("latin1");
    const write = (comment) => writeFileSync(join(folder, "drive.eds"), `; ${comment}\r\n${text}`, "latin1");
    const field = page.getByLabel("Default value").first();
    await isShown(page, "drive.eds");
    await setDefault(page, "1017", "1234");
    await save(page);
    await page.waitForSelector(".notice.note:has-text('drive.eds is saved')");
    // what was saved here is no change of another program
    await page.waitForTimeout(2500);
    await page.waitForSelector(".notice.note:has-text('drive.eds is saved')");
    write("first");
    await page.waitForSelector(".notice.note:has-text('drive.eds was changed by another program')");
    assert.equal(await page.locator(".document").count(), 1);
    await page.waitForSelector(".form h2:has-text('1017h')");
    await isNot(field, "1234");
    await setDefault(page, "1017", "1235");
    write("second");
    const asked = page.locator(".notice.error", { hasText: "has changes here that are not saved" });
    await asked.getByRole("button", { name: "Compare" }).click();
    await page.waitForSelector(".compare td:has-text('1235')");
    await page.getByRole("button", { name: "Close disk/drive.eds" }).click();
    await isShown(page, "drive.eds");
    write("third");
    await asked.getByRole("button", { name: "Replace it on the disk" }).click();
    await page.locator("dialog[open] button[type=submit]").click();
    await page.waitForSelector(".notice.note:has-text('drive.eds is saved')");
    const saved = readFileSync(join(folder, "drive.eds"), "latin1");
    assert.ok(saved.startsWith("; first\r\n") && saved.includes("DefaultValue=1235"));
    await setDefault(page, "1017", "1236");
    write("fourth");
    await asked.getByRole("button", { name: "Load it from the disk" }).click();
    await page.waitForFunction(() => !document.querySelector(".document.current").textContent.includes("•"));
    await isNot(field, "1236");
  });
});

test("changes survive a reload beside what another program did", { skip }, async () => {
  const drive = fixture("eds/drive-402.eds");
  await serving({ "drive.eds": drive }, ["drive.eds"], async ({ page, folder }) => {
    await isShown(page, "drive.eds");
    await setDefault(page, "1017", "1234");
    await kept(page, 1);
    const other = Buffer.concat([drive, Buffer.from("; by hand\r\n")]);
    page.on("dialog", (dialog) => dialog.accept());
    await page.reload();
    await page.waitForSelector(".notice.note:has-text('Opened again with changes that were not saved: drive.eds')");
    assert.equal(await page.locator(".document").count(), 1);
    writeFileSync(join(folder, "drive.eds"), other);
    await page.waitForSelector(".notice.error:has-text('has changes here')");
    await save(page);
    await page.waitForSelector(".notice.error:has-text('so it was not saved')");
    assert.ok(readFileSync(join(folder, "drive.eds")).equals(other));
    writeFileSync(join(folder, "drive.eds"), drive);
    await save(page);
    await page.waitForSelector(".notice.note:has-text('drive.eds is saved')");
    assert.equal(changedLines(drive, readFileSync(join(folder, "drive.eds"))).length, 1);
  });
});

test("a folder is a list, and a network has its descriptions", { skip }, async () => {
  const network = "[bus]\nbit-rate = 250\n\n[node.left]\nid = 11\nfile = \"io.eds\"\n";
  const files = { "drive.eds": fixture("eds/drive-402.eds"), "io.eds": fixture("eds/io-401.eds"), "network.toml": network };
  await serving(files, [], async ({ page, folder }) => {
    const names = page.locator("dialog[open] .candidates > li > button .name");
    await names.first().waitFor();
    assert.deepEqual(await names.allTextContents(), ["drive.eds", "io.eds", "network.toml"]);
    assert.deepEqual(await page.locator("dialog[open] .candidates ul .name").allTextContents(), ["io.eds"]);
    await page.getByLabel("Search files").fill("dri");
    // twice in one moment is once
    await names.first().evaluate((name) => (name.click(), name.click()));
    await isShown(page, "drive.eds");
    assert.equal(await page.locator("dialog[open]").count(), 0);
    assert.equal(await page.locator(".document").count(), 1);
    // what is new in the folder is in the list, behind the others
    writeFileSync(join(folder, "another.eds"), fixture("eds/io-401.eds"));
    await page.getByRole("button", { name: "Files …" }).click();
    await page.getByLabel("Search files").fill("");
    await names.filter({ hasText: "another.eds" }).click();
    await isShown(page, "another.eds");
    await setDefault(page, "1017", "1234");
    await save(page);
    await page.waitForSelector(".notice:has-text('another.eds is saved')");
    assert.match(readFileSync(join(folder, "another.eds"), "latin1"), /DefaultValue=1234\s/);
  });
  await serving(files, ["network.toml"], async ({ page }) => {
    await page.waitForSelector(".document:has-text('io.eds')");
    assert.equal(await page.locator(".document:has-text('drive.eds')").count(), 0);
  });
});

test("a file that was dropped on the page is not saved in place", { skip }, () =>
  serving({ "drive.eds": fixture("eds/drive-402.eds") }, ["drive.eds"], async ({ page }) => {
    await isShown(page, "drive.eds");
    await page.getByRole("button", { name: "Close drive.eds" }).click();
    await page.waitForSelector(".welcome:not([hidden])");
    await page.setInputFiles("input[type=file]", [{ name: "drive.eds", mimeType: "text/plain", buffer: fixture("eds/io-401.eds") }]);
    await isShown(page, "drive.eds");
    assert.ok(await page.getByRole("button", { name: "Save", exact: true }).isDisabled());
  }));
