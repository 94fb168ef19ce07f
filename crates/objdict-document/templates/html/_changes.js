"use strict";
(() => {
  const byId = id => document.getElementById(id);
  const verdict = byId("verdict"), audience = byId("audience"), hits = byId("hits");
  const changes = [...document.querySelectorAll(".change")];
  byId("tools").hidden = false;

  // with an audience, the verdict is the one for it
  const isMeant = ({ verdict: worst, effects }) => {
    const own = Object.fromEntries(effects.split(" ").filter(Boolean).map(effect => effect.split("=")));
    const found = audience.value ? own[audience.value] : worst;
    return found !== undefined && (!verdict.value || found === verdict.value);
  };
  const apply = () => {
    const shown = changes.filter(change => !(change.hidden = !isMeant(change.dataset))).length;
    hits.textContent = shown === changes.length ? "" : `${shown} / ${changes.length}`;
  };
  verdict.addEventListener("change", apply);
  audience.addEventListener("change", apply);
})();
