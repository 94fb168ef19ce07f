// Dialogs: filled in before they take input, locked while something is done, closed when it is done.

import { refusalOf } from "./engine";
import { h, type Child } from "./dom";
import type { Store } from "./store";

interface Parts<Subject> {
  title: Child;
  /** What can be chosen without the form. */
  choices?: Child[];
  /** The form and its button. */
  form?: { fields: Child[]; label: Child; make: (subject: Subject) => Promise<unknown> };
  /** Fills in the fields; they take no input before it ends. */
  prepare?: (subject: Subject) => Promise<void> | void;
}

/** A dialog about one subject, such as a document: the one that it was opened for, even when another is shown by now. */
export class Dialog<Subject = void> {
  readonly element: HTMLDialogElement;
  subject!: Subject;
  private readonly problem = h("p", { class: "remark error", role: "alert" });
  private readonly locks: (HTMLFieldSetElement | HTMLButtonElement)[] = [];
  /** What the fields are locked for; only its end unlocks them. */
  private reason: symbol | undefined;

  constructor(private readonly store: Store, name: string, private readonly parts: Parts<Subject>) {
    const { title, choices, form } = parts;
    const close = h("button", { type: "button", onclick: () => this.element.close() }, form ? "Cancel" : "Close");
    const submit = form && h("button", { type: "submit", class: "main" }, form.label);
    const body = (fields: Child[]) => this.locked(h("fieldset", { class: "body" }, ...fields));
    const actions = h("div", { class: "actions" }, close, submit && this.locked(submit));
    const make = (event: Event) => {
      event.preventDefault();
      void this.run(() => form!.make(this.subject));
    };
    const below = form ? [h("form", { method: "dialog", onsubmit: make }, body(form.fields), this.problem, actions)] : [this.problem, actions];
    this.element = h("dialog", { "aria-labelledby": `${name}-title` }, h("h2", { id: `${name}-title` }, title), choices && body(choices), ...below);
    document.body.append(this.element);
  }

  show(subject: Subject): void {
    this.subject = subject;
    const prepared = this.parts.prepare?.(subject);
    this.lock(undefined);
    this.tell("");
    this.element.showModal();
    if (prepared) void this.whileLocked(() => prepared);
  }

  /** Does something and closes the dialog; what was entered stays if it is refused. */
  async run(what: () => Promise<unknown>): Promise<void> {
    // a click on what is in a locked button reaches its listener
    if (this.reason) return;
    if (await this.whileLocked(what)) this.element.close();
  }

  private locked<Element extends HTMLFieldSetElement | HTMLButtonElement>(element: Element): Element {
    this.locks.push(element);
    return element;
  }

  private lock(reason: symbol | undefined): void {
    this.reason = reason;
    for (const element of this.locks) element.disabled = reason !== undefined;
  }

  private tell(problem: string): void {
    this.problem.textContent = problem;
    this.problem.hidden = problem === "";
  }

  /** Whether it was done and the dialog is still open for it. */
  private async whileLocked(what: () => Promise<unknown>): Promise<boolean> {
    const focused = document.activeElement as HTMLElement | null;
    const reason = Symbol();
    this.lock(reason);
    const isOpen = () => this.element.open && this.reason === reason;
    try {
      await what();
      return isOpen();
    } catch (error) {
      if (!isOpen()) this.store.say(error);
      else this.tell(Object.values(refusalOf(error)).filter(Boolean).join("; "));
      return false;
    } finally {
      if (isOpen()) this.lock(undefined);
      focused?.focus();
    }
  }
}
