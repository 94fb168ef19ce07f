// The page in Chromium: from a host and as one file from disk.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import axe from "axe-core";
import { browser, changedLines, checked, download, open, saveAs, server, skip, toolbar, view, withPage } from "./page.mjs";
import { dist, fixture, host, large, noCommand, objdict, root } from "./support.mjs";

const single = join(dist, "objdict-workbench.html");
const NETWORK = ["line.toml", "island.eds", "servo.eds"].map((name) => [name, fixture(`network/${name}`)]);

const DRIVE = "drive-402.eds";

test("an edited default is one changed line, and undo takes it back", { skip }, () =>
  withPage(async (page) => {
    const original = fixture(`eds/${DRIVE}`);
    await open(page, [DRIVE, original]);
    await page.getByLabel("Search objects", { exact: true }).fill("1017");
    await page.getByRole("option", { name: /1017h/ }).click();
    const field = page.getByLabel("Default value").first();
    await field.fill("1234");
    await field.press("Enter");
    await page.waitForSelector(".document.current:has-text('•')");
    const saved = await saveAs(page);
    assert.equal(saved.name, DRIVE);
    assert.equal(changedLines(original, saved.bytes).length, 1);
    await page.getByRole("button", { name: "Changes", exact: true }).click();
    await page.waitForSelector(".diff .cm-changedLine");
    assert.equal(await page.locator(".diff .cm-changedLine").count(), 1);
    await page.getByRole("button", { name: "Undo" }).click();
    await page.waitForSelector(".diff .nothing");
    assert.ok((await saveAs(page)).bytes.equals(original));
  }));

test("a form stays where it was scrolled to, and another one begins at its top", { skip }, () =>
  withPage(async (page) => {
    await page.setViewportSize({ width: 1280, height: 420 });
    await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
    const choose = async (index) => {
      await page.getByLabel("Search objects", { exact: true }).fill(index);
      await page.getByRole("option", { name: new RegExp(`${index}h`) }).click();
      await page.waitForSelector(`.form h2:has-text("${index}h")`);
    };
    const top = () => page.locator(".form").evaluate((form) => form.scrollTop);
    await choose("1A00");
    await page.locator(".form").evaluate((form) => (form.scrollTop = 90));
    const field = page.getByLabel("Name, sub-index 01");
    await field.evaluate((input) => {
      input.value = "Another name";
      input.dispatchEvent(new Event("change", { bubbles: true }));
    });
    await page.waitForSelector(".document.current:has-text('•')");
    await checked(page);
    assert.equal(await top(), 90);
    await choose("1018");
    assert.equal(await top(), 0);
  }));

test("what is typed in the text keeps line ends and encoding", { skip }, () =>
  withPage(async (page) => {
    const original = Buffer.from(fixture(`eds/${DRIVE}`).toString("latin1").replaceAll("\r\n", "\n").replaceAll("\n", "\r\n").replace("ParameterName=Device type", "ParameterName=Ger\xe4t"), "latin1");
    await open(page, [DRIVE, original]);
    await page.getByRole("button", { name: "Text", exact: true }).click();
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("; by hand\n");
    const expected = `; by hand\r\n${original.toString("latin1")}`;
    // the engine gets what was typed after a pause, and may not have all of it yet
    for (let turn = 0, now = ""; now !== expected; turn++) {
      assert.ok(turn < 20, now.slice(0, 40));
      await page.waitForTimeout(300);
      now = (await saveAs(page)).bytes.toString("latin1");
    }
  }));

/** How long a file of so many bytes takes from the drop to its objects and findings, in milliseconds. */
async function timeToOpen(size) {
  let time;
  await withPage(async (page) => {
    // a user needs a second to choose a file
    await page.waitForTimeout(1500);
    time = await page.evaluate(async (text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], "large.eds"));
      const start = performance.now();
      dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
      while (!(document.querySelector(".row") && document.querySelector(".finding"))) await new Promise((resolve) => requestAnimationFrame(resolve));
      return performance.now() - start;
    }, large(size));
  });
  return time;
}

test("opening takes time by the size of the file", { skip }, async () => {
  const [small, tenfold] = [[], []];
  for (let turn = 0; turn < 3; turn++) {
    small.push(await timeToOpen(50_000));
    tenfold.push(await timeToOpen(500_000));
  }
  console.log(`dropped, checked and drawn: 50 KB in ${small.map(Math.round).join(", ")} ms, 500 KB in ${tenfold.map(Math.round).join(", ")} ms`);
  // what is quadratic takes a hundred times as long
  assert.ok(Math.min(...tenfold) < 25 * Math.min(...small));
});

test("nothing is typed into an object that was left", { skip }, () =>
  withPage(async (page) => {
    const original = fixture(`eds/${DRIVE}`);
    await open(page, [DRIVE, original]);
    await view(page, "Object");
    await page.waitForSelector(".form h2:has-text('1000h')");
    // an engine that takes its time for the next form
    await page.evaluate(() => {
      const send = Worker.prototype.postMessage;
      const held = [];
      Worker.prototype.postMessage = function (message, ...more) {
        if (message.request?.do === "form") held.push(() => send.call(this, message, ...more));
        else send.call(this, message, ...more);
      };
      window.release = () => {
        Worker.prototype.postMessage = send;
        held.forEach((message) => message());
      };
    });
    await page.getByLabel("Search objects", { exact: true }).fill("1017");
    await page.getByRole("option", { name: /1017h/ }).click();
    await page.waitForFunction(() => document.querySelector("[role=option][aria-selected=true] .address")?.textContent === "1017h");
    assert.equal(await page.locator(".form h2 .address").textContent(), "1000h");
    assert.equal(await page.locator(".form :is(input, button, select):enabled").count(), 0);
    await page.evaluate(() => window.release());
    await page.getByLabel("Default value").first().fill("1234");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".document.current:has-text('•')");
    const changed = changedLines(original, (await saveAs(page)).bytes);
    const section = original.toString("latin1").split("\n").slice(0, changed[0]).findLast((line) => line.startsWith("["));
    assert.deepEqual([changed.length, section.trim()], [1, "[1017]"]);
  }));

test("a check that fails is said to have failed", { skip }, () =>
  withPage(async (page) => {
    await page.evaluate(() => {
      const send = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (message, ...more) {
        return send.call(this, message.request?.do === "check" ? { ...message, request: { do: "no such request" } } : message, ...more);
      };
    });
    await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
    await page.waitForSelector(".summary:has-text('The check failed')");
    await page.locator(".row").first().waitFor();
    await page.getByRole("alert").first().waitFor();
  }));

test("what is open survives an engine that fails", { skip }, () =>
  withPage(async (page) => {
    const original = fixture("torture/02_latin1.eds");
    await open(page, ["latin1.eds", original]);
    await checked(page);
    await page.evaluate(() => {
      const send = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (message, ...more) {
        Worker.prototype.postMessage = send;
        // a request that contains itself is no JSON
        const request = {};
        request.request = request;
        return send.call(this, { ...message, request }, ...more);
      };
    });
    await page.locator(".row").nth(1).click();
    await page.getByRole("alert").filter({ hasText: "was started again" }).waitFor();
    await checked(page);
    assert.deepEqual((await saveAs(page)).bytes, original);
  }));

test("a fix is one click", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["encoder-406.eds", fixture("errata/a9-encoder-406.eds")]);
    await checked(page);
    const before = await page.locator(".finding").count();
    const fix = page.locator("button.fix").first();
    await fix.click();
    await page.waitForFunction((before) => document.querySelectorAll(".finding").length < before, before);
  }));

test("a conversion is that of the command", { skip: skip || noCommand }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
    const saved = await saveAs(page, "xdd");
    // the name of the file is in it
    const folder = mkdtempSync(join(tmpdir(), "objdict-page-"));
    const { status } = objdict("convert", `fixtures/eds/${DRIVE}`, "-o", join(folder, saved.name));
    const expected = readFileSync(join(folder, saved.name));
    rmSync(folder, { recursive: true });
    assert.equal(status, 0);
    assert.ok(saved.bytes.equals(expected));
    const dcf = await saveAs(page, "dcf", { "#save-node-id": "8", "#save-bit-rate": "250" });
    assert.match(dcf.bytes.toString(), /NodeID=8/);
  }));

const mapped = (page) => page.locator(".pdo .mapped .address").allTextContents();

test("a PDO is made by keyboard and by mouse", { skip }, () =>
  withPage(async (page) => {
    await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
    await page.getByRole("option", { name: /^TPDO 2\b/ }).click();
    await page.waitForSelector(".pdo .mapped");
    const start = await mapped(page);
    await page.locator(".pdo .mapped").first().focus();
    for (let left = start.length; left > 0; left--) {
      await page.keyboard.press("Delete");
      await page.waitForFunction((left) => document.querySelectorAll(".pdo .mapped").length === left, left - 1);
      if (left > 1) await page.locator(".pdo .mapped").first().focus();
    }
    await page.getByLabel("Search objects that can be mapped").fill("6041");
    await page.locator(".pdo .mappable", { hasText: "6041h:00" }).focus();
    await page.keyboard.press("Enter");
    await page.waitForSelector(".pdo .mapped");
    await page.getByLabel("Search objects that can be mapped").fill("6064");
    await checked(page);
    await page.locator(".pdo .mappable", { hasText: "6064h:00" }).dragTo(page.locator(".pdo .bytes"), { targetPosition: { x: 200, y: 40 } });
    await page.waitForFunction(() => document.querySelectorAll(".pdo .mapped").length === 2);
    assert.deepEqual(await mapped(page), ["6041h:00", "6064h:00"]);
    await page.locator(".pdo .mapped").first().focus();
    await page.keyboard.press("Alt+ArrowRight");
    await page.waitForFunction(() => document.querySelector(".pdo .mapped .address").textContent === "6064h:00");
    assert.match(await page.locator(".pdo [role=status]").textContent(), /16 of 64 bits left/);
    const text = (await saveAs(page)).bytes.toString();
    const section = (name) => new RegExp(`\\[${name}\\][^[]*`, "i").exec(text)[0];
    assert.match(section("1A01sub0"), /DefaultValue=2\s/);
    assert.match(section("1A01sub1"), /DefaultValue=0x60640020/);
    assert.match(section("1A01sub2"), /DefaultValue=0x60410010/);
  }));

/** The entries of a ZIP without compression, by name. */
function unzipped(bytes) {
  const files = new Map();
  for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50; ) {
    const [size, path] = [bytes.readUInt32LE(at + 18), bytes.readUInt16LE(at + 26)];
    const name = bytes.toString("utf8", at + 30, at + 30 + path);
    files.set(name, bytes.subarray(at + 30 + path, at + 30 + path + size));
    at += 30 + path + size;
  }
  return files;
}

test("a network gets a link by mouse and by keyboard, and is built", { skip }, () =>
  withPage(async (page) => {
    const original = NETWORK[0][1].toString();
    await open(page, ...NETWORK);
    await page.waitForSelector(".network .load:has-text('on average')");
    assert.match(await page.locator(".network .load").textContent(), /4 nodes · 250 kbit\/s · load \d/);
    assert.equal(await page.locator(".links li").count(), 4);
    await page.getByLabel("Node that sends", { exact: true }).selectOption("left");
    await page.getByLabel("Node that receives", { exact: true }).selectOption("right");
    await page.getByLabel("Search entries of the node that sends").fill("6000h:06");
    await page.getByLabel("Search entries of the node that receives").fill("6200h:02");
    await page.locator(".tpdo .mappable").dragTo(page.locator(".rpdo .mappable"));
    await page.waitForFunction(() => document.querySelectorAll(".links li").length === 5);
    await page.getByLabel("Search entries of the node that sends").fill("6000h:07");
    await page.getByLabel("Search entries of the node that receives").fill("6200h:03");
    await page.locator(".tpdo .mappable").focus();
    await page.keyboard.press("Enter");
    await page.locator(".rpdo .mappable").focus();
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.querySelectorAll(".links li").length === 6);
    const saved = await saveAs(page);
    assert.equal(saved.name, "line.toml");
    const link = (from, to) => `\n[[link]]\nfrom = "${from}"\nto = "${to}"\n`;
    assert.equal(saved.bytes.toString(), original + link("left.6000:6", "right.6200:2") + link("left.6000:7", "right.6200:3"));
    await page.getByRole("button", { name: "Remove the link of left.6000:7" }).click();
    await page.waitForFunction(() => document.querySelectorAll(".links li").length === 5);
    const built = await download(page, () => page.getByRole("button", { name: "Build and download" }).click());
    const files = unzipped(built.bytes);
    assert.equal(built.name, "line.zip");
    assert.match(files.get("dcf/left.dcf").toString(), /NodeID=11/);
    assert.ok(files.has("lely/master.dcf") && files.has("concise/right.cdcf"), [...files.keys()].join());
    for (let step = 0; step < 3; step++) await page.getByRole("button", { name: "Undo" }).click();
    assert.equal((await saveAs(page)).bytes.toString(), original);
  }));

test("descriptions become a network", { skip }, () =>
  withPage(async (page) => {
    await open(page, ...NETWORK.slice(1));
    await page.getByRole("button", { name: "Network of these files" }).click();
    await page.waitForSelector(".document.current:has-text('network.toml')");
    await page.waitForSelector(".network .picture img");
    assert.match(await page.locator(".network .load").textContent(), /2 nodes/);
  }));

test("a log is read with the open network, and pasted frames with a description", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["cell.log", fixture("logs/cell.log")], ...["cell.yml", "servo.eds", "counter.eds"].map((name) => [name, fixture(`network/${name}`)]));
    await page.waitForSelector(".frame");
    await page.getByLabel("Kind of frames").selectOption("heartbeat");
    await page.waitForFunction(() => [...document.querySelectorAll(".frame")].every((frame) => frame.classList.contains("heartbeat")));
    const total = Number.parseInt(await page.locator(".log [role=status]").textContent());
    assert.ok(total > 0);
    assert.ok((await page.locator(".frame").count()) <= total);
    await page.getByLabel("Kind of frames").selectOption("");
    await page.getByLabel("Search in frames").fill("no such text");
    await page.waitForFunction(() => document.querySelectorAll(".frame").length === 0);
    await page.getByRole("button", { name: "Paste …" }).click();
    await page.fill("#paste-text", "(1.0) can0 708#05\n(1.1) can0 188#3702\n");
    await page.locator("dialog[open] button[type=submit]").click();
    await page.waitForSelector(".document.current:has-text('pasted.log')");
    await open(page, ["drive-402-node8.dcf", fixture("dcf/drive-402-node8.dcf")]);
    await page.getByRole("button", { name: /^pasted\.log/ }).click();
    await page.locator(".others").getByLabel("cell.yml").uncheck();
    await page.locator(".others").getByLabel("drive-402-node8.dcf").check();
    await page.waitForSelector(".frame:has-text('Statusword')");
  }));

test("a log begins with what went wrong, and an incident leads to its frames", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["incidents.log", fixture("logs/incidents.log")]);
    const incidents = page.getByRole("region", { name: "Incidents" });
    assert.equal(await incidents.getByRole("heading", { level: 3 }).textContent(), "Needs attention: 3 unresolved, 2 recovered");
    assert.equal(await incidents.locator("summary").count(), 5);
    await incidents.getByText("node 2 is in a fault").first().click();
    await incidents.getByText("What to check").locator("visible=true").waitFor();
    await incidents.getByRole("button", { name: "1760500003.422000" }).click();
    await page.waitForSelector(".frame.marked:has-text('182'):has-text('50 02')");
  }));

test("a coupler is configured with modules", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["coupler-modular.eds", fixture("eds/coupler-modular.eds")]);
    await page.getByRole("button", { name: "Configure …" }).click();
    await page.waitForSelector("dialog[open] option", { state: "attached" });
    await page.fill("#configure-node-id", "10");
    await page.getByRole("button", { name: "Plug in" }).click();
    await page.getByRole("button", { name: "Plug in" }).click();
    await page.locator("dialog[open] button[type=submit]").click();
    await page.waitForSelector(".document.current:has-text('coupler-modular-node.dcf')");
    const text = (await saveAs(page)).bytes.toString();
    assert.match(text, /NodeID=(10|0x0A)\s/);
    assert.match(text, /\[ConnectedModules\]\s+NrOfEntries=2/);
  }));

test("other tools are asked", { skip }, () =>
  withPage(async (page) => {
    await open(page, ["compact.eds", fixture("eds/compact.eds")]);
    await page.getByText("Other tools").click();
    await page.getByLabel("canopeneditor").check();
    await page.waitForSelector(".finding code:has-text('portability/')");
    const expanded = await saveAs(page, "eds", {}, { "#save-storage": "expanded" });
    assert.doesNotMatch(expanded.bytes.toString(), /CompactSubObj=[1-9]/);
  }));

test("a PDO without a COB-ID is shown, and a log is not offered for comparison", { skip }, () =>
  withPage(async (page) => {
    const drive = fixture(`eds/${DRIVE}`).toString("latin1");
    const without = drive.replace(/(\[1800sub1\][^[]*?)DefaultValue=[^\r\n]*\r?\n/i, "$1");
    assert.ok(without.length < drive.length);
    await open(page, ["bus.log", "(1.0) can0 000#0100\n"], [DRIVE, without]);
    // the log is shown when all files are open
    await page.waitForSelector(".document.current:has-text('bus.log')");
    await page.locator(".document button", { hasText: DRIVE }).click();
    await page.getByRole("option", { name: /^TPDO 1 / }).click();
    await page.waitForSelector(".pdo h2:has-text('TPDO 1')");
    assert.equal(await page.getByLabel("COB-ID", { exact: true }).inputValue(), "");
    await page.getByRole("button", { name: "Compare", exact: true }).click();
    await page.waitForSelector(".nothing:has-text('Open a second file')");
  }));

test("two files are compared", { skip }, () =>
  withPage(async (page) => {
    const old = fixture(`eds/${DRIVE}`).toString("latin1");
    const now = old.replace(/(\[6041\][^[]*?DataType=)0x0006/i, "$10x0007");
    assert.notEqual(old, now);
    await open(page, ["old.eds", old], ["new.eds", now]);
    await page.getByRole("button", { name: "Compare", exact: true }).click();
    await page.waitForSelector(".verdict.breaking");
    assert.match(await page.locator(".compare table").textContent(), /6041h/);
  }));

test("a new device is made, and gets an object of its profile", { skip }, () =>
  withPage(async (page) => {
    await page.getByRole("button", { name: "New …" }).click();
    await page.waitForSelector("#new-profile option", { state: "attached" });
    await page.selectOption("#new-profile", "401");
    await page.getByLabel("Number of one-bit digital inputs").fill("16");
    for (const [label, value] of [["Vendor", "Example"], ["Product", "Inputs"]]) await page.getByLabel(label, { exact: true }).fill(value);
    await page.locator("dialog[open] button[type=submit]").click();
    await page.waitForSelector(".document.current:has-text('device.eds')");
    // two bytes of inputs, and how many there are
    assert.match((await saveAs(page)).bytes.toString(), /\[6000\][^[]*SubNumber=(3|0x3)\s/);
    await page.getByRole("button", { name: "Add object …" }).click();
    await page.getByLabel("Search objects of the document").fill("1010");
    await page.locator("dialog[open] .mappable:not(:disabled)").first().click();
    await page.waitForSelector("h2:has-text('1010h')");
  }));

test("a deep link shows the object", { skip }, () =>
  withPage(
    async (page) => {
      await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
      await page.waitForSelector("h2:has-text('6041h')");
      await page.evaluate(() => (location.hash = "#tpdo2"));
      await page.waitForSelector(".pdo h2:has-text('TPDO 2')");
    },
    { address: `${server.address}#6041` },
  ));

test("a hostile file does no harm", { skip }, () =>
  withPage(async (page) => {
    const script = "<script>alert(1)</script><img src=x onerror=alert(2)>";
    const text = fixture(`eds/${DRIVE}`).toString("latin1").replaceAll(/ParameterName=.*/g, `ParameterName=${script}`);
    await open(page, ["script.eds", text]);
    for (const name of ["Overview", "Object", "Table", "PDOs", "Device", "Text", "Changes"]) {
      await view(page, name);
      await page.waitForTimeout(200);
    }
    assert.equal(await page.locator("#app script, #app img").count(), 0);
    for (const [name, bytes] of [["random.eds", Buffer.from(Array.from({ length: 4096 }, (_, at) => (at * 7919) % 251))], ["empty.eds", ""], ["large.eds", Buffer.alloc((64 << 20) + 1, "[1000]\n")]]) {
      if (bytes.length > 50e6) {
        // larger than the protocol takes in one message
        await page.evaluate((size) => {
          const transfer = new DataTransfer();
          transfer.items.add(new File([new Uint8Array(size).fill(65)], "large.eds"));
          dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
        }, bytes.length);
      } else {
        await page.setInputFiles("input[type=file]", [{ name, mimeType: "application/octet-stream", buffer: Buffer.from(bytes) }]);
      }
      await page.waitForFunction(() => document.querySelector(".notice.error:not([hidden])") || document.querySelectorAll(".document").length > 1);
      await page.evaluate(() => document.querySelector(".notice button")?.click());
    }
    // and the engine answers as before
    await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
  }));

test("the single file works from disk", { skip }, async () => {
  console.log(`objdict-workbench.html: ${statSync(single).size} bytes`);
  await withPage(
    async (page) => {
      await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
      await checked(page);
      assert.ok((await saveAs(page)).bytes.equals(fixture(`eds/${DRIVE}`)));
    },
    { address: pathToFileURL(single).href },
  );
});

test("from a host, the page opens again without a network", { skip }, async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.address);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.reload();
  await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
  await context.setOffline(true);
  await page.reload();
  await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
  await context.close();
});

/** What axe-core finds to be serious or critical. */
async function barriers(page) {
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => window.axe.run());
  return violations.filter(({ impact }) => impact === "serious" || impact === "critical").map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 200)).join(" | ")}`);
}

/** Opens something of each kind and shows every view. */
async function eachView(page, see) {
  await open(page, [DRIVE, fixture(`eds/${DRIVE}`)], ["broken.eds", fixture("errata/a9-encoder-406.eds")]);
  await checked(page);
  for (const name of ["Overview", "Object", "Table", "PDOs", "Device", "Text", "Changes", "Compare"]) {
    await view(page, name);
    await page.waitForTimeout(200);
    await see(name);
  }
  for (const dialog of ["Paste …", "New …", "Add object …", "Configure …", "Save as …", "Download …"]) {
    await toolbar(page, dialog);
    await page.waitForTimeout(200);
    await see(dialog);
    await page.locator("dialog[open] button", { hasText: "Cancel" }).click();
  }
  await open(page, ...NETWORK);
  await page.waitForSelector(".network .load:has-text('on average')");
  await see("Network");
  await open(page, ["cell.log", fixture("logs/cell.log")]);
  await page.waitForSelector(".frame");
  await see("Log");
}

test("nothing serious is in the way of those who use a screen reader or a keyboard", { skip }, async () => {
  for (const colorScheme of ["light", "dark"]) {
    await withPage(
      async (page) => {
        await page.emulateMedia({ colorScheme });
        assert.deepEqual(await barriers(page), [], "welcome");
        await eachView(page, async (view) => assert.deepEqual(await barriers(page), [], `${view}, ${colorScheme}`));
      },
    );
  }
});

test("no width is too small", { skip }, async () => {
  for (const width of [390, 768, 1280, 2560]) {
    await withPage(
      (page) =>
        eachView(page, async (view) => {
          const beside = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          assert.ok(beside <= 0, `${view}, ${width}: ${beside} px beside the window`);
          if (process.env.OBJDICT_VIEWS) await page.screenshot({ path: join(process.env.OBJDICT_VIEWS, `${width}-${view.replace(/\W/g, "")}.png`) });
        }),
      { size: { width, height: 800 } },
    );
  }
});

test("screenshots", { skip: skip || (!process.env.OBJDICT_SCREENSHOTS && "only with OBJDICT_SCREENSHOTS=FOLDER") }, () =>
  withPage(
    async (page) => {
      const folder = join(root, process.env.OBJDICT_SCREENSHOTS);
      await open(page, ["encoder-406.eds", fixture("errata/a9-encoder-406.eds")]);
      await checked(page);
      await page.locator(".finding.error .where").first().click();
      await page.locator(".form .remark").first().scrollIntoViewIfNeeded();
      await page.screenshot({ path: join(folder, "workbench.png") });
      await open(page, [DRIVE, fixture(`eds/${DRIVE}`)]);
      await page.getByRole("option", { name: /^TPDO 1\b/ }).click();
      await page.waitForSelector(".pdo .mapped");
      await checked(page);
      await page.screenshot({ path: join(folder, "workbench-pdo.png") });
      await open(page, ...NETWORK);
      await page.waitForSelector(".network .load:has-text('on average')");
      await page.screenshot({ path: join(folder, "workbench-network.png") });
    },
    { size: { width: 1280, height: 720 } },
  ));
