// Middle: what changes from another open file to this one, and what that means for whom.

import { ask } from "./engine";
import { addressText, h, indexText, redraw } from "./dom";
import { table } from "./network";
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
    if (store.compared === undefined) return redraw(view, h("p", { class: "nothing" }, "Open a second file to compare it with this one."));
    const number = ++asked;
    const old = store.compared;
    if (!view.hasChildNodes()) redraw(view, h("p", { class: "nothing" }, "Comparing …"));
    const changes = await store.inTurn(() => ask<Change[]>({ do: "compare", old, new: current.id }));
    if (number !== asked) return;
    const choose = ({ currentTarget }: Event) => ((store.compared = Number((currentTarget as HTMLSelectElement).value)), store.draw());
    const choice = h("select", { onchange: choose }, ...others.map((other) => h("option", { value: other.id, selected: other.id === old }, other.state.name)));
    const where = ({ index, sub }: Change) => (index == null ? "" : sub == null ? indexText(index) : addressText(index, sub));
    const rows = changes.map((change) => [h("span", { class: `verdict ${change.verdict}` }, change.verdict), h("span", { class: "address" }, where(change)), change.message, h("span", { class: "meaning" }, change.effects.map((effect) => `${effect.audience}: ${effect.reason}`).join(" "))]);
    const changed = changes.length === 0 ? h("p", { class: "nothing" }, "Both describe the same device.") : table(["Verdict", "Where", "Change", "For whom"], rows, "Changes");
    redraw(view, h("label", {}, "From ", choice, ` to ${current.state.name}`), changed);
  });
  return view;
}
