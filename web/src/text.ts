// Middle: the text of the file with its findings underlined, and what was changed in it. What is typed goes to the engine as edits of
// spans, so that line ends and encoding of the file stay.

import { defaultKeymap } from "@codemirror/commands";
import { lintGutter, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { unifiedMergeView } from "@codemirror/merge";
import { search, searchKeymap } from "@codemirror/search";
import { Annotation, ChangeSet, EditorState, type Text } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { ask } from "./engine";
import { h } from "./dom";
import { colour, languageOf, type Asker } from "./language";
import type { Position, State, TextEdit } from "./protocol";
import type { OpenDocument, Store } from "./store";

/** Marks what did not come from the user. */
const fromEngine = Annotation.define<boolean>();

/** So long nothing is typed before the engine is asked. */
const PAUSE = 250;

const MAX_UNDERLINED = 1000;

/** The position of a line and column; columns of findings count Unicode scalar values. */
function offset(doc: Text, line: number, column: number): number {
  if (line > doc.lines) return doc.length;
  const { from, text } = doc.line(Math.max(1, line));
  let units = 0;
  for (const character of text) {
    if (--column < 1) break;
    units += character.length;
  }
  return from + units;
}

function lineAndColumn(doc: Text, at: number): [number, number] {
  const line = doc.lineAt(at);
  return [line.number, [...line.text.slice(0, at - line.from)].length + 1];
}

function diagnosticsOf(document: OpenDocument, doc: Text): Diagnostic[] {
  const at = (position: Position): [number, number] => {
    const from = offset(doc, position.line, position.column);
    return [from, Math.max(from, offset(doc, position.end_line, position.end_column))];
  };
  return document.report.findings.slice(0, MAX_UNDERLINED).map((finding) => {
    const [from, to] = at(finding);
    const help = finding.help ? `\n${finding.help}` : "";
    return { from, to, severity: finding.severity === "note" ? "info" : finding.severity, message: `${finding.message}${help}`, source: finding.rule };
  });
}

/** The edits of changes, in the lines of the text before them. */
export function editsOf(changes: ChangeSet, before: Text, lineEnd: string): TextEdit[] {
  const edits: TextEdit[] = [];
  changes.iterChanges((from, to, _from, _to, inserted) => {
    const [line, column] = lineAndColumn(before, from);
    const [end_line, end_column] = lineAndColumn(before, to);
    edits.push({ line, column, end_line, end_column, text: inserted.sliceString(0, undefined, lineEnd) });
  });
  return edits;
}

/** The one stretch of the text in which another differs. */
function differenceOf(old: Text, now: Text): ChangeSet {
  const [before, after] = [old.toString(), now.toString()];
  let start = 0;
  while (start < before.length && start < after.length && before[start] === after[start]) start++;
  let end = 0;
  while (end < before.length - start && end < after.length - start && before[before.length - 1 - end] === after[after.length - 1 - end]) end++;
  return ChangeSet.of({ from: start, to: before.length - end, insert: after.slice(start, after.length - end) }, before.length);
}

/** The text of a document as it is edited, also while another is shown. */
class EditedText {
  private state: EditorState;
  private view: EditorView | undefined;
  /** The lines that the engine has, and their number. */
  private known: Text;
  private revision: number;
  /** What was typed since, in the steps in which it is sent; what is typed now belongs to the last one while it is open. */
  private steps: ChangeSet[] = [];
  private isOpen = false;
  /** How many steps have their turn already, and when the last of them is sent. */
  private queued = 0;
  private sent: Promise<void> = Promise.resolve();
  private timer = 0;
  /** The revision that has its colours. */
  private coloured = -1;
  private readonly asker: Asker = async (about) => {
    await this.store.settled();
    return ask({ do: "language", document: this.document.id, about });
  };

  constructor(
    private readonly store: Store,
    readonly document: OpenDocument,
  ) {
    const { text, is_read_only, revision } = document.state;
    this.state = EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        highlightActiveLine(),
        drawSelection(),
        search({ top: true }),
        ...languageOf(this.asker),
        keymap.of([...defaultKeymap, ...searchKeymap]),
        EditorState.readOnly.of(is_read_only),
        EditorView.contentAttributes.of({ "aria-label": "Text of the file", spellcheck: "false", tabindex: "0" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !update.transactions.some((transaction) => transaction.annotation(fromEngine))) this.typed(update.changes);
        }),
      ],
    });
    this.known = this.state.doc;
    this.revision = revision;
  }

  show(view: EditorView): void {
    this.view = view;
    view.setState(this.state);
  }

  leave(): void {
    this.state = this.view!.state;
    this.view = undefined;
  }

  private typed(changes: ChangeSet): void {
    const last = this.isOpen ? this.steps.pop() : undefined;
    this.steps.push(last ? last.compose(changes) : changes);
    this.isOpen = true;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.sendAndSay(), PAUSE);
  }

  private async sendAndSay(): Promise<void> {
    const { store, document } = this;
    if (!store.documents.includes(document)) return;
    if (await store.attempt(() => this.send())) return;
    // the text has a character that the encoding lacks; it stays as it was typed
    if (document.state.encoding === "UTF-8" || !store.notice) return;
    store.notice.actions = [{ label: "Write the file in UTF-8", make: () => void this.encode().then(() => this.sendAndSay()) }];
  }

  /** Before what was typed, which the encoding lacks. */
  private async encode(): Promise<void> {
    const { store, document } = this;
    await store.attempt(() => store.enqueue(async () => void (document.state = await ask<State>({ do: "encode", document: document.id, encoding: "UTF-8" }))));
  }

  /** Sends what was typed so far, behind all that was asked for before. */
  async send(): Promise<void> {
    clearTimeout(this.timer);
    this.isOpen = false;
    for (; this.queued < this.steps.length; this.queued++) this.sent = this.store.enqueue(() => this.sendFirst());
    await this.sent;
  }

  private async sendFirst(): Promise<void> {
    const { document, store } = this;
    this.follow();
    const [sent] = this.steps;
    if (!sent || this.queued === 0) return;
    const lineEnd = /\r\n|\r|\n/.exec(document.state.text)?.[0] ?? "\n";
    try {
      document.state = await ask<State>({ do: "edit", document: document.id, revision: this.revision, edits: editsOf(sent, this.known, lineEnd) });
    } catch (error) {
      // it stays in the text, and is sent again with what is typed next
      this.steps = [this.steps.reduce((all, step) => all.compose(step))];
      [this.isOpen, this.queued] = [true, 0];
      throw error;
    }
    this.steps.shift();
    this.queued--;
    this.known = sent.apply(this.known);
    this.revision = document.state.revision;
    store.notice = undefined;
    void store.attempt(() => store.refresh(document));
  }

  /** Takes over what the engine changed, and leaves what was typed, the rest of the text and the cursor where they are. */
  private follow(): void {
    const { text, revision } = this.document.state;
    if (revision === this.revision) return;
    const now = this.state.toText(text);
    let changes = differenceOf(this.known, now);
    [this.known, this.revision] = [now, revision];
    if (changes.empty) return;
    this.steps = this.steps.map((step) => {
      const moved = step.map(changes, true);
      changes = changes.map(step);
      return moved;
    });
    const spec = { changes, annotations: fromEngine.of(true) };
    if (this.view) this.view.dispatch(spec);
    else this.state = this.state.update(spec).state;
  }

  draw(): void {
    this.follow();
    const view = this.view!;
    if (this.steps.length > 0) return;
    view.dispatch(setDiagnostics(view.state, diagnosticsOf(this.document, view.state.doc)));
    if (this.coloured === this.revision) return;
    this.coloured = this.revision;
    void colour(view, this.asker).catch(() => {});
  }
}

class Editor {
  private readonly view: EditorView;
  private texts: EditedText[] = [];
  private shown: EditedText | undefined;

  constructor(
    private readonly store: Store,
    parent: HTMLElement,
  ) {
    this.view = new EditorView({ parent });
    store.sendTyped = async () => {
      const texts = this.texts.filter(({ document }) => store.documents.includes(document));
      await Promise.all(texts.map((text) => text.send()));
    };
  }

  draw(): void {
    const { current, documents } = this.store;
    this.texts = this.texts.filter(({ document }) => documents.includes(document));
    if (!current) return;
    if (this.shown?.document !== current) {
      this.shown?.leave();
      this.shown = this.texts.find(({ document }) => document === current) ?? new EditedText(this.store, current);
      if (!this.texts.includes(this.shown)) this.texts.push(this.shown);
      this.shown.show(this.view);
    }
    this.shown.draw();
  }

  goTo(line: number): void {
    const { doc } = this.view.state;
    const { from } = doc.line(Math.min(Math.max(1, line), doc.lines));
    this.view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
  }
}

export function textView(store: Store): HTMLElement {
  const element = h("div", { class: "text" });
  let editor: Editor | undefined;
  let shown: number | undefined;
  store.onDraw(() => {
    element.hidden = store.view !== "text";
    if (element.hidden || !store.current) return;
    editor ??= new Editor(store, element);
    editor.draw();
    if (store.index !== shown) {
      shown = store.index;
      const line = store.current.outline.objects.find((object) => object.index === shown)?.line;
      if (line) editor.goTo(line);
    }
  });
  document.addEventListener("go-to-line", (event) => editor?.goTo((event as CustomEvent<number>).detail));
  return element;
}

/** What was changed since the file was opened. */
export function diffView(store: Store): HTMLElement {
  const element = h("div", { class: "text diff" });
  let view: EditorView | undefined;
  let drawn: string[] = [];
  store.onDraw(() => {
    element.hidden = store.view !== "diff";
    if (element.hidden || !store.current) return;
    const { original, state } = store.current;
    // the same changes stay as they were scrolled and opened
    if (drawn[0] === original && drawn[1] === state.text) return;
    drawn = [original, state.text];
    view?.destroy();
    element.replaceChildren();
    if (original === state.text) return element.append(h("p", { class: "nothing" }, "Nothing was changed."));
    view = new EditorView({
      parent: element,
      state: EditorState.create({
        doc: state.text,
        extensions: [
          lineNumbers(),
          EditorState.readOnly.of(true),
          EditorView.editable.of(false),
          EditorView.contentAttributes.of({ "aria-label": "Changes", tabindex: "0" }),
          unifiedMergeView({ original, mergeControls: false, collapseUnchanged: { margin: 3, minSize: 6 } }),
        ],
      }),
    });
  });
  return element;
}
