// Middle: a log of a bus in words, read with the open descriptions. Only the frames in sight are in the page; the engine has the others.

import { ask } from "./engine";
import { h, hex, redraw } from "./dom";
import { table } from "./network";
import type { BusReport, FrameFilter, Frames, Incident, LogSummary, Plot } from "./protocol";
import type { OpenDocument, Store } from "./store";

const ROW = 24;
/** Rows above and below those in sight. */
const AROUND = 30;
/** So many incidents are listed; `objdict decode` lists all. */
const MAX_INCIDENTS = 200;
/** Browsers draw no element that is higher, so a longer list is scrolled in larger steps. */
const MAX_HEIGHT = 8_000_000;

const some = (count: number): string => (count === 0 ? "" : String(count));
const rate = (load: number | undefined): string => (load == null ? "" : `${load.toFixed(2)} %`);

function busTables(bus: BusReport): HTMLElement {
  const nodes = bus.nodes.map((node) => [node.node === 0 ? "–" : String(node.node), node.name ?? "", String(node.frames), node.frames_per_second.toFixed(1), rate(node.load), node.state ?? "", some(node.boot_ups), some(node.lost_heartbeats), some(node.emergencies), some(node.aborted_transfers)]);
  const messages = bus.messages.map((message) => [`${hex(message.can_id, message.extended ? 8 : 3)}h`, message.name || message.kind, String(message.frames), message.cycle?.min ?? "", message.cycle?.mean ?? "", message.cycle?.max ?? "", message.described ?? ""]);
  const title = `${bus.channel ? `${bus.channel}: ` : ""}${bus.frames} frames, ${bus.frames_per_second.toFixed(1)} frames/s${bus.load == null ? "" : `, ${rate(bus.load)} load`}`;
  return h(
    "details",
    {},
    h("summary", {}, title),
    table(["Node", "Name", "Frames", "Frames/s", "Load", "State", "Boot-ups", "Lost", "EMCY", "Aborts"], nodes, "Nodes"),
    table(["CAN-ID", "Message", "Frames", "Min ms", "Mean ms", "Max ms", "Described"], messages, "Messages"),
  );
}

const STATES: Record<Incident["state"], string> = { unresolved: "Unresolved", recovered: "Recovered", warning: "Warning" };

/** What went wrong, with links to the frames. */
function incidentList(log: LogSummary, go: (line: number) => void): HTMLElement {
  const lines = (title: string, texts: string[]) => [h("h4", {}, title), h("ol", {}, ...texts.map((text) => h("li", {}, text)))];
  const each = ({ number, kind, state, channel, start, text, frames, causes, checks, why }: Incident) =>
    h(
      "details",
      { class: `incident ${state}` },
      h("summary", {}, `${number}. ${STATES[state]}, ${start}: ${channel ? `${channel}: ` : ""}${text} `, h("code", {}, kind)),
      h("p", { class: "meaning" }, why),
      h("ul", {}, ...frames.map((frame) => h("li", {}, h("button", { onclick: () => go(frame.line) }, frame.time), ` ${frame.text}`))),
      ...lines("Likely causes", causes),
      ...lines("What to check", checks),
    );
  const [first, ...rest] = log.verdict;
  return h("section", { class: "incidents", "aria-label": "Incidents" }, h("h3", {}, `${first?.toUpperCase()}${rest.join("")}`), ...log.incidents.slice(0, MAX_INCIDENTS).map(each));
}

function svg(tag: string, attributes: Record<string, string | number>, ...children: (Node | string)[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

const [WIDTH, HEIGHT] = [1000, 60];

/** A signal over time: numbers as a line with their extremes, words as bands. */
function plotted({ name, unit, points, runs, words }: Plot, end: number): HTMLElement {
  const x = (seconds: number) => +((WIDTH * seconds) / Math.max(end, 1e-9)).toFixed(2);
  const [least, greatest] = [Math.min(...points.map((point) => point[2])), Math.max(...points.map((point) => point[3]))];
  const y = (value: number) => +(HEIGHT - 4 - ((HEIGHT - 8) * (value - least)) / (greatest - least || 1)).toFixed(2);
  const path = points.map(([from, to, low, high, last], at) => `${at === 0 ? "M" : "L"}${x(from)} ${y(high)}L${x(from)} ${y(low)}L${x(to)} ${y(last)}`).join("");
  const bands = runs.map(([from, , word], at) => svg("rect", { class: `colour-${word % 8}`, x: x(from), y: 12, width: Math.max(1, x(runs[at + 1]?.[0] ?? end) - x(from)), height: 36 }, svg("title", {}, words[word] ?? "")));
  const label = points.length > 0 ? `${least} … ${greatest} ${unit}` : words.join(", ");
  const drawing = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", role: "img", "aria-label": `${name}: ${label}` }, ...(points.length > 0 ? [svg("path", { d: path })] : bands));
  return h("div", { class: "plot" }, h("p", {}, h("strong", {}, name), " ", h("span", { class: "meaning" }, points.length > 0 ? label : "", ...words.map((word, at) => h("span", { class: `key colour-${at % 8}` }, word)))), drawing as unknown as HTMLElement, h("p", { class: "axis meaning", "aria-hidden": "true" }, h("span", {}, "0 s"), h("span", {}, `${+(end / 2).toFixed(3)} s`), h("span", {}, `${+end.toFixed(3)} s`)));
}

function remarks(log: LogSummary): string[] {
  const undescribed = [...new Set(log.buses.flatMap((bus) => bus.undescribed))];
  const frames = log.buses.reduce((sum, bus) => sum + bus.frames, 0);
  return [
    ...(undescribed.length > 0 ? [`No description of node ${undescribed.join(", ")}: drop its EDS or DCF on the page.`] : []),
    ...log.notes,
    ...log.bad_lines.slice(0, 3).map(([line, reason]) => `Line ${line}: ${reason}.`),
    ...(log.bad_count > 3 ? [`${log.bad_count} lines are not understood.`] : []),
    ...(log.rows < frames ? [`The first ${log.rows} of ${frames} frames are listed; sums and findings are over all.`] : []),
  ];
}

export function logView(store: Store): HTMLElement {
  const filters = new Map<number, FrameFilter>();
  const kind = h("select", { "aria-label": "Kind of frames", onchange: () => filtered() });
  const node = h("select", { "aria-label": "Node", onchange: () => filtered() });
  const search = h("input", { type: "search", placeholder: "Search in frames", "aria-label": "Search in frames", oninput: () => filtered() });
  const total = h("span", { class: "count", role: "status" });
  const list = h("div", { class: "rows" });
  const scroll = h("div", { class: "scroll frames", tabindex: 0, role: "region", "aria-label": "Frames" }, list);
  const others = h("fieldset", { class: "others" });
  const sums = h("div", { class: "sums" });
  const time = h("select", { "aria-label": "Time", onchange: () => void show() }, ...[["log", "Time as logged"], ["start", "Since the start"], ["before", "Since the frame before"]].map(([value, label]) => h("option", { value }, label!)));
  const signals = h("input", { placeholder: "6064, 5.6041 …", "aria-label": "Signals to draw", onchange: () => of && ((of.plots = signals.value.split(",").map((text) => text.trim()).filter(Boolean)), store.changed()) });
  const plots = h("div", {});
  const drawn = h("details", { class: "plots" }, h("summary", {}, "Signals over time"), h("label", {}, "Signals ", signals), plots);
  const head = h("div", { class: "frame-head", "aria-hidden": "true" }, ...["Time", "Bus", "CAN-ID", "Data", "Meaning"].map((title) => h("span", {}, title)));
  const view = h("div", { class: "log" }, others, h("div", { class: "bar" }, node, kind, search, time, total), head, scroll, drawn, sums);
  let shown: LogSummary | undefined;
  let of: OpenDocument | undefined;
  let asked = 0;
  /** The number of rows that pass, and how many of them a row of the list is worth. */
  let [count, scale] = [0, 1];
  let marked: number | undefined;

  const filter = (): FrameFilter => filters.get(of?.id ?? -1) ?? { nodes: [], kinds: [], text: "" };
  const filtered = () => {
    if (!of) return;
    filters.set(of.id, { nodes: node.value ? [Number(node.value)] : [], kinds: kind.value ? [kind.value] : [], text: search.value });
    scroll.scrollTop = 0;
    void show();
  };
  const first = () => Math.floor((scroll.scrollTop / ROW) * scale);
  const show = async (line?: number) => {
    if (!of) return;
    const number = ++asked;
    const rows = Math.ceil((scroll.clientHeight || 600) / ROW) + 2 * AROUND;
    const start = Math.max(0, first() - AROUND);
    const frames = await ask<Frames>({ do: "frames", document: of.id, filter: filter(), first: start, count: rows, line }).catch(() => undefined);
    if (!frames || number !== asked) return;
    count = frames.total;
    const height = Math.min(count * ROW, MAX_HEIGHT);
    scale = Math.max(1, (count * ROW) / Math.max(1, height));
    list.style.height = `${height}px`;
    total.textContent = `${count} frame${count === 1 ? "" : "s"}`;
    if (line !== undefined) {
      marked = line;
      scroll.scrollTop = Math.max(0, (frames.first / scale) * ROW - scroll.clientHeight / 2);
      return void show();
    }
    const top = (at: number) => (scale === 1 ? (frames.first + at) * ROW : scroll.scrollTop + (frames.first + at - first()) * ROW);
    list.replaceChildren(
      ...frames.rows.map(({ seconds, line, kind, cells: [logged, channel, id, data, words] }, at) => {
        const before = frames.rows[at - 1]?.seconds ?? seconds;
        const shown = { log: logged, start: seconds.toFixed(6), before: `+${(seconds - before).toFixed(6)}` }[time.value];
        return h("div", { class: `row frame ${kind}${line === marked ? " marked" : ""}`, style: `top:${top(at)}px`, title: `line ${line}: ${words}` }, h("span", { class: "address" }, shown), h("span", { class: "type" }, channel), h("span", { class: "address id" }, id), h("span", { class: "address data" }, data), h("span", { class: "name" }, words));
      }),
    );
  };
  scroll.addEventListener("scroll", () => requestAnimationFrame(() => void show()));
  document.addEventListener("go-to-line", (event) => {
    if (store.view === "log") void show((event as CustomEvent<number>).detail);
  });

  const choices = (log: LogSummary) => {
    const { nodes, kinds, text } = filter();
    const known = new Map(log.buses.flatMap((bus) => bus.nodes).map((each) => [each.node, each.name]));
    const option = (value: string, label: string, selected: boolean) => h("option", { value, selected }, label);
    node.replaceChildren(option("", "All nodes", nodes.length === 0), ...[...known].filter(([id]) => id > 0).map(([id, name]) => option(String(id), name ? `${id} ${name}` : `${id}`, nodes.includes(id))));
    const all = [...new Set(log.buses.flatMap((bus) => bus.kinds.map((each) => each.kind)))];
    kind.replaceChildren(option("", "All kinds", kinds.length === 0), ...all.map((each) => option(each, each, kinds.includes(each))));
    search.value = text;
  };
  const descriptions = (log: OpenDocument) => {
    const chosen = store.descriptionsFor(log);
    const boxes = store.documents
      .filter((other) => other.state.kind !== "log")
      .map(({ id, state }) => {
        const isChosen = chosen.includes(id);
        const choose = () => ((log.with = isChosen ? chosen.filter((each) => each !== id) : [...chosen, id]), store.changed());
        return h("label", { class: "choice" }, h("input", { type: "checkbox", checked: isChosen, onchange: choose }), ` ${state.name}`);
      });
    redraw(others, h("legend", {}, "Read with"), ...(boxes.length > 0 ? boxes : [h("p", { class: "meaning" }, "Drop the EDS or DCF of the nodes, or their network, on the page: then PDOs and values have names.")]));
  };

  store.onDraw(() => {
    view.hidden = store.view !== "log";
    const { current } = store;
    if (view.hidden || !current?.log) return;
    descriptions(current);
    if (current.log === shown) return;
    if (of !== current) scroll.scrollTop = 0;
    [shown, of] = [current.log, current];
    choices(current.log);
    signals.value = (current.plots ?? []).join(", ");
    const end = Math.max(0, ...current.log.plots.flatMap(({ points, runs }) => [...points, ...runs].map((each) => each[1])));
    redraw(plots, ...(current.log.plots.length > 0 ? current.log.plots.map((plot) => plotted(plot, end)) : [h("p", { class: "meaning" }, "No value of a PDO changes. Name entries to draw others.")]));
    redraw(sums, incidentList(current.log, (line) => void show(line)), ...remarks(current.log).map((text) => h("p", { class: "meaning" }, text)), ...current.log.buses.map(busTables));
    void show();
  });
  return view;
}
