// The engine in Node: it finds and writes what the command does.

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";
import init, { Workbench } from "../src/wasm/objdict_wasm.js";
import { fixture, fixtures, noCommand, objdict, root } from "./support.mjs";

const wasm = readFileSync(new URL("../src/wasm/objdict_wasm_bg.wasm", import.meta.url));
await init({ module_or_path: wasm });

/** The goal of the size that a browser loads. */
const MAX_COMPRESSED = 1_900_000;

function call(workbench, request, bytes = new Uint8Array()) {
  return JSON.parse(workbench.call(JSON.stringify(request), bytes));
}

// the gate tests an engine that links in seconds, except when it runs everything
test("the engine is small", { skip: process.env.OBJDICT_ENGINE === "quick" }, () => {
  const size = brotliCompressSync(wasm).length;
  console.log(`engine: ${wasm.length} bytes, ${size} compressed`);
  assert.ok(size <= MAX_COMPRESSED, `${size} bytes`);
});

test("a file of 500 KB is opened and checked", () => {
  const [head, ...sections] = fixture("eds/all-types.eds").toString().split(/(?=^\[)/m);
  let text = head + sections.join("");
  for (let index = 0x2100; text.length < 500_000; index++) {
    const name = index.toString(16).toUpperCase();
    text += `\r\n[${name}]\r\nParameterName=Object ${name}\r\nObjectType=0x7\r\nDataType=0x0007\r\nAccessType=rw\r\nDefaultValue=${index}\r\nPDOMapping=0\r\n`;
  }
  const bytes = new TextEncoder().encode(text);
  for (let turn = 0; turn < 3; turn++) {
    const workbench = new Workbench();
    const start = performance.now();
    const { ok } = call(workbench, { do: "open", name: "large.eds" }, bytes);
    call(workbench, { do: "check", document: ok.document });
    console.log(`${bytes.length} bytes opened and checked in ${Math.round(performance.now() - start)} ms`);
    workbench.free();
  }
});

/** Opens files as the page does when they are dropped together; the number of the first one. */
function opened(workbench, names) {
  const answers = names.map((name) => call(workbench, { do: "open", name }, readFileSync(join(root, name))));
  return answers[0];
}

test("the findings are those of the command", { skip: noCommand }, () => {
  let compared = 0;
  for (const { path, name, bytes } of fixtures()) {
    const workbench = new Workbench();
    const answer = call(workbench, { do: "open", name }, bytes);
    const printed = objdict("check", "--no-config", "--format", "json", name);
    if (answer.error) {
      assert.ok(printed.status === 2 || /\.toml$/.test(path), `${name}: ${answer.error.message}`);
    } else if (answer.ok.state.kind === "device") {
      const expected = JSON.parse(printed.stdout.toString());
      // the page reads no files beside the one that is open, and a variant of a `device.toml` repeats what is found in the device
      const origin = /^LastEDS=(.+?)\s*$/im.exec(answer.ok.state.text)?.[1];
      const isAlone = !origin || !existsSync(join(dirname(path), origin));
      if (isAlone && !(answer.ok.state.devices > 1 && /\.toml$/.test(path))) {
        const found = call(workbench, { do: "check", document: 0, fixes: true, places: true }).ok;
        assert.deepEqual(found.findings, expected.findings, name);
        assert.deepEqual(found.summary, expected.summary, name);
        compared++;
      }
    }
    workbench.free();
  }
  console.log(`${compared} files have the same findings`);
  assert.ok(compared > 100);
});

test("so are those of the files in a folder", { skip: noCommand || (!process.env.OBJDICT_CORPUS && "only with OBJDICT_CORPUS=FOLDER") }, () => {
  const folder = process.env.OBJDICT_CORPUS;
  const files = readdirSync(folder, { recursive: true }).map(String).filter((name) => /\.(eds|dcf|xdd|xdc|nxdd|nxdc)$/i.test(name));
  let compared = 0;
  for (const name of files) {
    const workbench = new Workbench();
    const path = join(folder, name);
    const answer = call(workbench, { do: "open", name: path }, readFileSync(path));
    const printed = objdict("check", "--no-config", "--format", "json", path);
    if (answer.error) {
      assert.equal(printed.status, 2, `${name}: ${answer.error.message}`);
    } else {
      const origin = /^LastEDS=(.+?)\s*$/im.exec(answer.ok.state.text)?.[1];
      if (origin && existsSync(join(dirname(path), origin))) continue;
      const found = call(workbench, { do: "check", document: 0, fixes: true, places: true }).ok;
      const expected = JSON.parse(printed.stdout.toString());
      assert.deepEqual({ ...found, version: 1 }, expected, name);
      compared++;
    }
    workbench.free();
  }
  console.log(`${compared} of ${files.length} files have the same findings`);
  assert.ok(compared > 0);
});

test("what other tools would say is what the command says", { skip: noCommand }, () => {
  const name = "fixtures/eds/compact.eds";
  const workbench = new Workbench();
  opened(workbench, [name]);
  const tools = call(workbench, { do: "tools" }).ok;
  const printed = objdict("check", "--no-config", "--format", "json", "--compat", tools.join(","), name);
  const expected = JSON.parse(printed.stdout.toString());
  assert.ok(expected.findings.some((finding) => finding.rule.startsWith("portability/")));
  assert.deepEqual(call(workbench, { do: "check", document: 0, fixes: true, places: true, tools }).ok.findings, expected.findings);
  workbench.free();
});

/** A network and the descriptions of its nodes. */
const NETWORKS = [
  ["fixtures/network/line.toml", "fixtures/network/island.eds", "fixtures/network/servo.eds"],
  ["fixtures/network/cell.yml", "fixtures/network/servo.eds", "fixtures/network/counter.eds"],
  ["fixtures/nodelist/line.cpj", ...["manager-302-node1", "encoder-406-node3", "drive-402-node8", "io-401-node5", "coupler-modular-node10"].map((name) => `fixtures/dcf/${name}.dcf`)],
];

test("a network is what the command says, and its files are those that the command builds", { skip: noCommand }, () => {
  const folder = mkdtempSync(join(tmpdir(), "objdict-web-"));
  try {
    for (const names of NETWORKS) {
      const workbench = new Workbench();
      opened(workbench, names);
      const view = call(workbench, { do: "network", document: 0 }).ok;
      const checked = JSON.parse(objdict("network", "check", "--no-config", "--format", "json", names[0]).stdout.toString());
      assert.deepEqual(view.report.findings, checked.findings, names[0]);
      const { version, file, ...shown } = JSON.parse(objdict("network", "show", "--format", "json", names[0]).stdout.toString());
      assert.ok(version && file);
      assert.deepEqual(view.overview, shown, names[0]);
      assert.equal(`${view.picture}\n`, objdict("network", "graph", "--format", "svg", names[0]).stdout.toString());
      const answer = call(workbench, { do: "build", document: 0 });
      if (checked.summary.errors > 0) {
        assert.match(answer.error.message, /nothing is built/);
        continue;
      }
      let compared = 0;
      answer.ok.files.forEach((name, number) => {
        const bytes = workbench.take(number);
        const [target, ...rest] = name.split("/");
        if (rest.length === 0) return;
        const output = join(folder, basename(names[0]), target);
        if (!existsSync(output)) {
          const { status, stderr } = objdict("network", "build", "--no-config", "--target", target, names[0], "-o", output);
          assert.equal(status, 0, `${name}: ${stderr}`);
        }
        assert.ok(readFileSync(join(output, rest.join("/"))).equals(bytes), `${names[0]}: ${name}`);
        compared++;
      });
      assert.ok(compared > 5, names[0]);
      workbench.free();
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("the frames of a log are those that the command prints", { skip: noCommand }, () => {
  for (const [log, ...others] of [
    ["fixtures/logs/cell.log", ...NETWORKS[1]],
    ["fixtures/logs/drive.asc", "fixtures/eds/drive-402.eds"],
    ["fixtures/logs/short.pcap"],
    ["fixtures/logs/incidents.log"],
  ]) {
    const workbench = new Workbench();
    opened(workbench, [log, ...others]);
    const summary = call(workbench, { do: "decode", document: 0, with: others.length > 0 ? [1] : [] }).ok;
    const { rows } = call(workbench, { do: "frames", document: 0, count: 1e6 }).ok;
    const decoded = (...args) => objdict("decode", log, ...(others.length > 0 ? ["--with", others[0]] : []), ...args).stdout.toString();
    const printed = decoded("--format", "json").trimEnd().split("\n").map((line) => JSON.parse(line));
    assert.equal(rows.length, printed.length);
    assert.deepEqual(rows.map((row) => [row.kind, row.node ?? undefined, row.cells[3].replace("remote", "").replaceAll(" ", ""), row.cells[4]]), printed.map((row) => [row.kind, row.node, row.data, row.text]), log);
    const sums = JSON.parse(decoded("--summary", "--format", "json"));
    assert.deepEqual([summary.buses, summary.incidents, summary.verdict], [sums.buses, sums.incidents, sums.verdict]);
    assert.deepEqual(summary.report.findings, JSON.parse(decoded("--check", "--format", "json")).findings);
    workbench.free();
  }
});

test("what is written is what the command writes", { skip: noCommand }, () => {
  const folder = mkdtempSync(join(tmpdir(), "objdict-web-"));
  try {
    for (const name of ["eds/drive-402.eds", "eds/io-401.eds", "xdd/io-401.xdd", "dcf/drive-402-node8.dcf"]) {
      const path = `fixtures/${name}`;
      const workbench = new Workbench();
      call(workbench, { do: "open", name: basename(name) }, fixture(name));
      const stem = basename(name).replace(/\.\w+$/, "");
      const same = (request, made, ...command) => {
        const { status, stderr } = objdict(...command);
        assert.equal(status, 0, `${command.join(" ")}: ${stderr}`);
        const answer = call(workbench, { document: 0, ...request });
        assert.ok(answer.ok, `${command.join(" ")}: ${JSON.stringify(answer)}`);
        answer.ok.files.forEach((file, number) => {
          const expected = readFileSync(made(file));
          assert.ok(expected.equals(workbench.take(number)), `${command.join(" ")}: ${file}`);
        });
      };
      for (const ending of ["eds", "dcf", "xdd", "xdc", "toml"]) {
        const output = join(folder, `${stem}-copy.${ending}`);
        const node = /dc[fx]|xdc/.test(ending) ? ["--node-id", "8", "--bit-rate", "250"] : [];
        const of = node.length > 0 ? { node_id: 8, bit_rate: 250 } : {};
        same({ do: "save", name: basename(output), ...of }, () => output, "convert", path, "-o", output, ...node);
      }
      for (const target of ["c", "rust", "canopennode"]) {
        const output = join(folder, `${stem}-${target}`);
        same({ do: "generate", target }, (file) => join(output, file), "generate", "--no-config", "--target", target, path, "-o", output);
      }
      for (const form of ["html", "md", "csv"]) {
        const output = join(folder, `${stem}.${form}`);
        same({ do: "docs", form }, () => output, "docs", "--no-config", path, "-o", output);
      }
      const dbc = join(folder, `${stem}.dbc`);
      same({ do: "dbc", node_id: 8 }, () => dbc, "convert", path, "-o", dbc, "--node-id", "8");
      const concise = join(folder, `${stem}.cdcf`);
      same({ do: "concise", node_id: 8, all: true }, () => concise, "convert", path, "-o", concise, "--node-id", "8", "--all");
      workbench.free();
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
