// Right: what was found, the worst first, with fixes. A click leads to the field, or to the line.

import { ask } from "./engine";
import { h, prose, redraw } from "./dom";
import type { Finding } from "./protocol";
import type { OpenDocument, Store } from "./store";

/** So many are drawn; a file may have tens of thousands. */
const MAX_SHOWN = 400;

/** From so many on, the findings of one rule are a group. */
const GROUP = 3;

export const SEVERITIES = ["error", "warning", "note"] as const;

export const count = (number: number, word: string): string => `${number} ${word}${number === 1 ? "" : "s"}`;

/** Shows the place of a finding. */
export function goTo(store: Store, finding: Finding): void {
  const { kind } = store.current!.state;
  if (kind === "device" && store.view !== "text" && finding.place && store.selectPlace(finding.place)) return;
  store.view = kind === "log" ? "log" : "text";
  store.draw();
  requestAnimationFrame(() => requestAnimationFrame(() => document.dispatchEvent(new CustomEvent("go-to-line", { detail: finding.line }))));
}

function fixButton(store: Store, finding: Finding): HTMLElement | false {
  const { fix } = finding;
  const document = store.current!;
  if (!fix || document.state.is_read_only) return false;
  const make = () =>
    void store.change(
      fix.encoding
        ? { do: "encode", document: document.id, encoding: fix.encoding }
        : { do: "edit", document: document.id, revision: document.checked, edits: fix.edits },
    );
  const [word, title] = fix.safety === "safe" ? ["safe", "keeps the meaning"] : ["review", "may change the meaning: review it"];
  return h("button", { class: `fix ${fix.safety}`, title, onclick: make, "data-key": `fix-${finding.fingerprint}` }, ...prose(fix.title), h("span", { class: "word" }, word));
}

function item(store: Store, finding: Finding): HTMLElement {
  const { network } = store.current!;
  // on a page, there is no folder to look for a file in
  const missing = finding.rule === "network/unreadable-node" ? network?.missing?.find(([node]) => finding.message.includes(`\`${node}\``)) : undefined;
  const help = missing ? `drop \`${missing[1]}\` on the page` : finding.help;
  const isSaid = help !== undefined && help.replaceAll(/\W/g, "").toLowerCase() === finding.fix?.title.replaceAll(/\W/g, "").toLowerCase();
  return h(
    "li",
    { class: `finding ${finding.severity}` },
    h("button", { class: "where", onclick: () => goTo(store, finding) }, h("span", { class: "severity" }, finding.severity), ` line ${finding.line}`, finding.place ? ` · ${finding.place}` : ""),
    h("p", {}, ...prose(finding.message)),
    help && !isSaid && h("p", { class: "help" }, ...prose(help)),
    h("div", { class: "actions" }, fixButton(store, finding), h("code", {}, finding.rule)),
  );
}

/** The findings in the order in which they are shown: the worst first, those of one rule together where they are many. */
function grouped(findings: Finding[]): Finding[][] {
  const rules = new Map<string, Finding[]>();
  for (const finding of findings) {
    const key = `${finding.severity} ${finding.rule}`;
    rules.set(key, [...(rules.get(key) ?? []), finding]);
  }
  const groups = [...rules.values()].flatMap((group) => (group.length < GROUP ? group.map((finding) => [finding]) : [group]));
  const order = ([first]: Finding[]) => SEVERITIES.indexOf(first!.severity);
  return groups.sort((one, other) => order(one) - order(other) || one[0]!.line - other[0]!.line);
}

/** The tools whose reactions are shown. */
function toolChoice(store: Store): HTMLElement {
  const names = h("fieldset", { class: "tools" }, h("legend", {}, "What these would say"));
  const element = h("details", { class: "tools" }, h("summary", {}, "Other tools"), names);
  const choose = () => {
    store.tools = [...names.querySelectorAll<HTMLInputElement>("input:checked")].map((box) => box.value);
    element.querySelector("summary")!.textContent = store.tools.length > 0 ? `Other tools: ${store.tools.join(", ")}` : "Other tools";
    void store.recheck();
  };
  element.addEventListener("toggle", async () => {
    if (!element.open || names.children.length > 1) return;
    const tools = await ask<string[]>({ do: "tools" });
    names.append(...tools.map((tool) => h("label", { class: "choice" }, h("input", { type: "checkbox", value: tool, onchange: choose }), ` ${tool}`)));
  });
  store.onDraw(() => (element.hidden = store.current?.state.kind !== "device"));
  return element;
}

/** The number of findings as a text. */
export function summaryOf({ check, report }: OpenDocument): string {
  const { errors, warnings, notes } = report.summary;
  return { running: "Checking …", done: [count(errors, "error"), count(warnings, "warning"), count(notes, "note")].join(", "), failed: "The check failed" }[check];
}

export const hasSafeFix = ({ report }: OpenDocument): boolean => report.findings.some((finding) => finding.fix?.safety === "safe");

export function fixAllButton(store: Store): HTMLButtonElement {
  return h("button", { onclick: () => void store.change({ do: "fix-all", document: store.current!.id, tools: store.tools }) }, "Make all safe fixes");
}

export function findingsPanel(store: Store): HTMLElement {
  const list = h("ul", { class: "scroll", "aria-label": "Findings", tabindex: 0 });
  const summary = h("p", { role: "status", class: "summary" });
  const safe = fixAllButton(store);
  const hidden = new Set<string>();
  const open = new Set<string>();
  /** What is drawn, and of what. */
  let [of, drawn]: [OpenDocument | undefined, string] = [undefined, ""];
  const filters = SEVERITIES.map((severity) => h("button", { class: `filter ${severity}`, onclick: () => (hidden.delete(severity) || hidden.add(severity), store.draw()) }));
  const filter = h("div", { class: "group", role: "group", "aria-label": "Findings that are shown" }, ...filters);
  const group = (findings: Finding[]): HTMLElement => {
    const { rule, severity } = findings[0]!;
    const toggled = ({ currentTarget }: Event) => void ((currentTarget as HTMLDetailsElement).open ? open.add(rule) : open.delete(rule));
    const element = h("details", { open: open.has(rule), ontoggle: toggled }, h("summary", { class: severity }, h("span", { class: "severity" }, `${findings.length} ${severity}s`), " ", h("code", {}, rule)), h("ul", {}, ...findings.map((finding) => item(store, finding))));
    return h("li", { class: "finding-group", "data-key": `${severity} ${rule}` }, element);
  };
  store.onDraw(() => {
    const document = store.current;
    const all = document?.report.findings ?? [];
    summary.textContent = document ? summaryOf(document) : "";
    safe.hidden = !document || !hasSafeFix(document);
    const kinds = SEVERITIES.filter((severity) => all.some((finding) => finding.severity === severity));
    // the filter shows their number too
    filter.hidden = kinds.length < 2;
    summary.classList.toggle("aside", !filter.hidden);
    for (const [at, severity] of SEVERITIES.entries()) {
      const number = all.filter((finding) => finding.severity === severity).length;
      filters[at]!.textContent = count(number, severity);
      filters[at]!.hidden = number === 0;
      filters[at]!.setAttribute("aria-pressed", String(!hidden.has(severity)));
    }
    const findings = kinds.length < 2 ? all : all.filter(({ severity }) => !hidden.has(severity));
    list.setAttribute("aria-busy", String(document !== undefined && !document.has_fixes));
    const shown = findings.slice(0, MAX_SHOWN);
    const state = JSON.stringify([shown, findings.length, document?.check, document?.network?.missing]);
    if (of === document && state === drawn) return;
    [of, drawn] = [document, state];
    const more = findings.length > MAX_SHOWN && h("li", {}, `and ${findings.length - MAX_SHOWN} more`);
    const none = document?.check === "done" && all.length === 0 && h("li", { class: "nothing" }, "No findings.");
    redraw(list, ...grouped(shown).map((findings) => (findings.length > 1 ? group(findings) : item(store, findings[0]!))), more, none);
  });
  return h("aside", { "aria-label": "Findings", class: "panel findings" }, h("div", { class: "bar" }, summary, filter, safe), toolChoice(store), list);
}
