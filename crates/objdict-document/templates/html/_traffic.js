"use strict";
for (const bus of document.querySelectorAll(".bus")) {
  const from = +bus.dataset.from, length = +bus.dataset.length;
  const steer = bus.querySelector(".steer"), shown = steer.querySelector("output");
  const drawings = [...bus.querySelectorAll("svg.time")];
  const part = text => parseFloat(text) / 100;
  // texts and marks, which are not stretched, with where they were
  const placed = drawings.flatMap(drawing => [...drawing.children].flatMap(element => {
    const name = element.tagName === "circle" ? "cx" : "x";
    const at = element.getAttribute(name) ?? "";
    return at.endsWith("%") && element.tagName !== "svg" ? [{ element, name, at: part(at), end: part(element.dataset.end) }] : [];
  }));
  const svg = (name, attributes) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
  };
  const cursors = drawings.map(drawing => drawing.appendChild(svg("line", { class: "cursor", y1: 0, y2: "100%", visibility: "hidden" })));
  const chosen = drawings.map(drawing => drawing.appendChild(svg("rect", { fill: "currentColor", "fill-opacity": .15, y: 0, height: "100%", width: 0 })));
  const spelled = (seconds, step) => `${seconds.toFixed(Math.min(9, Math.max(0, Math.ceil(-Math.log10(step)))))} s`;
  let view = [0, 1];

  const ticks = () => {
    const [start, end] = view, span = (end - start) * length;
    const least = span / 5, magnitude = 10 ** Math.floor(Math.log10(least));
    const step = [1, 2, 5, 10].map(n => n * magnitude).find(n => n >= least);
    const axis = bus.querySelector(".axis"), texts = axis.querySelector(".ticks"), lines = axis.querySelector(".grid");
    texts.replaceChildren();
    lines.replaceChildren();
    for (let n = Math.ceil((from + start * length) / step); n * step <= from + end * length; n++) {
      const x = `${((n * step - from) / length - start) / (end - start) * 100}%`;
      const text = texts.appendChild(svg("text", { class: "dim", x, dx: 3, y: 14 }));
      text.textContent = spelled(n * step, step);
      lines.append(svg("line", { x1: x, x2: x, y1: 0, y2: 20 }));
    }
    shown.textContent = `${spelled(from + start * length, step)} to ${spelled(from + end * length, step)}`;
  };
  const show = (start, end) => {
    const span = Math.min(1, Math.max(end - start, 1e-6));
    start = Math.min(Math.max(start, 0), 1 - span);
    view = [start, start + span];
    for (const stretched of bus.querySelectorAll(".stretched")) {
      stretched.setAttribute("viewBox", `${start * 1000} 0 ${span * 1000} ${stretched.getAttribute("height")}`);
    }
    const at = x => (x - start) / span;
    const width = drawings[0].clientWidth || 1000;
    for (const { element, name, at: x, end } of placed) {
      // a word stays where a part of what it is for is shown
      const left = Number.isNaN(end) ? at(x) : Math.max(at(x), 0);
      element.setAttribute(name, `${left * 100}%`);
      const hasPlace = Number.isNaN(end) || (Math.min(at(end), 1) - left) * width > element.textContent.length * 7 + 8;
      element.classList.toggle("small", left < -.01 || left > 1.01 || !hasPlace);
    }
    ticks();
  };

  // what a drawing has at a position
  const read = new Map();
  const valueAt = (drawing, x) => {
    if (!read.has(drawing)) {
      const numbers = drawing.dataset.points?.trim().split(" ");
      const bands = [...drawing.querySelectorAll(".band")].map(band => [+band.getAttribute("x"), band.textContent]);
      const pairs = (numbers ?? []).flatMap((text, n) => n % 2 ? [[+numbers[n - 1], text]] : []);
      read.set(drawing, numbers ? pairs : bands);
    }
    return read.get(drawing).findLast(([start]) => start <= x * 1000)?.[1] ?? "";
  };
  const position = event => {
    const box = event.currentTarget.getBoundingClientRect();
    return view[0] + (event.clientX - box.left) / box.width * (view[1] - view[0]);
  };
  const point = x => {
    const at = `${(x - view[0]) / (view[1] - view[0]) * 100}%`;
    for (const cursor of cursors) {
      cursor.setAttribute("x1", at);
      cursor.setAttribute("x2", at);
      cursor.setAttribute("visibility", "visible");
    }
    shown.textContent = spelled(from + x * length, (view[1] - view[0]) * length / 1000);
    for (const plot of bus.querySelectorAll(".timed")) plot.querySelector("output").textContent = valueAt(plot.querySelector("svg.time"), x);
  };
  const mark = (start, end) => {
    for (const rect of chosen) {
      rect.setAttribute("x", `${(Math.min(start, end) - view[0]) / (view[1] - view[0]) * 100}%`);
      rect.setAttribute("width", `${Math.abs(end - start) / (view[1] - view[0]) * 100}%`);
    }
  };
  const step = name => {
    const [start, end] = view, span = end - start, middle = (start + end) / 2;
    const steps = { in: [middle - span / 4, middle + span / 4], out: [middle - span, middle + span], left: [start - span / 4, end - span / 4], right: [start + span / 4, end + span / 4], all: [0, 1] };
    show(...steps[name]);
  };

  let begun = null;
  for (const drawing of drawings) {
    drawing.addEventListener("pointermove", event => {
      const x = position(event);
      point(x);
      if (begun !== null) mark(begun, x);
    });
    drawing.addEventListener("pointerdown", event => {
      begun = position(event);
      drawing.setPointerCapture(event.pointerId);
    });
    drawing.addEventListener("pointerup", event => {
      const start = begun, end = position(event);
      begun = null;
      mark(0, 0);
      if (start !== null && Math.abs(end - start) > (view[1] - view[0]) / 200) show(Math.min(start, end), Math.max(start, end));
    });
    drawing.addEventListener("pointercancel", () => {
      begun = null;
      mark(0, 0);
    });
    drawing.addEventListener("dblclick", () => step("all"));
  }
  steer.hidden = false;
  steer.addEventListener("click", event => event.target.dataset.step && step(event.target.dataset.step));
  steer.addEventListener("keydown", event => {
    const name = { "+": "in", "-": "out", ArrowLeft: "left", ArrowRight: "right", 0: "all" }[event.key];
    if (name) {
      event.preventDefault();
      step(name);
    }
  });
  addEventListener("resize", () => show(...view));
  show(0, 1);
}
