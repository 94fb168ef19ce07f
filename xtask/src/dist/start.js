#!/usr/bin/env node
// Starts the program of the package for this system, which npm installs beside this one.
"use strict";

const { spawnSync } = require("node:child_process");

const name = `canopen-objdict-${process.platform}-${process.arch}`;
const file = process.platform === "win32" ? "objdict.exe" : "objdict";
let program;
try {
  program = require.resolve(`${name}/${file}`);
} catch {
  console.error(`error: the package \`${name}\` is not installed: install with optional dependencies, or build objdict from its sources`);
  process.exit(2);
}
const { status, error } = spawnSync(program, process.argv.slice(2), { stdio: "inherit" });
if (error) console.error(`error: ${error.message}`);
process.exit(status ?? 2);
