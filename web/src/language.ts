// Colours, help and completion in the text: the engine answers as the language server does.

import { autocompletion, completionKeymap, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { RangeSetBuilder, StateEffect, StateField, type Extension, type Text } from "@codemirror/state";
import { Decoration, EditorView, hoverTooltip, keymap, type DecorationSet } from "@codemirror/view";
import { h, prose } from "./dom";
import type { Completion, Hover, LanguageQuestion, Place, Tokens } from "./protocol";

/** Larger texts have no colours. */
const MAX_COLOURED = 2_000_000;

const setColours = StateEffect.define<DecorationSet>();

const colours = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update: (known, { changes, effects }) => effects.find((effect) => effect.is(setColours))?.value ?? known.map(changes),
  provide: (field) => EditorView.decorations.from(field),
});

/** What asks about the document whose text is shown, once the engine has all of it. */
export type Asker = <T>(about: LanguageQuestion) => Promise<T>;

/** Markdown of the language server as elements: paragraphs, rules and code. */
const markdown = (text: string): HTMLElement =>
  h("div", { class: "help-text" }, ...text.split(/\n{2,}/).map((paragraph) => (/^-{3,}$/.test(paragraph.trim()) ? h("hr") : h("p", {}, ...prose(paragraph.replaceAll("**", ""))))));

/** The colours of a text; nothing if it was changed meanwhile. */
export async function colour(view: EditorView, asker: Asker): Promise<void> {
  const { doc } = view.state;
  if (doc.length > MAX_COLOURED) return;
  const { kinds, tokens } = await asker<Tokens>({ ask: "tokens" });
  if (view.state.doc !== doc || !tokens) return;
  const builder = new RangeSetBuilder<Decoration>();
  let [line, start] = [0, 0];
  const { data } = tokens;
  for (let at = 0; at < data.length; at += 5) {
    start = data[at] === 0 ? start + data[at + 1]! : data[at + 1]!;
    line += data[at]!;
    if (line >= doc.lines) break;
    const { from, to } = doc.line(line + 1);
    const [first, last] = [from + start, Math.min(to, from + start + data[at + 2]!)];
    if (first < last) builder.add(first, last, Decoration.mark({ class: `token-${kinds[data[at + 3]!]}` }));
  }
  view.dispatch({ effects: setColours.of(builder.finish()) });
}

const positionOf = (doc: Text, at: number): Place => {
  const line = doc.lineAt(at);
  return { line: line.number - 1, character: at - line.from };
};

const offsetOf = (doc: Text, { line, character }: Place): number => {
  const { from, to } = doc.line(Math.min(line + 1, doc.lines));
  return Math.min(to, from + character);
};

export function languageOf(asker: Asker): Extension[] {
  const hover = hoverTooltip(async (view, at) => {
    const found = await asker<Hover | null>({ ask: "hover", ...positionOf(view.state.doc, at) }).catch(() => null);
    return found && { pos: at, create: () => ({ dom: markdown(found.contents.value) }) };
  });
  const complete = async ({ pos, state }: CompletionContext): Promise<CompletionResult | null> => {
    const items = await asker<Completion[] | null>({ ask: "completion", ...positionOf(state.doc, pos) });
    const first = items?.[0]?.textEdit?.range;
    if (!items || !first) return null;
    const options = items.map(({ label, detail, documentation, textEdit }) => ({ label, detail, info: documentation && (() => markdown(documentation.value)), apply: textEdit?.newText ?? label }));
    return { from: offsetOf(state.doc, first.start), to: offsetOf(state.doc, first.end), options, filter: offsetOf(state.doc, first.start) < pos };
  };
  return [colours, hover, autocompletion({ override: [complete], activateOnTyping: false }), keymap.of(completionKeymap)];
}
