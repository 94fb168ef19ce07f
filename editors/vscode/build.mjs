// Bundles the extension, what has no editor in it for the tests, and the README with its pictures, which VS Code shows without a website.
import { readFileSync, writeFileSync } from "node:fs";

import { build } from "esbuild";

const options = { bundle: true, platform: "node", target: "node20", minify: true, logLevel: "warning" };
await build({ ...options, entryPoints: ["src/extension.ts"], outfile: "dist/extension.js", format: "cjs", external: ["vscode"] });
for (const name of ["program", "description"])
  await build({ ...options, entryPoints: [`src/${name}.ts`], outfile: `dist/${name}.mjs`, format: "esm" });
const picture = (_, path) => `](data:image/png;base64,${readFileSync(path).toString("base64")})`;
writeFileSync("dist/README.md", readFileSync("README.md", "utf8").replace(/\]\(([^)]*\.png)\)/g, picture));
