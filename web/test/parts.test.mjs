// Functions of the page that need neither engine nor browser.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { EditorState } from "@codemirror/state";
import { createServer } from "vite";

const root = fileURLToPath(new URL("../", import.meta.url));
const vite = await createServer({ root, appType: "custom", logLevel: "error", server: { middlewareMode: true, watch: null } });
after(() => vite.close());

test("columns of edits count characters, not UTF-16 units", async () => {
  const { editsOf } = await vite.ssrLoadModule("/src/text.ts");
  const state = EditorState.create({ doc: "first\n\u{1F600}ab" });
  const at = "first\n\u{1F600}a".length;
  const { changes } = state.update({ changes: { from: at, to: at + 1, insert: "x\ny" } });
  assert.deepEqual(editsOf(changes, state.doc, "\r\n"), [{ line: 2, column: 3, end_line: 2, end_column: 4, text: "x\r\ny" }]);
});

test("objects from 8000h on are mapped by a positive number", async () => {
  const { mappingChanges } = await vite.ssrLoadModule("/src/pdo.ts");
  const pdo = { mapping: 0x1a00, mapped_count: 1, slots: [{ sub: 1, number: 0x60000108 }] };
  const object = { index: 0xa000, sub: 1, bits: 8 };
  assert.deepEqual(mappingChanges(pdo, [object], "DefaultValue"), [{ change: "set", at: "0x1A00sub1 / DefaultValue", value: "0xA0000108" }]);
  pdo.slots[0].number = 0xa0000108;
  assert.deepEqual(mappingChanges(pdo, [object], "DefaultValue"), []);
});
