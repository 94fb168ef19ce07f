// The .vsix as a user installs it; unpacked with Python, which is not ours.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("..", import.meta.url));

test("the package has what it contributes, and nothing else", () => {
  const folder = mkdtempSync(join(tmpdir(), "objdict-"));
  const vsix = join(folder, "objdict.vsix");
  // `vsce` checks package.json as it packages
  execFileSync("npm", ["run", "--silent", "package", "--", "--out", vsix], { cwd: root, stdio: "pipe" });
  execFileSync("python3", ["-m", "zipfile", "-e", vsix, folder]);
  const extension = join(folder, "extension");
  const manifest = JSON.parse(readFileSync(join(extension, "package.json"), "utf8"));
  const { languages, grammars, snippets } = manifest.contributes;
  const paths = [...grammars, ...snippets].map((part) => part.path).concat(languages.flatMap((language) => language.configuration ?? []));
  for (const path of [manifest.main, manifest.icon, ...paths]) assert.ok(existsSync(join(extension, path)), path);
  const files = readdirSync(extension, { recursive: true }).filter((file) => statSync(join(extension, file)).isFile() && !file.startsWith("server"));
  const expected = ["LICENSE-APACHE", "LICENSE.txt", "changelog.md", "dist/extension.js", "images/icon.png", "language-configuration.json", "package.json", "readme.md", "snippets/eds.json", "syntaxes/eds.tmLanguage.json"];
  assert.deepEqual(files.sort(), expected.sort());
  assert.ok(statSync(join(extension, "dist/extension.js")).size < 600_000);
  // VS Code has no website to look for other pictures
  const pictures = [...readFileSync(join(extension, "readme.md"), "utf8").matchAll(/!\[[^\]]*\]\((.{14})/g)].map(([, start]) => start);
  assert.deepEqual(pictures, ["data:image/png", "data:image/png"]);
  const commands = manifest.contributes.commands.map(({ command }) => command.replace("objdict.", ""));
  const code = readFileSync(join(root, "src/extension.ts"), "utf8");
  const registered = [...code.matchAll(/^ {2}command\("(\w+)"/gm)].map(([, name]) => name);
  assert.deepEqual(registered, commands);
});

test("the lock file names no address of a registry", () => {
  assert.doesNotMatch(readFileSync(join(root, "package-lock.json"), "utf8"), /"resolved"/);
});
