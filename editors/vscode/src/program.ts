// The program `objdict`: where it is, whether it can serve an editor, and how it is run. Nothing here needs the editor.

import { spawn } from "node:child_process";
import { accessSync, constants, statSync } from "node:fs";
import { delimiter, join } from "node:path";

/** Where the program may be; tests pass others than those of this machine. */
export interface Places {
  /** The setting `objdict.server.path`; empty when it is not set. */
  setting: string;
  /** The folder of the extension, which may bundle the program as `server/objdict`. */
  extension: string;
  /** The value of `PATH`. */
  path: string;
}

/** The end of a run: what was written, and the exit code (`docs/reference/cli.md`), or null if the program was ended. */
export interface Outcome {
  code: number | null;
  stdout: string;
  stderr: string;
}

/** A problem with its remedy, as the user reads it. */
export class ProgramError extends Error {}

/** More than any page of the documentation has; a program that writes more is ended. */
const MOST_OUTPUT = 64 * 1024 * 1024;
/** A command answers within seconds; one that does not is ended. In milliseconds. */
const LONGEST_RUN = 60_000;
const NAME = process.platform === "win32" ? "objdict.exe" : "objdict";

/** The program by setting, bundled with the extension, or on `PATH`, in this order. */
export function findProgram(places: Places): string {
  if (places.setting !== "") {
    if (isProgram(places.setting)) return places.setting;
    throw new ProgramError(
      `the setting \`objdict.server.path\` names \`${places.setting}\`, which is not a program: correct it or remove the setting`,
    );
  }
  const bundled = join(places.extension, "server", NAME);
  const onPath = places.path.split(delimiter).filter((folder) => folder !== "").map((folder) => join(folder, NAME));
  const found = [bundled, ...onPath].find(isProgram);
  if (found !== undefined) return found;
  throw new ProgramError(
    "the program `objdict` is not on PATH: install it, or write where it is in the setting `objdict.server.path`",
  );
}

function isProgram(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

/** Runs the program without a shell; `input` is its standard input. */
export function run(program: string, args: readonly string[], input = "", folder?: string): Promise<Outcome> {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: folder, timeout: LONGEST_RUN });
    const out: Buffer[] = [];
    const err: Buffer[] = [];
    let size = 0;
    const keep = (parts: Buffer[]) => (part: Buffer) => {
      size += part.length;
      if (size > MOST_OUTPUT) child.kill();
      else parts.push(part);
    };
    child.stdout.on("data", keep(out));
    child.stderr.on("data", keep(err));
    child.on("error", (error) => reject(new ProgramError(`\`${program}\` cannot be started: ${error.message}`)));
    child.on("close", (code) =>
      resolve({ code, stdout: Buffer.concat(out).toString(), stderr: Buffer.concat(err).toString() }),
    );
    // a program that ends before it has read everything closes the pipe; its exit code says why
    child.stdin.on("error", () => {});
    child.stdin.end(input);
  });
}

/** Runs a command whose standard output is wanted; its messages are the error if it fails. */
export async function output(program: string, args: readonly string[], input = "", folder?: string): Promise<string> {
  const outcome = await run(program, args, input, folder);
  if (outcome.code === 0) return outcome.stdout;
  const said = outcome.stderr.trim().replace(/^error: /, "").replaceAll("`<stdin>`", "the text");
  throw new ProgramError(said || `\`objdict ${args[0] ?? ""}\` did not finish`);
}

/** Refuses a program that has no language server. */
export async function requireServer(program: string): Promise<void> {
  const outcome = await run(program, ["lsp", "--help"]);
  if (outcome.code === 0) return;
  const version = (await run(program, ["--version"])).stdout.trim() || "no version";
  throw new ProgramError(
    `\`${program}\` (${version}) has no language server: install a newer objdict, or name one in \`objdict.server.path\``,
  );
}

/** The values that an option of a command accepts, as its help lists them: formats and targets are known to the program alone. */
export async function possibleValues(program: string, command: string, option: string): Promise<string[]> {
  const help = await output(program, [command, "-h"]);
  const start = help.search(new RegExp(`^\\s*(?:-\\w, )?--${option} `, "m"));
  const list = start < 0 ? null : /\[possible\s+values:\s+([^\]]+)\]/.exec(help.slice(start));
  if (list?.[1] === undefined) throw new ProgramError(`\`objdict ${command}\` lists no values for \`--${option}\``);
  return list[1].split(",").map((value) => value.trim());
}
