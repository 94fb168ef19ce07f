// The extension: it starts the language server, and offers the commands of objdict that have no request of the protocol.

import { existsSync } from "node:fs";
import { basename, dirname, extname } from "node:path";
import * as vscode from "vscode";
import { type DocumentFilter, LanguageClient } from "vscode-languageclient/node";

import { beside, convert, documentation, drawing, generate, isOfNode, lostCharacters, nodeIdIn, nodeIdProblem, objectAt, pdoOf, sectionLine, type Source } from "./description";
import { findProgram, possibleValues, requireServer } from "./program";

/** The command behind the links of a drawing. */
const GO_TO = "objdict.goTo";
/** How long after a change a drawing follows, in milliseconds: not at every key. */
const FOLLOWS_AFTER = 300;
/** The pages with the texts that they are about, by their titles. */
const panels = new Map<string, { panel: vscode.WebviewPanel; document: vscode.TextDocument }>();
/** How the pages are drawn that follow their text, by their titles. */
const drawings = new Map<string, { document: vscode.TextDocument; draw: (html: string) => string }>();
/** The characters that saving destroys. */
const encodings = vscode.languages.createDiagnosticCollection("objdict encoding");
let waiting: NodeJS.Timeout | undefined;
let client: LanguageClient | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const command = (name: string, action: (program: string) => Promise<void>) =>
    context.subscriptions.push(
      vscode.commands.registerCommand(`objdict.${name}`, () => reported(() => action(program(context)))),
    );
  command("documentationBeside", showDocumentation);
  command("pdo", showPdo);
  command("convert", convertFile);
  command("generate", generateCode);
  command("network", showNetwork);
  command("restart", () => start(context));
  context.subscriptions.push(
    vscode.commands.registerCommand(GO_TO, (path: string, section: string) => reported(() => goTo(path, section))),
    vscode.workspace.onDidChangeTextDocument(({ document }) => {
      clearTimeout(waiting);
      waiting = setTimeout(() => void follow(document), FOLLOWS_AFTER);
    }),
    encodings,
    vscode.workspace.onDidOpenTextDocument((document) => void warnOfEncoding(document)),
    vscode.workspace.onDidChangeTextDocument(({ document }) => encodings.has(document.uri) && showLost(document)),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (["objdict.server", "objdict.files"].some((name) => event.affectsConfiguration(name)))
        void reported(() => start(context));
    }),
  );
  vscode.workspace.textDocuments.forEach((document) => void warnOfEncoding(document));
  await reported(() => start(context));
}

/** Marks the characters that are lost when the file is saved; how many they are. */
function showLost(document: vscode.TextDocument): number {
  const lost = lostCharacters(document.getText());
  const message = "the file has another encoding than UTF-8, and saving destroys this character: reopen the file with its encoding";
  encodings.set(document.uri, lost.map(([line, column]) => new vscode.Diagnostic(new vscode.Range(line, column, line, column + 1), message, vscode.DiagnosticSeverity.Warning)));
  return lost.length;
}

/** Says that a file was read in another encoding than its own, before it is saved. */
async function warnOfEncoding(document: vscode.TextDocument): Promise<void> {
  if (document.languageId !== "eds" || showLost(document) === 0) return;
  const reopen = "Reopen with encoding";
  const message = `\`${basename(document.fileName)}\` is not UTF-8: saving it now destroys characters`;
  if ((await vscode.window.showWarningMessage(message, reopen)) === reopen)
    await vscode.commands.executeCommand("workbench.action.editor.changeEncoding");
}

export async function deactivate(): Promise<void> {
  await client?.dispose();
  client = undefined;
}

function program(context: vscode.ExtensionContext): string {
  const setting = vscode.workspace.getConfiguration("objdict").get<string>("server.path", "").trim();
  return findProgram({ setting, extension: context.extensionPath, path: process.env["PATH"] ?? "" });
}

async function start(context: vscode.ExtensionContext): Promise<void> {
  await deactivate();
  const command = program(context);
  await requireServer(command);
  const settings = vscode.workspace.getConfiguration("objdict");
  const files: DocumentFilter[] = settings.get<string[]>("files", []).map((pattern) => ({ scheme: "file", pattern }));
  const started = new LanguageClient(
    "objdict",
    "objdict",
    { command, args: ["lsp", ...settings.get<string[]>("server.arguments", [])] },
    {
      documentSelector: [...["file", "untitled"].map((scheme) => ({ scheme, language: "eds" })), ...files],
      // the action of the server opens a browser; here the page goes beside the text
      middleware: {
        executeCommand: (name, args, next) =>
          name === "objdict.showDocumentation" ? reported(() => showDocumentation(command)) : next(name, args),
      },
    },
  );
  client = started;
  await started.start();
}

/** Runs an action and shows its error, with a way to the setting that it names. */
async function reported(action: () => Promise<void>): Promise<void> {
  try {
    await action();
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const settings = message.includes("objdict.server.path") ? ["Open settings"] : [];
    if ((await vscode.window.showErrorMessage(message, ...settings)) !== undefined)
      await vscode.commands.executeCommand("workbench.action.openSettings", "objdict.server");
  }
}

/** The description in front, or the one that the page in front is about, and the line of the cursor. */
function active(): { source: Source; document: vscode.TextDocument; line: number } {
  const editor = vscode.window.activeTextEditor;
  const document = editor?.document ?? [...panels.values()].find(({ panel }) => panel.active)?.document;
  if (document === undefined || document.isUntitled) throw new Error("open and save a description first");
  return { source: { path: document.uri.fsPath, text: document.getText() }, document, line: editor?.selection.active.line ?? 0 };
}

/** The documentation: of a description as the server has it, unsaved; of a network as it is on the disk. */
async function pageOf(program: string, document: vscode.TextDocument): Promise<string> {
  const html = await served(document);
  if (html !== undefined) return html;
  if (document.isDirty) await document.save();
  return documentation(program, document.uri.fsPath);
}

/** The documentation of a description as the server has it. */
async function served(document: vscode.TextDocument): Promise<string | undefined> {
  const request = { command: "objdict.documentation", arguments: [document.uri.toString()] };
  const html: unknown = await client?.sendRequest("workspace/executeCommand", request).catch(() => undefined);
  return typeof html === "string" ? html : undefined;
}

async function showDocumentation(program: string): Promise<void> {
  const { source, document } = active();
  const html = await pageOf(program, document);
  // The page has a policy of its own, which lets its one script and style run by their hashes and nothing else.
  page(`Documentation of ${basename(source.path)}`, document, html, { enableScripts: true }, vscode.ViewColumn.Active);
}

async function showPdo(program: string): Promise<void> {
  const { source, document, line } = active();
  const index = objectAt(source.text, line);
  const pdo = index === undefined ? undefined : pdoOf(index);
  if (pdo === undefined) throw new Error("the cursor is not in a section of a PDO: go to `[1800]`, `[1A00]` or one of their sub-indices");
  const link = (section: string) => `command:${GO_TO}?${encodeURIComponent(JSON.stringify([source.path, section]))}`;
  const draw = (html: string) => drawing(html, pdo, link);
  const title = `${pdo} of ${basename(source.path)}`;
  page(title, document, draw(await pageOf(program, document)), { enableCommandUris: [GO_TO] });
  drawings.set(title, { document, draw });
}

/** Draws the pages of a text again. A drawing stays as long as the text, half typed, has no such PDO. */
async function follow(document: vscode.TextDocument): Promise<void> {
  const own = [...drawings].filter(([, { document: drawn }]) => drawn === document);
  const html = own.length > 0 ? await served(document) : undefined;
  if (html === undefined) return;
  for (const [title, { draw }] of own) {
    const shown = panels.get(title);
    try {
      if (shown !== undefined) shown.panel.webview.html = draw(html);
    } catch {
      continue;
    }
  }
}

/** Shows a section of a description that is open. */
async function goTo(path: string, section: string): Promise<void> {
  const document = await vscode.workspace.openTextDocument(path);
  const line = sectionLine(document.getText(), section);
  if (line === undefined) throw new Error(`\`${basename(path)}\` has no section \`[${section}]\` any more: show the PDO again`);
  const shown = vscode.window.visibleTextEditors.find((editor) => editor.document === document);
  const selection = new vscode.Range(line, 0, line, 0);
  await vscode.window.showTextDocument(document, { viewColumn: shown?.viewColumn ?? vscode.ViewColumn.One, selection });
}

async function convertFile(program: string): Promise<void> {
  const { source } = active();
  const own = extname(source.path).slice(1).toLowerCase();
  const formats = (await possibleValues(program, "convert", "to")).filter((format) => format !== own);
  const stated = nodeIdIn(source.text);
  const items = formats.map((label) => ({ label, description: isOfNode(label) ? `for one node${stated === undefined ? ", asks for its node-ID" : ""}` : "" }));
  const to = (await vscode.window.showQuickPick(items, { title: "Convert to" }))?.label;
  if (to === undefined) return;
  const asked = { title: "Node-ID", prompt: `A \`.${to}\` is for one node.`, value: stated ?? "", validateInput: nodeIdProblem };
  const nodeId = isOfNode(to) ? await vscode.window.showInputBox(asked) : undefined;
  if (isOfNode(to) && nodeId === undefined) return;
  const target = beside(source.path, to);
  if (existsSync(target)) {
    const replace = "Replace";
    const answer = await vscode.window.showWarningMessage(`\`${basename(target)}\` exists. Replace it?`, { modal: true }, replace);
    if (answer !== replace) return;
  }
  const lost = await convert(program, source, to, target, nodeId?.trim());
  if (lost.length > 0) void vscode.window.showWarningMessage(`\`${basename(target)}\` has no place for: ${lost.join("; ")}`);
  await vscode.commands.executeCommand("vscode.open", vscode.Uri.file(target));
}

async function generateCode(program: string): Promise<void> {
  const { source } = active();
  // a template is a file of the user's own, which the command line names
  const targets = (await possibleValues(program, "generate", "target")).filter((target) => target !== "template");
  const target = await vscode.window.showQuickPick(targets, { title: "Generate" });
  if (target === undefined) return;
  const folders = await vscode.window.showOpenDialog({
    canSelectFiles: false,
    canSelectFolders: true,
    defaultUri: vscode.Uri.file(dirname(source.path)),
    openLabel: "Generate here",
  });
  const folder = folders?.[0];
  if (folder === undefined) return;
  await generate(program, source, target, folder.fsPath);
  void vscode.window.showInformationMessage(`wrote \`${target}\` to ${folder.fsPath}`);
}

/** The network as it is on the disk, with the descriptions that it names. */
async function showNetwork(program: string): Promise<void> {
  const { source, document } = active();
  if (document.isDirty) await document.save();
  page(`Network of ${basename(source.path)}`, document, await documentation(program, source.path), { enableScripts: true });
}

/** Shows a page; beside the text, which keeps the focus: the next command is about the text again. */
function page(title: string, document: vscode.TextDocument, html: string, options: vscode.WebviewOptions, viewColumn = vscode.ViewColumn.Beside): void {
  const place = { viewColumn, preserveFocus: viewColumn === vscode.ViewColumn.Beside };
  let panel = panels.get(title)?.panel;
  if (panel === undefined) {
    panel = vscode.window.createWebviewPanel("objdict", title, place, { enableFindWidget: true, localResourceRoots: [], ...options });
    panel.onDidDispose(() => [panels, drawings].forEach((of) => of.delete(title)));
  } else panel.reveal(undefined, true);
  panels.set(title, { panel, document });
  panel.webview.html = html;
}
