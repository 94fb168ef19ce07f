// Elements without a framework. Texts are always text: nothing of a file is read as HTML.

export type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | undefined | ((event: never) => void)>;

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
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

/** Chromium sends `blur` to a field that is replaced. */
let isRedrawing = false;

/** Redraws an element. The field with the keyboard focus, known by its `data-key`, keeps the focus and what was typed there so far. */
export function redraw(view: HTMLElement, ...children: Node[]): void {
  const active = document.activeElement;
  const former = active instanceof HTMLElement && view.contains(active) ? active : undefined;
  const key = former?.dataset.key;
  isRedrawing = true;
  view.replaceChildren(...children);
  isRedrawing = false;
  if (!former || !key) return;
  const again = view.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`);
  again?.focus({ preventScroll: true });
  if (!(former instanceof HTMLInputElement && again instanceof HTMLInputElement)) return;
  if (former.value !== former.defaultValue) again.value = former.value;
  // a checkbox or a number has no selection
  if (former.selectionStart !== null) again.setSelectionRange(former.selectionStart, former.selectionEnd);
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

const arranged = new WeakMap<HTMLElement, Map<string, HTMLElement>>();

/** Gives an element these children, and reuses present ones with the same key: a click is lost when the element under it is
 *  replaced between its two ends. */
export function arrange(parent: HTMLElement, children: [key: string, make: () => HTMLElement][]): void {
  const former = arranged.get(parent);
  const now = new Map(children.map(([key, make]) => [key, former?.get(key) ?? make()]));
  arranged.set(parent, now);
  const kept = new Set(now.values());
  for (const child of [...parent.children]) if (!kept.has(child as HTMLElement)) child.remove();
  let at = parent.firstElementChild;
  for (const child of kept) {
    if (child === at) at = at.nextElementSibling;
    else parent.insertBefore(child, at);
  }
}

/** A number in the other base, as its type has it; other texts stay. */
export function inBase(text: string, base: "text" | "hex" | "dec"): string {
  if (base === "text" || !/^(0x[0-9a-f]+|\d+)$/i.test(text)) return text;
  const number = BigInt(text);
  return base === "dec" ? number.toString() : `0x${number.toString(16).toUpperCase()}`;
}

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
