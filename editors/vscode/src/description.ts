// What the commands do with the text of a description. Nothing here needs the editor.

import { basename, dirname, extname, join } from "node:path";

import { output } from "./program";

/** A file as the editor has it, saved or not. */
export interface Source {
  /** The path of the file. */
  path: string;
  /** The text, which counts more than what is on the disk. */
  text: string;
}

/** An EDS and a DCF may have the same text; the extension is the difference, and standard input has none. TOML says what it is. */
function format(source: Source): string[] {
  const extension = extname(source.path).slice(1).toLowerCase();
  return ["eds", "dcf", "xdd", "xdc"].includes(extension) ? ["--from", extension] : [];
}

/** The documentation of a file on the disk as one page of HTML, which brings its content security policy. */
export function documentation(program: string, path: string): Promise<string> {
  return output(program, ["docs", path, "-o", "-", "--to", "html", "--quiet"], "", dirname(path));
}

/** The objects of `[1A00]`, `[1A00sub1]` or `[1800]` above a line (from zero), or undefined outside such a section. */
export function objectAt(text: string, line: number): string | undefined {
  const above = text.split(/\r\n|\r|\n/).slice(0, line + 1).reverse();
  for (const row of above) {
    const section = /^\s*\[([^\]]*)\]/.exec(row);
    if (section === null) continue;
    return /^\s*([0-9a-f]{4})(?:sub[0-9a-f]{1,2}|value|name|denotation)?\s*$/i.exec(section[1] ?? "")?.[1]?.toUpperCase();
  }
  return undefined;
}

/** The line (from zero) of a section such as `1A00sub1`, else of its object. */
export function sectionLine(text: string, section: string): number | undefined {
  const names = text.split(/\r\n|\r|\n/).map((row) => /^\s*\[\s*([^\]]*?)\s*\]/.exec(row)?.[1]?.toLowerCase());
  return [section, section.slice(0, 4)].map((name) => names.indexOf(name.toLowerCase())).find((line) => line >= 0);
}

/** The name of a PDO, `rpdo1` to `tpdo512`, if the object is its communication or mapping (CiA 301 §7.5.2.35 to 38). */
export function pdoOf(index: string): string | undefined {
  const number = Number.parseInt(index, 16);
  const receives = number >= 0x1400 && number <= 0x17ff;
  const transmits = number >= 0x1800 && number <= 0x1bff;
  return receives || transmits ? `${receives ? "rpdo" : "tpdo"}${(number & 0x1ff) + 1}` : undefined;
}

/** The drawing of a PDO: its part of a documentation, under the same policy; what it maps is a link for `link`. */
export function drawing(html: string, pdo: string, link: (section: string) => string): string {
  const article = new RegExp(`<article [^>]*id="${pdo}">[^]*?</article>`).exec(html)?.[0];
  if (article === undefined) throw new Error(`the documentation has no ${pdo}: correct the findings of its sections`);
  const lines = /<svg class="bits defs"[^]*?<\/svg>/.exec(html)?.[0] ?? "";
  const linked = article.replace(/<a href="#([^"]*)"/g, (_, section: string) => `<a href="${link(section)}"`);
  return `${html.slice(0, html.indexOf("<body"))}<body><main>${lines}${linked}</main></body></html>`;
}

/** The file beside a description that a conversion writes. */
export function beside(path: string, to: string): string {
  return join(dirname(path), `${basename(path, extname(path))}.${to}`);
}

/** Whether a format is about one node, so that it needs a node-ID. */
export const isOfNode = (to: string): boolean => ["dcf", "xdc", "dbc", "cdcf", "cdcf.txt"].includes(to);

/** The node-ID that a DCF or XDC states. */
export function nodeIdIn(text: string): string | undefined {
  return /^\s*NodeID\s*=\s*(\S+)/im.exec(text)?.[1] ?? /\bnodeID="([^"]+)"/.exec(text)?.[1];
}

/** Why a text is no node-ID. */
export function nodeIdProblem(text: string): string | undefined {
  const number = /^(0x[0-9a-f]+|\d+)$/i.test(text.trim()) ? Number(text) : NaN;
  return number >= 1 && number <= 127 ? undefined : "a node-ID is a number from 1 to 127";
}

/** The lines and columns (from zero) of characters that were lost when the file was read in another encoding than its own. */
export function lostCharacters(text: string): [line: number, column: number][] {
  return text.split(/\r\n|\r|\n/).flatMap((row, line) => [...row.matchAll(/\uFFFD/g)].map(({ index }): [number, number] => [line, index]));
}

/** Writes a description in another format, and returns what is lost. `target` is replaced, so ask before. */
export async function convert(program: string, source: Source, to: string, target: string, nodeId?: string): Promise<string[]> {
  const node = nodeId === undefined ? [] : ["--node-id", nodeId];
  const arguments_ = ["convert", "-", ...format(source), "--to", to, ...node, "-o", target];
  const report = await output(program, arguments_, source.text, dirname(source.path));
  const lines = report.split("\n").map((line) => line.trim());
  return lines.filter((line) => line.startsWith("lost: ")).map((line) => line.slice("lost: ".length));
}

/** Generates code into a folder; files that objdict did not write stay. */
export async function generate(program: string, source: Source, target: string, folder: string): Promise<void> {
  await output(program, ["generate", "-", ...format(source), "--target", target, "-o", folder, "--quiet"], source.text, dirname(source.path));
}
