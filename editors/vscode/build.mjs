// Bundles the extension, and what has no editor in it for the tests.
import { build } from "esbuild";

const options = { bundle: true, platform: "node", target: "node20", minify: true, logLevel: "warning" };
await build({ ...options, entryPoints: ["src/extension.ts"], outfile: "dist/extension.js", format: "cjs", external: ["vscode"] });
for (const name of ["program", "description"])
  await build({ ...options, entryPoints: [`src/${name}.ts`], outfile: `dist/${name}.mjs`, format: "esm" });
