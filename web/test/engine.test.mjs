// The engine in Node: it finds and writes what the command does.

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { test } from "node:test";
import { brotliCompressSync } from "node:zlib";
import init, { Workbench } from "../src/wasm/objdict_wasm.js";
import { fixture, fixtures, hasCommand, objdict } from "./support.mjs";

const wasm = readFileSync(new URL("../src/wasm/objdict_wasm_bg.wasm", import.meta.url));
await init({ module_or_path: wasm });

/** The goal of the size that a browser loads. */
const MAX_COMPRESSED = 1_600_000;

function call(workbench, request, bytes = new Uint8Array()) {
  return JSON.parse(workbench.call(JSON.stringify(request), bytes));
}

test("the engine is small", () => {
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

test("the findings are those of the command", { skip: !hasCommand && "no command `objdict`" }, () => {
  let compared = 0;
  for (const { path, name, bytes } of fixtures()) {
    const workbench = new Workbench();
    const opened = call(workbench, { do: "open", name }, bytes);
    const printed = objdict("check", "--no-config", "--format", "json", name);
    if (opened.error) {
      assert.ok(printed.status === 2 || /\.toml$/.test(path), `${name}: ${opened.error.message}`);
    } else {
      const expected = JSON.parse(printed.stdout.toString());
      // the page reads no files beside the one that is open, and a variant of a `device.toml` repeats what is found in the device
      const origin = /^LastEDS=(.+?)\s*$/im.exec(opened.ok.state.text)?.[1];
      const isAlone = !origin || !existsSync(join(dirname(path), origin));
      if (isAlone && !(opened.ok.state.devices > 1 && /\.toml$/.test(path))) {
        const found = call(workbench, { do: "check", document: 0, fixes: true }).ok;
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

test("what is written is what the command writes", { skip: !hasCommand && "no command `objdict`" }, () => {
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
