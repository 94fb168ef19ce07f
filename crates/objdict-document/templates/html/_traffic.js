"use strict";
(() => {
  const main = document.getElementById("drawings"), moment = document.getElementById("moment");
  const all = selector => [...main.querySelectorAll(selector)];
  const [start, length, zero] = ["start", "length", "zero"].map(key => BigInt(main.dataset[key]));
  // seconds from the first frame on
  const low = Number(start - zero) / 1e9, whole = Number(length) / 1e9;
  let view = [low, low + whole], cursor = null;

  const areas = all(".area").map(area => {
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    line.setAttribute("class", "cursor");
    line.setAttribute("y2", "100%");
    line.setAttribute("visibility", "hidden");
    area.append(line);
    return { area, line, zoom: area.querySelector(".zoom"), height: area.getAttribute("height") };
  });
  const marks = all(".mark").map(mark => ({ mark, time: +mark.dataset.time, text: mark.querySelector("title").textContent }));
  // what is not shown has no width
  document.body.classList.add("live");
  const words = all(".word").map(word => ({ word, from: +word.dataset.from, to: +word.dataset.to, width: word.getComputedTextLength() }));
  const rows = text => (text ? text.split(";").map(row => row.split(" ")) : []);
  const plots = all(".plot").map(figure => {
    const { points, states } = figure.querySelector(".area").dataset;
    const names = [...figure.querySelectorAll(".words span")].map(name => name.textContent);
    const unit = figure.querySelector("small")?.textContent ?? "";
    const value = ([, last, min, max]) => [max === undefined ? last : `${last} (${min} to ${max})`, unit].join(" ").trim();
    const state = ([, ...own]) => own.map(at => names[at]).join(", ");
    return { output: figure.querySelector("output"), rows: rows(points ?? states), words: states === undefined ? value : state };
  });

  const percent = time => `${((time - view[0]) / (view[1] - view[0])) * 100}%`;
  // the time as the log has it, to the microsecond
  const shown = time => {
    const micro = (zero + BigInt(Math.round(time * 1e9))) / 1000n, size = micro < 0n ? -micro : micro;
    return `${micro < 0n ? "-" : ""}${size / 1000000n}.${String(size % 1000000n).padStart(6, "0")}`;
  };
  const moveTo = time => {
    cursor = Math.min(Math.max(time, low), low + whole);
    for (const { line } of areas) {
      line.setAttribute("x1", percent(cursor));
      line.setAttribute("x2", percent(cursor));
      line.setAttribute("visibility", "visible");
    }
    for (const plot of plots) {
      const row = plot.rows.findLast(([from]) => +from <= cursor);
      plot.output.textContent = row ? plot.words(row) : "";
    }
    const near = (view[1] - view[0]) / 100;
    const event = marks.filter(({ time: at }) => Math.abs(at - cursor) < near).sort((a, b) => Math.abs(a.time - cursor) - Math.abs(b.time - cursor))[0];
    moment.textContent = shown(cursor) + (event ? `, near ${event.text}` : "");
  };

  const step = least => {
    const power = 10 ** Math.floor(Math.log10(least));
    return [1, 2, 5, 10].map(factor => factor * power).find(found => found >= least) ?? 10 * power;
  };
  const ticks = () => {
    const [from, to] = view, size = to - from;
    const [unit, factor] = size >= 2 ? ["s", 1] : size >= 2e-3 ? ["ms", 1e3] : ["µs", 1e6];
    for (const axis of all(".ticks")) {
      const room = Math.max(2, Math.floor(axis.clientWidth / 110));
      const each = step((size * factor) / room), decimals = Math.min(9, Math.max(0, -Math.floor(Math.log10(each))));
      axis.replaceChildren();
      for (let number = Math.ceil((from * factor) / each); number * each <= to * factor; number++) {
        const text = document.createElementNS("http://www.w3.org/2000/svg", "text");
        text.setAttribute("x", percent((number * each) / factor));
        text.setAttribute("y", "16");
        text.textContent = `${(number * each).toFixed(decimals)} ${unit}`;
        axis.append(text);
      }
    }
  };
  const draw = () => {
    const [left, right] = view.map(time => ((time - low) / whole) * 1000);
    for (const { zoom, height } of areas) zoom.setAttribute("viewBox", `${left} 0 ${right - left} ${height}`);
    for (const { mark, time } of marks) mark.setAttribute("x", percent(time));
    for (const { word, from, to, width } of words) {
      const [a, b] = [Math.max(from, left), Math.min(to, right)];
      const room = ((b - a) / (right - left)) * word.ownerSVGElement.clientWidth;
      word.setAttribute("x", `${(((a + b) / 2 - left) / (right - left)) * 100}%`);
      word.setAttribute("visibility", room > width + 8 ? "visible" : "hidden");
    }
    ticks();
    if (cursor !== null) moveTo(cursor);
  };
  const show = (from, to) => {
    // a hundred nanoseconds are less than any log distinguishes
    const size = Math.min(Math.max(to - from, 1e-7), whole);
    const first = Math.min(Math.max(from, low), low + whole - size);
    view = [first, first + size];
    draw();
  };
  const scale = (factor, around = cursor ?? (view[0] + view[1]) / 2) =>
    show(around - (around - view[0]) * factor, around + (view[1] - around) * factor);

  const timeAt = event => {
    const { left, width } = event.currentTarget.getBoundingClientRect();
    return view[0] + ((event.clientX - left) / width) * (view[1] - view[0]);
  };
  for (const { area } of areas) {
    let begin = null, box = null;
    const end = () => { begin = null; box?.remove(); box = null; };
    area.addEventListener("pointerdown", event => {
      if (event.button) return;
      begin = timeAt(event);
      area.setPointerCapture(event.pointerId);
    });
    area.addEventListener("pointermove", event => {
      const time = timeAt(event);
      moveTo(time);
      if (begin === null) return;
      box ??= area.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "rect"));
      box.setAttribute("class", "drag");
      box.setAttribute("height", "100%");
      box.setAttribute("x", percent(Math.min(begin, time)));
      box.setAttribute("width", `${(Math.abs(time - begin) / (view[1] - view[0])) * 100}%`);
    });
    area.addEventListener("pointerup", event => {
      const time = timeAt(event), from = begin;
      const isDrag = box !== null && Math.abs(time - from) > (view[1] - view[0]) / 100;
      end();
      if (isDrag) show(Math.min(from, time), Math.max(from, time));
    });
    area.addEventListener("pointercancel", end);
    // the wheel alone scrolls the page
    area.addEventListener("wheel", event => {
      if (!event.ctrlKey && !event.shiftKey) return;
      event.preventDefault();
      scale((event.deltaY || event.deltaX) > 0 ? 1.25 : 0.8, timeAt(event));
    }, { passive: false });
  }
  const keys = {
    "+": () => scale(0.5), "=": () => scale(0.5), "-": () => scale(2), 0: () => show(low, low + whole),
    ArrowLeft: step => moveBy(-step), ArrowRight: step => moveBy(step),
  };
  const moveBy = part => {
    const size = view[1] - view[0];
    moveTo((cursor ?? view[0]) + size * part);
    if (cursor < view[0] || cursor > view[1]) show(cursor - size / 2, cursor + size / 2);
  };
  addEventListener("keydown", event => {
    const isFree = !event.ctrlKey && !event.metaKey && !event.altKey && !event.target.closest?.("input, select, textarea");
    if (!isFree || !Object.hasOwn(keys, event.key)) return;
    event.preventDefault();
    keys[event.key](event.shiftKey ? 0.1 : 0.01);
  });
  const on = (id, act) => document.getElementById(id).addEventListener("click", act);
  on("in", keys["+"]);
  on("out", keys["-"]);
  on("all", keys[0]);
  // a link to a moment shows it in the middle
  const target = () => {
    const found = marks.find(({ mark }) => `#${mark.id}` === location.hash);
    if (!found) return;
    const size = view[1] - view[0];
    show(found.time - size / 2, found.time + size / 2);
    moveTo(found.time);
  };
  addEventListener("hashchange", target);
  addEventListener("resize", draw);

  const choice = document.getElementById("shown");
  for (const figure of all(".plot")) {
    const label = document.createElement("label"), box = document.createElement("input");
    Object.assign(box, { type: "checkbox", checked: true });
    box.addEventListener("change", () => { figure.hidden = !box.checked; draw(); });
    label.append(box, " ", figure.querySelector("figcaption").firstChild.textContent.trim());
    choice?.append(label);
  }
  if (choice) choice.hidden = false;
  document.getElementById("tools").hidden = false;
  draw();
  target();
})();
