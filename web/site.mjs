// Puts the built page on a site that mdBook has built: `node site.mjs FOLDER`. Its first page and that of the workbench link to it.

import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const site = process.argv[2];
if (!site) throw new Error("name the folder of the site");
cpSync(new URL("dist/", import.meta.url), join(site, "workbench"), { recursive: true });
for (const [name, start] of [["index.html", ""], ["guides/workbench.html", "../"]]) {
  const page = readFileSync(join(site, name), "utf8");
  const linked = page.replace("</a></h1>\n", `</a></h1>\n<p><a href="${start}workbench/index.html">Open the workbench in this browser</a></p>\n`);
  if (linked === page) throw new Error(`${name} has no title`);
  writeFileSync(join(site, name), linked);
}
