// What the tests share: fixtures, the command, a static host, and Chromium.

import { execFileSync, spawnSync } from "node:child_process";
import { appendFileSync, existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { basename, extname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../../", import.meta.url));
export const dist = fileURLToPath(new URL("../dist/", import.meta.url));
export const command = process.env.OBJDICT ?? join(root, "target/debug/objdict");

/** The reason to skip tests, or false; with `CI=true` an error. `OBJDICT_SKIPS` names a file that collects the reasons. */
export function without(isThere, reason) {
  if (isThere) return false;
  if (process.env.CI === "true") throw new Error(reason);
  if (process.env.OBJDICT_SKIPS) appendFileSync(process.env.OBJDICT_SKIPS, `skipped: ${reason} (${basename(process.argv[1])})\n`);
  return reason;
}

export const noCommand = without(existsSync(command), "no command `objdict`: run `cargo build`");

/** What the command prints, whatever it found. */
export function objdict(...args) {
  const result = spawnSync(command, args, { cwd: root, maxBuffer: 1 << 28 });
  if (result.error) throw result.error;
  return { status: result.status, stdout: result.stdout, stderr: result.stderr.toString() };
}

/** The descriptions among the fixtures. */
export function fixtures() {
  const found = [];
  const collect = (folder) => {
    for (const name of readdirSync(folder)) {
      const path = join(folder, name);
      if (statSync(path).isDirectory()) collect(path);
      else if (/\.(eds|dcf|xdd|xdc|nxdd|nxdc|toml)$/i.test(name)) found.push(path);
    }
  };
  collect(join(root, "fixtures"));
  return found.sort().map((path) => ({ path, name: relative(root, path), bytes: readFileSync(path) }));
}

export const fixture = (name) => readFileSync(join(root, "fixtures", name));

/** A device of so many bytes. */
export function large(size) {
  const head = fixture("eds/all-types.eds").toString();
  const object = (index) => `\r\n[${index}]\r\nParameterName=Object ${index}\r\nObjectType=0x7\r\nDataType=0x0007\r\nAccessType=rw\r\nDefaultValue=0x${index}\r\nPDOMapping=0\r\n`;
  let text = head;
  for (let index = 0x2100; text.length < size; index++) text += object(index.toString(16).toUpperCase());
  return text;
}

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

/** A static host of the built folder, below a path. */
export async function host() {
  const server = createServer((request, response) => {
    const path = join(dist, new URL(request.url, "http://host").pathname.replace(/^\/some\/folder\//, "") || "index.html");
    if (!existsSync(path) || !path.startsWith(dist)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "application/octet-stream" }).end(readFileSync(path));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/some/folder/`, close: () => server.close() };
}

export function chromium() {
  const path = process.env.OBJDICT_CHROMIUM ?? "/usr/bin/chromium";
  if (!existsSync(path)) return undefined;
  execFileSync(path, ["--version"], { stdio: "ignore" });
  return path;
}
