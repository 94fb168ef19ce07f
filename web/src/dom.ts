// Elements without a framework. Texts are always text: nothing of a file is read as HTML.

export type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | undefined | ((event: never) => void)>;

const isChild = (child: Child): child is Node | string => child !== null && child !== undefined && child !== false;

/** What each element listens to; `redraw` gives an element in the page what its new drawing listens to. */
const listeners = new WeakMap<Element, Record<string, EventListener>>();

const heard = (event: Event): void => listeners.get(event.currentTarget as Element)?.[event.type]?.(event);

function listen(element: Element, to: Record<string, EventListener>): void {
  // a listener that is there already is not added again
  for (const type of Object.keys(to)) element.addEventListener(type, heard);
  listeners.set(element, to);
}

export function h<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  listen(element, Object.fromEntries(Object.entries(attributes).flatMap(([name, value]) => (typeof value === "function" ? [[name.slice(2), value as EventListener]] : []))));
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") continue;
    if (value === true) element.setAttribute(name, "");
    else if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children.filter(isChild));
  return element;
}

/** A text of the engine: what is between backticks is code. */
export const prose = (text: string): Child[] => text.split("`").map((part, at) => (at % 2 === 1 ? h("code", {}, part) : part));

/** A button that only shows an icon of `style.css`. */
export const iconButton = (icon: string, label: string, onclick: () => void, attributes: Attributes = {}): HTMLButtonElement =>
  h("button", { type: "button", class: "icon-button", "aria-label": label, title: label, onclick, ...attributes }, h("span", { class: `icon ${icon}`, "aria-hidden": "true" }));

/** Locks the fields of an element until it is redrawn. */
export function disable(element: HTMLElement): void {
  for (const field of element.querySelectorAll<HTMLInputElement | HTMLButtonElement | HTMLSelectElement>("input, button, select")) field.disabled = true;
}

/** Chromium sends `blur` to a field that is removed. */
let isRedrawing = false;

/** What an element is known by among those beside it. */
const keyOf = (node: Node): string => (node instanceof Element ? `${node.nodeName} ${node.id || node.getAttribute("data-key") || node.getAttribute("data-place") || ""}` : node.nodeName);

/** Makes an element in the page what `now` is. What the user did with it stays: the focus, a selection, typed text, an open help or list. */
function become(old: Element, now: Element): void {
  const field = old as HTMLInputElement;
  const isTyped = old instanceof HTMLInputElement && field.type !== "checkbox" && field.value !== field.defaultValue;
  // what is opened and closed by the user
  const own = (name: string) => name === "open" && old instanceof HTMLDetailsElement;
  for (const { name } of [...old.attributes]) if (!now.hasAttribute(name) && !own(name)) old.removeAttribute(name);
  for (const { name, value } of now.attributes) if (old.getAttribute(name) !== value && !own(name)) old.setAttribute(name, value);
  const to = listeners.get(now) ?? {};
  listen(old, to);
  fill(old, [...now.childNodes]);
  // a field that gives its text to nobody keeps it, others as long as they are typed in
  if (isTyped && (!to["change"] || old === document.activeElement)) return;
  if ((old instanceof HTMLInputElement || old instanceof HTMLSelectElement) && field.value !== (now as HTMLInputElement).value) field.value = (now as HTMLInputElement).value;
  if (field.checked !== (now as HTMLInputElement).checked) field.checked = (now as HTMLInputElement).checked;
}

/** Gives an element these children; present ones with the same key become them. */
function fill(parent: Element, children: Node[]): void {
  const known = new Map<string, Node[]>();
  for (const child of parent.childNodes) known.set(keyOf(child), known.get(keyOf(child)) ?? []).get(keyOf(child))!.push(child);
  const kept = new Set(children.map((now) => {
    const old = known.get(keyOf(now))?.shift();
    if (!old || old === now) return now;
    if (old instanceof Element) become(old, now as Element);
    else if (old.nodeValue !== now.nodeValue) old.nodeValue = now.nodeValue;
    return old;
  }));
  for (const child of [...parent.childNodes]) if (!kept.has(child)) child.remove();
  let at = parent.firstChild;
  for (const child of kept) {
    if (child === at) at = at.nextSibling;
    else parent.insertBefore(child, at);
  }
}

/** Draws the content of an element again. Elements are known by `id`, `data-key` or `data-place`, others by their order, and stay in the
 *  page with all that the user did with them. */
export function redraw(view: Element, ...children: Child[]): void {
  const active = view.contains(document.activeElement) ? (document.activeElement as HTMLElement) : undefined;
  isRedrawing = true;
  try {
    fill(view, children.filter(isChild).map((child) => (child instanceof Node ? child : document.createTextNode(child))));
  } finally {
    isRedrawing = false;
  }
  if (!active || active === document.activeElement) return;
  const again = active.isConnected ? active : active.dataset.key && view.querySelector<HTMLElement>(`[data-key="${CSS.escape(active.dataset.key)}"]`);
  if (again) again.focus({ preventScroll: true });
}

/** The events with which a field gives away its text: when it is left, and with Enter. Escape takes back what was typed. */
export function committing(text: string, commit: (value: string) => Promise<boolean>): Record<string, (event: Event) => void> {
  let given = text;
  const give = ({ target }: Event) => {
    const input = target as HTMLInputElement;
    if (isRedrawing || input.value === given) return;
    given = input.value;
    void commit(given).then((done) => {
      if (!done) input.value = given = text;
    });
  };
  return {
    onchange: give,
    onblur: give,
    onkeydown: (event: Event) => {
      const { key } = event as KeyboardEvent;
      if (key === "Enter") give(event);
      if (key === "Escape") (event.target as HTMLInputElement).value = text;
    },
  };
}

/** A number in the other base, as its type has it; other texts stay. */
export function inBase(text: string, base: "text" | "hex" | "dec"): string {
  if (base === "text" || !/^(0x[0-9a-f]+|\d+)$/i.test(text)) return text;
  const number = BigInt(text);
  return base === "dec" ? number.toString() : `0x${number.toString(16).toUpperCase()}`;
}

/** Whether each word of a search is in a text. */
export const finds = (search: string, text: string): boolean => search.toLowerCase().split(/\s+/).every((word) => text.toLowerCase().includes(word));

const SHORT: Record<string, string> = { UNSIGNED: "u", INTEGER: "i", REAL: "f", BOOLEAN: "bool", VISIBLE_STRING: "string", OCTET_STRING: "bytes", UNICODE_STRING: "unicode" };

/** A type as engineers write it: `u32` for UNSIGNED32. */
export const shortType = (type: string): string => type.replace(/^[A-Z_]+/, (name) => SHORT[name] ?? name);

/** An address in any usual spelling: `6040`, `0x6040`, `6040h:00`, `1018sub1`. */
export function addressIn(text: string): { index: number; sub?: number } | undefined {
  const [, index, sub] = /^(?:0x)?([0-9a-f]{4})h?(?:(?::|\/|\.|sub)(?:0x)?([0-9a-f]{1,2})h?)?$/i.exec(text.trim()) ?? [];
  return index === undefined ? undefined : { index: parseInt(index, 16), sub: sub === undefined ? undefined : parseInt(sub, 16) };
}

export const hex = (number: number, digits: number): string => number.toString(16).toUpperCase().padStart(digits, "0");
export const indexText = (index: number): string => `${hex(index, 4)}h`;
export const addressText = (index: number, sub: number): string => `${hex(index, 4)}h:${hex(sub, 2)}`;
export const placeOf = (index: number, sub?: number): string =>
  `0x${hex(index, 4)}${sub === undefined ? "" : `sub${sub.toString(16).toUpperCase()}`}`;

/** The object that a place of a finding is about. */
export function indexOf(place: string | undefined): number | undefined {
  const found = /^0x([0-9A-F]{4})/.exec(place ?? "");
  return found ? parseInt(found[1]!, 16) : undefined;
}

/** The number in a text, decimal or `0x…`; NaN for anything else. */
export const numberIn = (text: string): number => (/^(0x[0-9a-f]+|\d+)$/i.test(text.trim()) ? Number(text) : NaN);
