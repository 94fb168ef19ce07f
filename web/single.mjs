// Makes one file of the built folder, which works from disk: the program, the worker and the engine are in it. The worker is started
// from a blob, and the policy names the hash of the program.

import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const folder = new URL("dist/", import.meta.url);
const assets = readdirSync(new URL("assets/", folder));
const asset = (pattern) => {
  const found = assets.filter((name) => pattern.test(name));
  if (found.length !== 1) throw new Error(`${found.length} files are like ${pattern}`);
  return readFileSync(new URL(`assets/${found[0]}`, folder));
};
const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");

// in a script of the page, `</script` and `<!--` would end or change it
const program = asset(/^index-.*\.js$/).toString().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const policy = [
  "default-src 'none'",
  `script-src 'sha256-${createHash("sha256").update(program).digest("base64")}' 'wasm-unsafe-eval' blob:`,
  "worker-src blob:",
  "style-src 'unsafe-inline'",
  "img-src data:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");
const page = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="referrer" content="no-referrer">
<title>objdict workbench</title>
<link rel="icon" href="data:,">
<style>${asset(/\.css$/)}</style>
</head>
<body>
<div id="app"></div>
<script type="application/octet-stream" id="embedded-worker">${packed(asset(/^worker-.*\.js$/))}</script>
<script type="application/octet-stream" id="embedded-engine">${packed(asset(/\.wasm$/))}</script>
<script type="module">${program}</script>
</body>
</html>
`;
writeFileSync(new URL("objdict-workbench.html", folder), page);
