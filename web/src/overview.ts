// Middle: what a device is, what its PDOs carry, what is wrong with it, and what can be done next.

import { ask } from "./engine";
import { h, hex, prose, redraw } from "./dom";
import { count, fixAllButton, goTo, hasSafeFix, SEVERITIES, summaryOf } from "./findings";
import { bitsOf, coloursOf, picture } from "./pdo";
import type { Outline, PartForm, PdoRow } from "./protocol";
import type { OpenDocument, Store, View } from "./store";

/** So many PDOs and findings are drawn. */
const MAX_PDOS = 12;
const MAX_FINDINGS = 5;

const ABOUT: Record<string, string> = {
  eds: "An EDS describes what every device of this type offers. Configure one to get the DCF of a node.",
  dcf: "A DCF is one configured node: what its type offers, with a node-ID and values of its own.",
  xdd: "An XDD describes what every device of this type offers, in XML. Configure one to get the XDC of a node.",
  xdc: "An XDC is one configured node, in XML.",
};

/** What the overview can start. */
export interface Doing {
  label: string;
  meaning: string;
  what: (document: OpenDocument) => void;
}

function card(title: string, ...content: (Node | string | false)[]): HTMLElement {
  return h("section", { class: "card", "aria-label": title }, h("h3", {}, title), ...content);
}

const tile = (label: string, meaning: string, onclick: () => void): HTMLElement => h("li", {}, h("button", { onclick }, label, h("span", { class: "meaning" }, meaning)));

function device({ state, outline }: OpenDocument, parts: PartForm[]): HTMLElement {
  const field = (name: string) => parts.flatMap((part) => part.fields).find((field) => field.name === name)?.text;
  const with_number = (text: string | undefined, number: string | undefined) => [text, number && `(${number})`].filter(Boolean).join(" ");
  const rates = parts.flatMap((part) => part.fields).filter(({ name, text }) => name.startsWith("BaudRate_") && /^(1|0x0*1|true)$/i.test(text ?? ""));
  const own = outline.objects.filter(({ index }) => index >= 0x2000 && index < 0x6000).length;
  const facts: [string, string | undefined | false][] = [
    ["Vendor", with_number(outline.vendor ?? undefined, field("VendorNumber"))],
    ["Product", with_number(outline.product ?? undefined, field("ProductNumber"))],
    ["Profile", outline.profile ? `CiA ${outline.profile}` : "none"],
    ["Node-ID", outline.node_id ? String(outline.node_id) : outline.is_node && "not stated"],
    ["Bit rates", rates.length > 0 ? `${rates.map(({ name }) => name.slice("BaudRate_".length)).join(", ")} kbit/s` : "none stated"],
    ["Objects", `${outline.objects.length}${own > 0 ? `, ${own} of the vendor` : ""}`],
    ["File", `${state.format}, ${state.encoding}`],
  ];
  return card("Device", h("dl", {}, ...facts.filter(([, text]) => text).flatMap(([name, text]) => [h("dt", {}, name), h("dd", {}, text as string)])));
}

function pdos(store: Store, outline: Outline): HTMLElement | false {
  const colour = coloursOf(outline);
  const shown = outline.pdos.map((pdo, position) => ({ pdo, position })).filter(({ pdo }) => pdo.mapped.length > 0);
  if (shown.length === 0) return false;
  const words = ({ kind, number, can_id, is_valid, mapped }: PdoRow) => [`${kind} ${number}`, can_id == null ? "" : `${hex(can_id, 3)}h${outline.node_id ? "" : " for node 1"}`, is_valid === false ? "not valid" : "", `${bitsOf(mapped)} of 64 bits`].filter(Boolean).join(" · ");
  const row = ({ pdo, position }: { pdo: PdoRow; position: number }) =>
    h("div", { class: pdo.is_valid === false ? "pdo-row off" : "pdo-row" }, h("button", { class: bitsOf(pdo.mapped) > 64 ? "link remark error" : "link", onclick: () => store.selectPdo(position) }, words(pdo)), picture(pdo, colour));
  const more = shown.length - MAX_PDOS;
  return card("PDOs", h("div", { class: "pdo-rows" }, ...shown.slice(0, MAX_PDOS).map(row)), more > 0 && h("p", { class: "meaning" }, `and ${more} more, in the list on the left`));
}

function wrong(store: Store, document: OpenDocument): HTMLElement {
  const { findings } = document.report;
  const sorted = SEVERITIES.flatMap((severity) => findings.filter((finding) => finding.severity === severity));
  const rows = sorted.slice(0, MAX_FINDINGS).map((finding) => h("li", {}, h("button", { class: "link", onclick: () => goTo(store, finding) }, h("span", { class: `severity ${finding.severity}` }, finding.severity), " ", ...prose(finding.message))));
  const left = findings.length - rows.length;
  return card("Check", h("p", {}, h("strong", {}, findings.length === 0 && document.check === "done" ? "No findings: nothing is wrong." : summaryOf(document))), hasSafeFix(document) && h("p", {}, fixAllButton(store)), h("ul", { class: "plain" }, ...rows), left > 0 && h("p", { class: "meaning" }, `and ${count(left, "more finding")} on the right`));
}

export function overview(store: Store, doing: Doing[]): HTMLElement {
  const view = h("div", { class: "overview scroll", tabindex: -1 });
  let asked = 0;
  const show = (to: View) => () => ((store.view = to), store.draw());
  store.onDraw(async () => {
    view.hidden = store.view !== "overview";
    const { current } = store;
    if (view.hidden || !current) return;
    const number = ++asked;
    const parts = await ask<PartForm[]>({ do: "facts", document: current.id }).catch(() => []);
    if (number !== asked || store.current !== current) return;
    const { outline, state } = current;
    const ending = state.format.toLowerCase();
    const views: [string, View, string][] = [["Edit objects", "form", "each object as a table"], ["File and device", "facts", "names, numbers, bit rates"], ["Edit the text", "text", "with completion and help"]];
    const next = [
      ...views.map(([label, to, meaning]) => tile(label, meaning, show(to))),
      ...doing.map(({ label, meaning, what }) => tile(label, meaning, () => what(current))),
    ];
    redraw(
      view,
      h("div", { class: "title" }, h("h2", {}, outline.product ?? state.name)),
      h("p", { class: "meaning" }, ABOUT[ending] ?? `${state.format}: a device description.`),
      h("div", { class: "cards" }, device(current, parts), wrong(store, current)),
      h("ul", { class: "plain next", "aria-label": "What to do next" }, ...next),
      pdos(store, outline),
    );
  });
  return view;
}
