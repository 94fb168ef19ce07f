import assert from "node:assert/strict";
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { beside, convert, documentation, drawing, generate, lostCharacters, nodeIdIn, nodeIdProblem, objectAt, pdoOf, sectionLine } from "../dist/description.mjs";
import { findProgram, possibleValues, requireServer } from "../dist/program.mjs";
import { fixture, objdict } from "./objdict.mjs";

const folder = () => mkdtempSync(join(tmpdir(), "objdict-"));
const source = (name) => ({ path: fixture(name), text: readFileSync(fixture(name), "utf8") });
const script = (path, content) => {
  writeFileSync(path, content);
  chmodSync(path, 0o755);
  return path;
};

test("the program is that of the setting, else the bundled one, else the one on PATH", () => {
  const extension = folder();
  const path = folder();
  const places = { setting: "", extension, path: `:${path}` };
  assert.throws(() => findProgram(places), /not on PATH: install it/);
  const onPath = script(join(path, "objdict"), "");
  assert.equal(findProgram(places), onPath);
  mkdirSync(join(extension, "server"));
  const bundled = script(join(extension, "server", "objdict"), "");
  assert.equal(findProgram(places), bundled);
  const setting = script(join(path, "other"), "");
  assert.equal(findProgram({ ...places, setting }), setting);
  assert.throws(() => findProgram({ ...places, setting: join(path, "none") }), /names `.*none`, which is not a program/);
});

test("a program without a language server is refused with its version", async () => {
  await requireServer(objdict);
  const old = script(join(folder(), "objdict"), '#!/bin/sh\n[ "$1" = --version ] && echo objdict 0.0.1 && exit\nexit 2\n');
  await assert.rejects(requireServer(old), /\(objdict 0\.0\.1\) has no language server: install a newer/);
});

test("formats and targets are those of the program", async () => {
  const formats = await possibleValues(objdict, "convert", "to");
  assert.ok(formats.includes("xdd") && formats.includes("cdcf.txt"), formats.join());
  const targets = await possibleValues(objdict, "generate", "target");
  assert.ok(targets.includes("canopennode") && targets.includes("rust"), targets.join());
});

test("the documentation of a network has its nodes, and the policy of its page", async () => {
  const html = await documentation(objdict, fixture("network/islands.toml"));
  assert.match(html, /<title>islands<\/title>[^]*node 12 right/);
  assert.match(html, /Content-Security-Policy" content="default-src 'none'/);
});

test("a conversion to a node has the node-ID that was asked for", async () => {
  const target = join(folder(), "node.dcf");
  await assert.rejects(convert(objdict, source("eds/minimal.eds"), "dcf", target), /missing node-ID/);
  await convert(objdict, source("eds/minimal.eds"), "dcf", target, "0x0B");
  assert.equal(nodeIdIn(readFileSync(target, "utf8")), "11");
  assert.deepEqual(["1", "0x7F", "0", "128", "a", ""].map((text) => nodeIdProblem(text) === undefined), [true, true, false, false, false, false]);
});

test("characters of another encoding are found before they are lost", () => {
  const latin1 = new TextDecoder().decode(Buffer.from("[1000]\r\nParameterName=Ger\xe4t\xfc\r\n", "latin1"));
  assert.deepEqual(lostCharacters(latin1), [[1, 17], [1, 19]]);
  assert.deepEqual(lostCharacters("Ger\u00e4t"), []);
});

test("the object of a line, and its PDO", () => {
  const text = "[DeviceInfo]\r\nA=1\r\n[1A01sub2]\r\nX=1\r\n[1600]\n";
  assert.deepEqual([0, 1, 2, 3, 4].map((line) => objectAt(text, line)), [undefined, undefined, "1A01", "1A01", "1600"]);
  assert.deepEqual(["1800", "1A01", "1600", "15FF", "1018"].map(pdoOf), ["tpdo1", "tpdo2", "rpdo1", "rpdo512", undefined]);
});

test("the drawing of a PDO is that of the documentation, with its policy and links to what it maps", async () => {
  const page = await documentation(objdict, fixture("eds/io-401.eds"));
  const html = drawing(page, pdoOf("1A00"), (section) => `command:to?${section}`);
  assert.match(html, /Content-Security-Policy" content="default-src 'none'/);
  assert.match(html, /<article class="pdo" id="tpdo1">[^]*<svg class="bits"[^]*href="command:to\?6000sub1"/);
  assert.doesNotMatch(html, /id="tpdo2"|<script|<a href="#/);
  assert.equal(html.match(/id="bits"/g).length, 1);
  assert.throws(() => drawing(page, "tpdo9", String), /has no tpdo9/);
});

test("the line of a section, or of its object", () => {
  const text = "[6000]\r\nA=1\r\n [6000SUB1]\n";
  assert.deepEqual(["6000", "6000sub1", "6000sub2", "6001"].map((section) => sectionLine(text, section)), [0, 2, 0, undefined]);
});

test("a conversion writes beside the description, and the program reads it", async () => {
  const path = join(folder(), "a.b.eds");
  const target = beside(path, "xdd");
  assert.match(target, /a\.b\.xdd$/);
  assert.deepEqual(await convert(objdict, { ...source("eds/minimal.eds"), path }, "xdd", target), []);
  assert.match(readFileSync(target, "utf8"), /<ISO15745ProfileContainer/);
  const lost = await convert(objdict, source("xdd/press-402.xdd"), "eds", join(folder(), "press.eds"));
  assert.equal(lost.length, 1);
  assert.match(lost[0], /^0x2020: the object is disabled/);
  await assert.rejects(convert(objdict, { path, text: "no description" }, "xdd", target), /./);
  await assert.rejects(convert(objdict, source("network/islands.toml"), "eds", join(folder(), "a.eds")), /^Error: the text is a network/);
});

test("code is generated into a folder", async () => {
  const to = folder();
  await generate(objdict, source("eds/minimal.eds"), "rust", to);
  const written = readdirSync(to).filter((name) => name.endsWith(".rs"));
  assert.equal(written.length, 1);
  assert.match(readFileSync(join(to, written[0]), "utf8"), /0x1018/i);
});
