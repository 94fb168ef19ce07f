// What is written: the file as it is now or in another format, and what is generated of it.

import { Dialog } from "./dialog";
import { h, numberIn } from "./dom";
import type { MadeFile, Request } from "./protocol";
import { contentOf, type OpenDocument, type Store } from "./store";
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

export function saveDialog(store: Store): Dialog<OpenDocument> {
  const name = h("input", { id: "save-name", required: true, autofocus: true, autocomplete: "off" });
  const nodeId = h("input", { id: "save-node-id", type: "number", min: 1, max: 127 });
  const bitRate = h("input", { id: "save-bit-rate", list: "bit-rates", inputmode: "numeric" });
  const node = h("div", { class: "node" }, h("label", {}, "Node-ID ", nodeId), h("label", {}, "Bit rate in kbit/s ", bitRate));
  const storage = h("select", { id: "save-storage" }, h("option", { value: "" }, "as in the file"), h("option", { value: "expanded" }, "a section for each entry, written anew"), h("option", { value: "compact" }, "kept, written anew"));
  const compact = h("label", {}, "Compact storage ", storage);
  const format = h("select", { id: "save-format" }, ...FORMATS.map(([ending, label]) => h("option", { value: ending }, label)));
  const choice = h("label", {}, "Format ", format);
  const follow = () => {
    if (!choice.hidden && format.value !== OWN) name.value = `${stem(name.value)}.${format.value}`;
    const isDevice = !choice.hidden;
    node.hidden = !isDevice || !FORMATS.find(([ending]) => ending === format.value)![2];
    compact.hidden = !isDevice || !["eds", "dcf"].includes(format.value);
  };
  format.addEventListener("change", follow);
  const make = async (of: OpenDocument) => {
    const document = of.id;
    const number = (input: HTMLInputElement) => (input.value ? Number(input.value) : undefined);
    const request: Request = { do: "save", document, name: name.value, node_id: number(nodeId), bit_rate: number(bitRate), storage: compact.hidden ? undefined : (storage.value as "compact" | "expanded") || undefined };
    const isOwn = choice.hidden || format.value === OWN;
    await store.settled();
    const content = contentOf(of);
    const { files, notes } = await store.make(isOwn ? { do: "bytes", document } : request);
    deliver(isOwn ? files.map((file) => ({ ...file, name: name.value })) : files, "");
    // a file of `objdict open` is saved where it is
    if (isOwn && !of.home) of.saved = content;
    say(store, notes.map((note) => `not in the file: ${note}`));
  };
  const prepare = ({ state, outline }: OpenDocument) => {
    format.value = OWN;
    // of a network the text is saved
    choice.hidden = state.kind !== "device";
    storage.value = "";
    name.value = state.name.split("/").at(-1)!;
    nodeId.value = String(outline.node_id ?? "");
    follow();
  };
  const rates = h("datalist", { id: "bit-rates" }, ...BIT_RATES.map((rate) => h("option", { value: rate })));
  const fields = [choice, h("label", {}, "Name ", name), node, compact, rates];
  return new Dialog(store, "save", { title: "Save as", form: { fields, label: "Save", make }, prepare });
}

export function productsDialog(store: Store): Dialog<OpenDocument> {
  const boxes = PRODUCTS.map(([id]) => h("input", { type: "checkbox", value: id }));
  const nodeId = h("input", { type: "text", inputmode: "numeric", size: 4 });
  const make = async (document: OpenDocument) => {
    const chosen = PRODUCTS.filter((_, at) => boxes[at]!.checked);
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
  };
  const prepare = ({ outline }: OpenDocument) => void (nodeId.value = String(outline.node_id ?? ""));
  const fields = [
    h("fieldset", {}, h("legend", {}, "Files"), ...PRODUCTS.map(([, label], at) => h("label", { class: "choice" }, boxes[at]!, ` ${label}`))),
    h("label", {}, "Node-ID for DBC and concise DCF ", nodeId),
    h("p", { class: "meaning" }, "Several files come as a ZIP."),
  ];
  return new Dialog(store, "products", { title: "Download what is made of the device", form: { fields, label: "Download", make }, prepare });
}
