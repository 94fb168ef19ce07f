// The server that the extension starts, over standard input and output, with a broken description.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { objdict } from "./objdict.mjs";

const packed = (message) => {
  const body = JSON.stringify({ jsonrpc: "2.0", ...message });
  return `Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`;
};

test("the server reports findings of a broken text, and its commands are not those of the extension", { timeout: 30_000 }, async () => {
  const server = spawn(objdict, ["lsp"]);
  const uri = "file:///tmp/broken.eds";
  server.stdin.write(packed({ id: 1, method: "initialize", params: { processId: null, rootUri: null, capabilities: {} } }));
  server.stdin.write(packed({ method: "initialized", params: {} }));
  const text = "[1018]\nParameterName=Identity\nObjectType=0x9\nSubNumber=nine\n";
  server.stdin.write(packed({ method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "eds", version: 1, text } } }));
  let all = "";
  for await (const part of server.stdout) {
    all += part;
    if (all.includes("textDocument/publishDiagnostics") && all.includes("nine")) break;
  }
  server.kill();
  assert.match(all, /"uri":"file:\/\/\/tmp\/broken\.eds"/);
  assert.match(all, /`nine`/);
  // the client registers the commands of the server: one that exists already keeps it from starting
  const { commands } = JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8")).contributes;
  const announced = JSON.parse(/"executeCommandProvider":\{"commands":(\[[^\]]*\])/.exec(all)[1]);
  assert.ok(announced.length > 0);
  assert.deepEqual(announced.filter((name) => commands.some(({ command }) => command === name)), []);
});
