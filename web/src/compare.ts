// Middle: what changes from another open file to this one, and what that means for whom.

import { ask } from "./engine";
import { h, hex } from "./dom";
import type { Change } from "./protocol";
import type { Store } from "./store";

export function compareView(store: Store): HTMLElement {
  const view = h("div", { class: "compare scroll" });
  let asked = 0;
  store.onDraw(async () => {
    view.hidden = store.view !== "compare";
    const { current } = store;
    if (view.hidden || !current) return;
    const others = store.documents.filter((other) => other !== current && other.state.kind === "device");
    if (!others.some((other) => other.id === store.compared)) store.compared = others[0]?.id;
    if (store.compared === undefined) {
      view.replaceChildren(h("p", { class: "nothing" }, "Open a second file to compare it with this one."));
      return;
    }
    const number = ++asked;
    const old = store.compared;
    const changes = await store.inTurn(() => ask<Change[]>({ do: "compare", old, new: current.id }));
    if (number !== asked) return;
    const choice = h(
      "select",
      {
        onchange: () => {
          store.compared = Number(choice.value);
          store.draw();
        },
      },
      ...others.map((other) => h("option", { value: other.id, selected: other.id === old }, other.state.name)),
    );
    const where = (change: Change) => (change.index == null ? "" : `${hex(change.index, 4)}h${change.sub == null ? "" : `:${hex(change.sub, 2)}`}`);
    const row = (change: Change) =>
      h(
        "tr",
        {},
        h("td", { class: `verdict ${change.verdict}` }, change.verdict),
        h("td", { class: "address" }, where(change)),
        h("td", {}, change.message),
        h("td", { class: "meaning" }, change.effects.map((effect) => `${effect.audience}: ${effect.reason}`).join(" ")),
      );
    const head = h("tr", {}, ...["Verdict", "Where", "Change", "For whom"].map((title) => h("th", { scope: "col" }, title)));
    view.replaceChildren(
      h("h2", {}, "Changes"),
      h("label", {}, "From ", choice, ` to ${current.state.name}`),
      changes.length === 0 ? h("p", { class: "nothing" }, "Both describe the same device.") : h("table", {}, h("thead", {}, head), h("tbody", {}, ...changes.map(row))),
    );
  });
  return view;
}
