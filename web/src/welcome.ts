// The page before anything is open: what the tool does, in a picture of it.

import { h } from "./dom";
import { EXAMPLES } from "./examples";

const step = (title: string, text: string, ...picture: HTMLElement[]): HTMLElement => h("li", { class: "card" }, h("h3", {}, title), h("div", { class: "sketch", "aria-hidden": "true" }, ...picture), h("p", {}, text));
const line = (...cells: string[]): HTMLElement => h("tr", {}, ...cells.map((cell) => h("td", {}, cell)));
const block = (colour: number, bits: number, name: string): HTMLElement => h("span", { class: `mapped colour-${colour}`, style: `flex: 0 0 ${(100 * bits) / 64}%` }, h("span", { class: "name" }, name));

export function welcome(choose: () => void, open: (name: string, text: string) => void): HTMLElement {
  const finding = h("div", { class: "finding error" }, h("span", { class: "severity remark error" }, "error"), " 1018sub1", h("p", {}, h("code", {}, "0x1FFFFFFFF"), " is out of range"), h("span", { class: "chip" }, "Fix"));
  const table = h("table", {}, h("tbody", {}, line("01", "Rated current", "4.5 A"), line("02", "Peak current", "13.5 A"), line("03", "Pole pairs", "4")));
  const bytes = h("div", { class: "bytes small", style: "--byte: 12.5%" }, block(0, 16, "Statusword"), block(1, 32, "Position"));
  const made = h("div", { class: "chips" }, ...["C", "Rust", "CANopenNode", "DCF", "XDD", "DBC", "HTML"].map((name) => h("span", { class: "chip" }, name)));
  return h(
    "section",
    { class: "welcome" },
    h("h2", {}, "Drop device descriptions, a network or a log here"),
    h("p", {}, "EDS, DCF, XDD, XDC, device.toml · network.toml, bus.yml · candump, ASC, TRC, CSV, pcap. The files stay in this browser."),
    h("div", { class: "actions" }, h("button", { class: "main", onclick: choose }, "Choose files …"), ...EXAMPLES.map(([label, name, text]) => h("button", { onclick: () => open(name, text) }, label))),
    h("ol", { class: "steps" }, step("Check and fix", "What breaks tools and devices, with fixes.", finding), step("Edit", "Each change is one line of your file; the rest stays.", table), step("Map PDOs", "Drag objects into eight bytes.", bytes), step("Generate", "The same files as the command writes.", made)),
  );
}
