// The workbench: a bar on top, objects on the left, one object, the text or a PDO in the middle, findings on the right.

import { compareView } from "./compare";
import { configureDialog } from "./configure";
import { addDialog, newDialog, pasteDialog } from "./create";
import { Drafts } from "./drafts";
import { ask, startEngine } from "./engine";
import { h, iconButton, prose, redraw } from "./dom";
import { EXAMPLES } from "./examples";
import { factsView } from "./facts";
import { Files } from "./files";
import { findingsPanel } from "./findings";
import { formView } from "./form";
import { logView } from "./log";
import { networkView } from "./network";
import { objectsPanel } from "./objects";
import { overview, type Doing } from "./overview";
import { productsDialog, saveDialog } from "./output";
import { pdoView } from "./pdo";
import type { Opened } from "./protocol";
import { Store, VIEWS, textBytes, type OpenDocument, type View } from "./store";
import { tableView } from "./table";
import { diffView, textView } from "./text";
import { welcome } from "./welcome";

const store = new Store();

/** Opens files; networks and logs are shown before the descriptions that they are read with. */
async function openFiles(files: Iterable<{ name: string; bytes: () => Promise<ArrayBuffer> }>): Promise<void> {
  const opened: OpenDocument[] = [];
  for (const file of files) {
    const document = await store.open(file.name, new Uint8Array(await file.bytes()));
    if (document) opened.push(document);
  }
  const shown = opened.find(({ state }) => state.kind === "log") ?? opened.find(({ state }) => state.kind === "network");
  if (shown) store.show(shown);
}

const chosen = (files: Iterable<File>) => [...files].map((file) => ({ name: file.name, bytes: () => file.arrayBuffer() }));

/** What a folder may have beside descriptions is not opened. */
const KNOWN = /\.(eds|dcf|xdd|xdc|nxdd|nxdc|toml|ya?ml|cpj|xpd|od|log|asc|blf|trc|csv|pcap|pcapng|candump)$/i;

/** The files that are dropped; those of folders have their paths, by which a network names them. */
async function dropped(items: DataTransferItemList): Promise<{ name: string; bytes: () => Promise<ArrayBuffer> }[]> {
  const found: { name: string; bytes: () => Promise<ArrayBuffer> }[] = [];
  const read = async (entry: FileSystemEntry, isNamed: boolean): Promise<void> => {
    if (entry.isFile) {
      if (!isNamed && !KNOWN.test(entry.name)) return;
      const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
      found.push({ name: entry.fullPath.replace(/^\//, ""), bytes: () => file.arrayBuffer() });
      return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    for (;;) {
      const entries = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
      if (entries.length === 0) return;
      for (const inner of entries) await read(inner, false);
    }
  };
  // the list is emptied when the event is over
  const entries = [...items].map((item) => item.webkitGetAsEntry());
  const files = [...items].map((item) => item.getAsFile());
  for (const [at, entry] of entries.entries()) {
    const file = files[at];
    if (entry?.isDirectory) await read(entry, true);
    else if (file) found.push(...chosen([file]));
  }
  return found;
}

const chooser = h("input", {
  type: "file",
  multiple: true,
  hidden: true,
  "aria-label": "Files to open",
  onchange: () => {
    void openFiles(chosen(chooser.files ?? [])).then(() => (chooser.value = ""));
  },
});

const files = new Files(store);
const dialogs = { save: saveDialog(store), products: productsDialog(store), create: newDialog(store), add: addDialog(store), configure: configureDialog(store), paste: pasteDialog(store) };

function button(label: string, what: () => void, attributes: Record<string, string> = {}): HTMLButtonElement {
  return h("button", { onclick: what, ...attributes }, label);
}

function undo(): void {
  // what was typed just now can be undone, though the engine does not have it yet
  if (store.current && store.current.state.kind !== "log") void store.change({ do: "undo", document: store.current.id });
}

function redo(): void {
  if (store.current && store.current.state.kind !== "log") void store.change({ do: "redo", document: store.current.id });
}

function examplesMenu(): HTMLElement {
  const list = EXAMPLES.map(([label, name, text]) =>
    button(label, () => {
      menu.open = false;
      void store.open(name, textBytes(text));
    }),
  );
  const menu = h("details", { class: "menu" }, h("summary", {}, "Examples"), h("div", { class: "items" }, ...list));
  return menu;
}

function topBar(): HTMLElement {
  const [back, again] = [iconButton("undo", "Undo", undo, { title: "Undo, Ctrl+Z" }), iconButton("redo", "Redo", redo, { title: "Redo, Ctrl+Shift+Z" })];
  const save = button("Save as …", () => dialogs.save.show(store.current!), { title: "Ctrl+S", class: "main" });
  const products = button("Download …", () => dialogs.products.show(store.current!), { title: "Code, documentation, DBC" });
  const add = button("Add object …", () => dialogs.add.show(store.current!));
  const configure = button("Configure …", () => dialogs.configure.show(store.current!));
  store.onDraw(() => {
    const state = store.current?.state;
    const isDevice = state?.kind === "device";
    back.disabled = !state?.can_undo;
    again.disabled = !state?.can_redo;
    save.disabled = !state || state.kind === "log";
    for (const each of [products, configure]) each.disabled = !isDevice;
    add.disabled = !isDevice || state.is_read_only;
  });
  const group = (...children: HTMLElement[]) => h("div", { class: "group" }, ...children);
  // in a narrow window, a menu has these
  const more = h("div", { class: "more", id: "more" }, button("Paste …", () => dialogs.paste.show()), button("New …", () => dialogs.create.show()), examplesMenu(), h("span", { class: "gap" }), add, configure, products);
  const menu = iconButton("menu", "Menu", () => open(!more.classList.contains("open")), { class: "icon-button menu-button", "aria-expanded": "false", "aria-controls": "more" });
  const open = (isOpen: boolean) => {
    more.classList.toggle("open", isOpen);
    menu.setAttribute("aria-expanded", String(isOpen));
  };
  addEventListener("click", ({ target }) => {
    if (!menu.contains(target as Node) && !(target as HTMLElement).closest?.("summary")) open(false);
  });
  addEventListener("keydown", ({ key }) => key === "Escape" && open(false));
  return h(
    "header",
    {},
    h("h1", {}, "objdict ", h("span", {}, "workbench")),
    button("Open …", () => chooser.click(), { title: "Ctrl+O" }),
    menu,
    more,
    group(back, again),
    ...files.buttons,
    save,
    iconButton("theme", "Dark or light", switchTheme),
    chooser,
  );
}

function switchTheme(): void {
  const root = document.documentElement;
  const isDark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = isDark ? "light" : "dark";
}

function documentTabs(): HTMLElement {
  const tabs = h("nav", { class: "documents", "aria-label": "Open files" });
  const network = button("Network of these files", () => void store.attempt(async () => store.take(await ask<Opened>({ do: "new-network" }))), { class: "quiet" });
  const tab = (document: OpenDocument) => {
    const { name, format, encoding } = document.state;
    const isCurrent = document === store.current;
    return h(
      "span",
      { class: isCurrent ? "document current" : "document", "data-key": `document-${document.id}` },
      h("button", { title: [format, encoding].filter(Boolean).join(", "), "aria-current": isCurrent ? "page" : undefined, onclick: () => store.show(document) }, `${name}${files.isChanged(document) ? " •" : ""}`),
      h("button", { class: "quiet", "aria-label": `Close ${name}`, onclick: () => void files.close(document) }, "×"),
    );
  };
  store.onDraw(() => {
    tabs.hidden = store.documents.length === 0;
    const count = store.documents.filter(({ state }) => state.kind === "device").length;
    network.hidden = count < 2 || store.documents.some(({ state }) => state.kind === "network");
    redraw(tabs, ...store.documents.map(tab), network);
  });
  return tabs;
}

const LABELS: [View, string][] = [
  ["network", "Network"],
  ["log", "Log"],
  ["overview", "Overview"],
  ["form", "Object"],
  ["table", "Table"],
  ["pdo", "PDOs"],
  ["facts", "Device"],
  ["text", "Text"],
  ["diff", "Changes"],
  ["compare", "Compare"],
];

const doing: Doing[] = [
  { label: "Configure a node …", meaning: "node-ID, bit rate and values, as DCF or XDC", what: (document) => dialogs.configure.show(document) },
  { label: "Save or convert …", meaning: "EDS, DCF, XDD, XDC, device.toml", what: (document) => dialogs.save.show(document) },
  { label: "Generate …", meaning: "C, Rust, CANopenNode, documentation, DBC", what: (document) => dialogs.products.show(document) },
];

function middle(): HTMLElement {
  const tabs = LABELS.map(([view, label]) => {
    const tab = button(label, () => {
      store.view = view;
      store.draw();
    });
    return { view, tab };
  });
  store.onDraw(() => {
    for (const { view, tab } of tabs) {
      tab.setAttribute("aria-pressed", String(view === store.view));
      tab.hidden = !VIEWS[store.current?.state.kind ?? "device"].includes(view);
    }
  });
  return h("main", { class: "panel" }, h("div", { class: "bar views" }, ...tabs.map(({ tab }) => tab)), networkView(store), logView(store), overview(store, doing), formView(store), tableView(store), factsView(store), textView(store), pdoView(store), diffView(store), compareView(store));
}

function notice(): HTMLElement {
  const element = h("div", { class: "notice", role: "alert" });
  store.onDraw(() => {
    element.hidden = !store.notice;
    if (!store.notice) return;
    const close = () => {
      store.notice = undefined;
      store.draw();
    };
    const { kind, message, help, actions = [] } = store.notice;
    element.className = `notice ${kind}`;
    redraw(element, h("p", {}, ...prose(message)), help && h("p", { class: "help" }, ...prose(help)), ...actions.map(({ label, make }) => button(label, () => (close(), make()))), button("Close", close, { class: "quiet" }));
  });
  return element;
}

function listen(): void {
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer?.files.length) void dropped(event.dataTransfer.items).then(openFiles);
  });
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || document.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    // in a field, the browser undoes what was typed there
    const isTyping = event.target instanceof HTMLInputElement && event.target.value !== event.target.defaultValue;
    const save = () => void files.save().then((isSaved) => !isSaved && store.current && store.current.state.kind !== "log" && dialogs.save.show(store.current));
    const action = { z: event.shiftKey ? redo : undo, y: redo, o: () => chooser.click(), s: save }[key];
    if (!action || (isTyping && (key === "z" || key === "y"))) return;
    event.preventDefault();
    // a field commits its text when it loses the focus
    if (event.target instanceof HTMLInputElement) event.target.blur();
    action();
  });
  addEventListener("hashchange", () => store.follow());
  addEventListener("beforeunload", (event) => {
    if (store.documents.some((document) => files.isChanged(document))) event.preventDefault();
  });
}

/** From a host, the page opens without a network too; the second time it is asked for, all of it is kept. */
function keepForOffline(): void {
  const isHosted = location.protocol.startsWith("http") && !document.getElementById("embedded-engine");
  if (isHosted && import.meta.env.PROD) void navigator.serviceWorker?.register("./offline.js").catch(() => {});
}

async function start(): Promise<void> {
  const panels = h("div", { class: "panels" }, objectsPanel(store), middle(), findingsPanel(store));
  store.onDraw(() => {
    panels.hidden = !store.current;
    panels.dataset.kind = store.current?.state.kind;
  });
  const first = welcome(() => chooser.click(), (name, text) => void store.open(name, textBytes(text)));
  store.onDraw(() => (first.hidden = store.current !== undefined));
  document.getElementById("app")!.replaceChildren(topBar(), documentTabs(), notice(), first, panels);
  listen();
  await startEngine(() => void store.reopen());
  keepForOffline();
  store.draw();
  await files.start();
  await new Drafts(store, files).start();
}

void start();
