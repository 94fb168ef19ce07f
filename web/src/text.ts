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

class Editor {
  readonly view: EditorView;
  private document: OpenDocument | undefined;
  /** The lines that the engine has. */
  private known: Text;
  private pending: ChangeSet | undefined;
  private timer = 0;
  private isAsking = false;

  constructor(
    private store: Store,
    parent: HTMLElement,
  ) {
    this.view = new EditorView({ parent, state: this.stateOf("", false) });
    this.known = this.view.state.doc;
  }

  private stateOf(text: string, readOnly: boolean): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        highlightActiveLine(),
        drawSelection(),
        search({ top: true }),
        keymap.of([...defaultKeymap, ...searchKeymap]),
        EditorState.readOnly.of(readOnly),
        EditorView.contentAttributes.of({ "aria-label": "Text of the file", spellcheck: "false", tabindex: "0" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged && !update.transactions.some((transaction) => transaction.annotation(fromEngine))) this.typed(update.changes);
        }),
      ],
    });
  }

  private typed(changes: ChangeSet): void {
    this.pending = this.pending ? this.pending.compose(changes) : changes;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.send(), PAUSE);
  }

  /** Gives what was typed to the engine; what is typed meanwhile waits. */
  private async send(): Promise<void> {
    const { document, pending, store } = this;
    if (this.isAsking || !pending || !document) return;
    const lineEnd = /\r\n|\r|\n/.exec(document.state.text)?.[0] ?? "\n";
    this.isAsking = true;
    this.pending = undefined;
    const edits = editsOf(pending, this.known, lineEnd);
    const after = pending.apply(this.known);
    await store.attempt(async () => {
      const state = await ask<State>({ do: "edit", document: document.id, edits });
      this.known = after;
      store.notice = undefined;
      await store.refresh(document, state);
    });
    this.isAsking = false;
    if (this.pending) void this.send();
  }

  draw(): void {
    const document = this.store.current;
    if (!document) return;
    if (document !== this.document) {
      this.document = document;
      this.pending = undefined;
      this.view.setState(this.stateOf(document.state.text, document.state.is_read_only));
      this.known = this.view.state.doc;
    } else if (!this.pending && !this.isAsking) {
      this.follow(document.state.text);
    }
    if (!this.pending) this.view.dispatch(setDiagnostics(this.view.state, diagnosticsOf(document, this.view.state.doc)));
  }

  /** Takes over what the engine changed, and leaves the rest of the text and the cursor where they are. */
  private follow(text: string): void {
    const now = this.view.state.doc;
    const wanted = this.view.state.toText(text);
    if (!now.eq(wanted)) {
      const [old, next] = [now.toString(), wanted.toString()];
      let start = 0;
      while (start < old.length && start < next.length && old[start] === next[start]) start++;
      let end = 0;
      while (end < old.length - start && end < next.length - start && old[old.length - 1 - end] === next[next.length - 1 - end]) end++;
      const changes = { from: start, to: old.length - end, insert: next.slice(start, next.length - end) };
      this.view.dispatch({ changes, annotations: fromEngine.of(true) });
    }
    this.known = this.view.state.doc;
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
  store.onDraw(() => {
    element.hidden = store.view !== "diff";
    view?.destroy();
    view = undefined;
    element.replaceChildren();
    if (element.hidden || !store.current) return;
    const { original, state } = store.current;
    if (original === state.text) {
      element.append(h("p", { class: "nothing" }, "Nothing was changed."));
      return;
    }
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
