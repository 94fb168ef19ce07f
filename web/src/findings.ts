// Right: what was found, with fixes.

import { ask } from "./engine";
import { arrange, h, indexOf } from "./dom";
import type { Finding } from "./protocol";
import type { Store } from "./store";

/** So many are drawn; a file may have tens of thousands. */
const MAX_SHOWN = 400;

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
  const title = fix.safety === "safe" ? "keeps the meaning" : "needs your review";
  return h("button", { class: `fix ${fix.safety}`, title, onclick: make, "data-key": `fix-${finding.fingerprint}` }, fix.title);
}

function item(store: Store, finding: Finding, objects: Set<number>): HTMLElement {
  const index = indexOf(finding.place);
  const has = index !== undefined && objects.has(index);
  const go = () => {
    const { kind } = store.current!.state;
    store.index = has ? index : store.index;
    store.view = kind === "log" ? "log" : has && store.view !== "text" ? "form" : "text";
    store.draw();
    if (store.view !== "form") requestAnimationFrame(() => document.dispatchEvent(new CustomEvent("go-to-line", { detail: finding.line })));
  };
  return h(
    "li",
    { class: `finding ${finding.severity}` },
    h("button", { class: "where", onclick: go }, h("span", { class: "severity" }, finding.severity), ` line ${finding.line}`, finding.place ? ` · ${finding.place}` : ""),
    h("p", {}, finding.message),
    finding.help && h("p", { class: "help" }, finding.help),
    h("div", { class: "actions" }, fixButton(store, finding), h("code", {}, finding.rule)),
  );
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

export function findingsPanel(store: Store): HTMLElement {
  const list = h("ul", { class: "scroll", "aria-label": "Findings", tabindex: 0 });
  const summary = h("p", { role: "status", class: "summary" });
  const safe = h("button", { onclick: () => void store.change({ do: "fix-all", document: store.current!.id, tools: store.tools }) }, "Make all safe fixes");
  store.onDraw(() => {
    const document = store.current;
    const findings = document?.report.findings ?? [];
    const { errors = 0, warnings = 0, notes = 0 } = document?.report.summary ?? {};
    const count = (number: number, word: string) => `${number} ${word}${number === 1 ? "" : "s"}`;
    const counts = [count(errors, "error"), count(warnings, "warning"), count(notes, "note")].join(", ");
    summary.textContent = document ? { running: "Checking …", done: counts, failed: "The check failed" }[document.check] : "";
    safe.hidden = !findings.some((finding) => finding.fix?.safety === "safe");
    const objects = new Set(document?.outline.objects.map((object) => object.index));
    const key = (finding: Finding, at: number) => JSON.stringify([document?.id, document?.checked, at, finding, document?.outline.objects.length]);
    const shown = findings.slice(0, MAX_SHOWN).map((finding, at): [string, () => HTMLElement] => [key(finding, at), () => item(store, finding, objects)]);
    if (findings.length > MAX_SHOWN) shown.push([`${findings.length}`, () => h("li", {}, `and ${findings.length - MAX_SHOWN} more`)]);
    if (document?.check === "done" && findings.length === 0) shown.push(["none", () => h("li", { class: "nothing" }, "No findings.")]);
    arrange(list, shown);
    list.setAttribute("aria-busy", String(document !== undefined && !document.has_fixes));
  });
  return h("aside", { "aria-label": "Findings", class: "panel findings" }, h("div", { class: "bar" }, summary, safe), toolChoice(store), list);
}
