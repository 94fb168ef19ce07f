// What is written: the file as it is now or in another format, and what is generated of it.

import { h, numberIn } from "./dom";
import type { MadeFile, Request } from "./protocol";
import { contentOf, type Store } from "./store";
import { zip } from "./zip";

export function download(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = h("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** In kbit/s, those of CiA 301. */
export const BIT_RATES = [10, 20, 50, 125, 250, 500, 800, 1000];

const stem = (name: string): string => name.replace(/\.[^.]*$/, "");

/** The format of the file itself: nothing is converted, whatever the name. */
const OWN = "";

const FORMATS: [ending: string, label: string, needsNode: boolean][] = [
  [OWN, "as it is", false],
  ["eds", "EDS", false],
  ["dcf", "DCF", true],
  ["xdd", "XDD", false],
  ["xdc", "XDC", true],
  ["toml", "device.toml", false],
];

const PRODUCTS: [id: string, label: string, request: (document: number, node_id?: number) => Request][] = [
  ["c", "Tables in C", (document) => ({ do: "generate", document, target: "c" })],
  ["rust", "Tables in Rust", (document) => ({ do: "generate", document, target: "rust" })],
  ["canopennode", "Tables for CANopenNode", (document) => ({ do: "generate", document, target: "canopennode" })],
  ["html", "Documentation (HTML)", (document) => ({ do: "docs", document, form: "html" })],
  ["md", "Documentation (Markdown)", (document) => ({ do: "docs", document, form: "md" })],
  ["csv", "Table of entries (CSV)", (document) => ({ do: "docs", document, form: "csv" })],
  ["dbc", "DBC", (document, node_id) => ({ do: "dbc", document, node_id })],
  ["concise", "Concise DCF", (document, node_id) => ({ do: "concise", document, node_id })],
];

/** One file as it is, several as a ZIP. */
function deliver(files: MadeFile[], archive: string): void {
  const [first] = files;
  if (!first) return;
  if (files.length === 1) download(first.name.split("/").at(-1)!, new Blob([first.bytes as BlobPart], { type: "application/octet-stream" }));
  else download(archive, zip(files));
}

function say(store: Store, notes: string[]): void {
  const shown = notes.slice(0, 5).join("; ");
  const more = notes.length > 5 ? `; and ${notes.length - 5} more` : "";
  store.notice = notes.length > 0 ? { kind: "note", message: shown + more } : undefined;
  store.draw();
}

export function saveDialog(store: Store): HTMLDialogElement {
  const name = h("input", { id: "save-name", required: true, autocomplete: "off" });
  const nodeId = h("input", { id: "save-node-id", type: "number", min: 1, max: 127 });
  const bitRate = h("input", { id: "save-bit-rate", list: "bit-rates", inputmode: "numeric" });
  const node = h("div", { class: "node" }, h("label", {}, "Node-ID ", nodeId), h("label", {}, "Bit rate in kbit/s ", bitRate));
  const storage = h("select", { id: "save-storage" }, h("option", { value: "" }, "as in the file"), h("option", { value: "expanded" }, "a section for each entry, written anew"), h("option", { value: "compact" }, "kept, written anew"));
  const compact = h("label", {}, "Compact storage ", storage);
  const format = h("select", { id: "save-format" }, ...FORMATS.map(([ending, label]) => h("option", { value: ending }, label)));
  const choice = h("label", {}, "Format ", format);
  const follow = () => {
    if (!choice.hidden && format.value !== OWN) name.value = `${stem(name.value)}.${format.value}`;
    const isDevice = store.current?.state.kind === "device";
    node.hidden = !isDevice || !FORMATS.find(([ending]) => ending === format.value)![2];
    compact.hidden = !isDevice || !["eds", "dcf"].includes(format.value);
  };
  format.addEventListener("change", follow);
  const save = async (event: Event) => {
    event.preventDefault();
    const shown = store.current!;
    const document = shown.id;
    const number = (input: HTMLInputElement) => (input.value ? Number(input.value) : undefined);
    const request: Request = { do: "save", document, name: name.value, node_id: number(nodeId), bit_rate: number(bitRate), storage: compact.hidden ? undefined : (storage.value as "compact" | "expanded") || undefined };
    const isOwn = choice.hidden || format.value === OWN;
    const isSaved = await store.attempt(async () => {
      await store.settled();
      const content = contentOf(shown);
      const { files, notes } = await store.make(isOwn ? { do: "bytes", document } : request);
      deliver(isOwn ? files.map((file) => ({ ...file, name: name.value })) : files, "");
      // a file of `objdict open` is saved where it is
      if (isOwn && !shown.home) shown.saved = content;
      say(store, notes.map((note) => `not in the file: ${note}`));
    });
    // the input stays, with the reason for the refusal below
    if (isSaved) dialog.close();
    else problem.textContent = [store.notice?.message, store.notice?.help].filter(Boolean).join("; ");
  };
  const problem = h("p", { class: "remark error", role: "alert" });
  const dialog = h(
    "dialog",
    { "aria-labelledby": "save-title" },
    h(
      "form",
      { method: "dialog", onsubmit: save },
      h("h2", { id: "save-title" }, "Save as"),
      choice,
      h("label", {}, "Name ", name),
      node,
      compact,
      problem,
      h("datalist", { id: "bit-rates" }, ...BIT_RATES.map((rate) => h("option", { value: rate }))),
      h("div", { class: "actions" }, h("button", { type: "button", onclick: () => dialog.close() }, "Cancel"), h("button", { type: "submit", class: "main" }, "Save")),
    ),
  );
  dialog.addEventListener("toggle", () => {
    if (!dialog.open || !store.current) return;
    const { state, outline } = store.current;
    format.value = OWN;
    problem.textContent = "";
    // of a network the text is saved
    choice.hidden = state.kind !== "device";
    storage.value = "";
    name.value = state.name.split("/").at(-1)!;
    nodeId.value = String(outline.node_id ?? "");
    follow();
  });
  return dialog;
}

export function productsDialog(store: Store): HTMLDialogElement {
  const boxes = PRODUCTS.map(([id, label]) => {
    const box = h("input", { type: "checkbox", value: id });
    return h("label", { class: "choice" }, box, ` ${label}`);
  });
  const nodeId = h("input", { type: "text", inputmode: "numeric", size: 4 });
  const go = async (event: Event) => {
    event.preventDefault();
    const document = store.current!;
    const chosen = PRODUCTS.filter(([id]) => dialog.querySelector<HTMLInputElement>(`input[value="${id}"]`)!.checked);
    await store.attempt(async () => {
      const [all, notes]: [MadeFile[], string[]] = [[], []];
      const node = numberIn(nodeId.value);
      for (const [id, , request] of chosen) {
        const made = await store.make(request(document.id, Number.isNaN(node) ? undefined : node));
        const folder = chosen.length > 1 && made.files.length > 1 ? `${id}/` : "";
        all.push(...made.files.map((file) => ({ ...file, name: folder + file.name })));
        notes.push(...made.notes.map((note) => `${id}: ${note}`));
      }
      deliver(all, `${stem(document.state.name)}.zip`);
      say(store, notes);
    });
    dialog.close();
  };
  const dialog = h(
    "dialog",
    { "aria-labelledby": "products-title" },
    h(
      "form",
      { method: "dialog", onsubmit: go },
      h("h2", { id: "products-title" }, "Download what is made of the device"),
      h("fieldset", {}, h("legend", {}, "Files"), ...boxes),
      h("label", {}, "Node-ID for DBC and concise DCF ", nodeId),
      h("p", { class: "meaning" }, "Several files come as a ZIP."),
      h("div", { class: "actions" }, h("button", { type: "button", onclick: () => dialog.close() }, "Cancel"), h("button", { type: "submit", class: "main" }, "Download")),
    ),
  );
  dialog.addEventListener("toggle", () => {
    if (dialog.open) nodeId.value = String(store.current?.outline.node_id ?? "");
  });
  return dialog;
}
