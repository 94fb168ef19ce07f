// The page in Chromium, as the tests of its parts use it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before } from "node:test";
import { chromium as browserType } from "playwright-core";
import { chromium, host, without } from "./support.mjs";

const executablePath = chromium();
export const skip = without(executablePath, "no Chromium: install the package `chromium`");
export let browser;
export let server;

before(async () => {
  if (skip) return;
  browser = await browserType.launch({ executablePath, args: ["--no-sandbox", "--disable-dev-shm-usage"] });
  server = await host();
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** A page of a computer that is so many times slower than this one. */
export async function newPage(context, slowness = Number(process.env.OBJDICT_SLOWNESS ?? 1)) {
  const page = await context.newPage();
  if (slowness > 1) await (await context.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate: slowness });
  return page;
}

/** Opens the page; afterwards nothing has been asked of another origin, and nothing has failed. */
export async function withPage(use, { address = server.address, size = { width: 1280, height: 800 } } = {}) {
  const context = await browser.newContext({ viewport: size, acceptDownloads: true });
  const page = await newPage(context);
  const [requests, problems] = [[], []];
  page.on("request", (request) => requests.push(request.url()));
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  page.on("dialog", (dialog) => problems.push(dialog.message()));
  await page.goto(address);
  await use(page);
  const base = new URL("./", address).href;
  const foreign = requests.filter((url) => !url.startsWith(base) && !/^(blob|data):/.test(url));
  assert.deepEqual(foreign, []);
  assert.deepEqual(problems, []);
  await context.close();
}

export async function open(page, ...files) {
  const list = files.map(([name, buffer]) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(buffer) }));
  await page.setInputFiles("input[type=file]", list);
  await page.waitForFunction((names) => {
    const open = [...document.querySelectorAll(".document")].map((tab) => tab.textContent);
    return names.every((name) => open.some((tab) => tab.includes(name))) && document.querySelector(".document.current");
  }, files.map(([name]) => name));
}

/** Clicks a button of the toolbar, which is in a menu in a narrow window. */
export async function toolbar(page, name) {
  const menu = page.getByRole("button", { name: "Menu", exact: true });
  if (await menu.isVisible()) await menu.click();
  await page.locator("header").getByRole("button", { name, exact: true }).click();
}

/** Shows a view of the document. */
export const view = (page, name) => page.locator(".views").getByRole("button", { name, exact: true }).click();

export const checked = (page) => page.waitForSelector('.findings ul[aria-busy="false"]');

/** Of how many pages the browser keeps changes. */
const countKept = (page) =>
  page.evaluate(async () => {
    // opening it would make it
    if (!(await indexedDB.databases()).some(({ name }) => name === "keyval-store")) return 0;
    const result = (request) => new Promise((resolve, reject) => Object.assign(request, { onsuccess: () => resolve(request.result), onerror: reject }));
    const database = await result(indexedDB.open("keyval-store"));
    const found = await result(database.transaction("keyval").objectStore("keyval").count());
    database.close();
    return found;
  });

/** Waits until there are so many. */
export async function kept(page, count) {
  for (let turn = 0; (await countKept(page)) !== count; turn++) {
    assert.ok(turn < 300, "changes are not kept");
    await page.waitForTimeout(100);
  }
}

/** The bytes of a file that the page saves. */
export async function download(page, what) {
  const [file] = await Promise.all([page.waitForEvent("download"), what()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

export async function saveAs(page, format, fill = {}, select = {}) {
  await page.getByRole("button", { name: "Save as …" }).click();
  if (format) await page.selectOption("#save-format", format);
  for (const [id, value] of Object.entries(fill)) await page.fill(id, value);
  for (const [id, value] of Object.entries(select)) await page.selectOption(id, value);
  return download(page, () => page.locator("dialog[open] button[type=submit]").click());
}

/** The lines that differ, as numbers. */
export function changedLines(old, now) {
  const [before, after] = [old, now].map((bytes) => bytes.toString("latin1").split("\n"));
  assert.equal(before.length, after.length);
  return before.map((_, line) => line).filter((line) => before[line] !== after[line]);
}

