// The grammar as the editor runs it: vscode-textmate with the Oniguruma of VS Code.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

const require = createRequire(import.meta.url);
const { Registry, INITIAL, parseRawGrammar } = require("vscode-textmate");
const oniguruma = require("vscode-oniguruma");

const path = new URL("../syntaxes/eds.tmLanguage.json", import.meta.url).pathname;
const onigLib = oniguruma
  .loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")))
  .then(() => ({ createOnigScanner: (p) => new oniguruma.OnigScanner(p), createOnigString: (s) => new oniguruma.OnigString(s) }));
const registry = new Registry({ onigLib, loadGrammar: async () => parseRawGrammar(readFileSync(path, "utf8"), path) });
const grammar = await registry.loadGrammar("source.eds");

/** The words of a line that have a scope besides that of the file. */
const words = (line) =>
  grammar
    .tokenizeLine(line, INITIAL)
    .tokens.filter((token) => token.scopes.length > 1)
    .map((token) => [line.slice(token.startIndex, token.endIndex).trim(), token.scopes.at(-1).replace(/\.eds$/, "")]);

for (const [line, expected] of [
  ["; a comment", [["; a comment", "comment.line.semicolon"]]],
  ["[FileInfo]", [["[", "punctuation.definition.section.begin"], ["FileInfo", "entity.name.section"], ["]", "punctuation.definition.section.end"]]],
  ["[1A00sub1F]", [["[", "punctuation.definition.section.begin"], ["1A00", "entity.name.section.object"], ["sub", "keyword.other.sub"], ["1F", "entity.name.section.sub-index"], ["]", "punctuation.definition.section.end"]]],
  ["[1003Value]", [["[", "punctuation.definition.section.begin"], ["1003", "entity.name.section.object"], ["Value", "keyword.other.list"], ["]", "punctuation.definition.section.end"]]],
  ["DefaultValue=$NODEID+0x180", [["DefaultValue", "variable.other.key"], ["=", "keyword.operator.assignment"], ["$NODEID", "variable.language.node-id"], ["+", "keyword.operator.arithmetic"], ["0x180", "constant.numeric.hex"]]],
  ["LowLimit=-5", [["LowLimit", "variable.other.key"], ["=", "keyword.operator.assignment"], ["-5", "constant.numeric.decimal"]]],
  ["ProductName=Drive 400 0x1", [["ProductName", "variable.other.key"], ["=", "keyword.operator.assignment"], ["Drive 400 0x1", "string.unquoted"]]],
  ["AccessType=ro", [["AccessType", "variable.other.key"], ["=", "keyword.operator.assignment"], ["ro", "constant.language.access"]]],
])
  test(`the words of \`${line}\``, () => assert.deepEqual(words(line), expected));
