(() => {
  const parse = text => {
    const parts = text.match(/[\d.]+/g)?.map(Number) ?? [0, 0, 0, 0];
    return parts.length < 4 ? [...parts, 1] : parts;
  };
  const over = (front, back) => [0, 1, 2].map(at => front[at] * front[3] + back[at] * (1 - front[3]));
  const luminance = colour => {
    const linear = colour.slice(0, 3).map(part => {
      const value = part / 255;
      return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  };
  const ratio = (one, other) => {
    const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  };
  // the boxes behind an element, the nearest first
  const ground = element => {
    const layers = [];
    for (let at = element; at; at = at.parentElement) {
      if (at instanceof SVGElement && !(at instanceof SVGSVGElement)) continue;
      layers.push(parse(getComputedStyle(at).backgroundColor));
    }
    const canvas = matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18] : [255, 255, 255];
    return layers.reverse().reduce((back, layer) => over(layer, back), canvas);
  };
  // of a text in a drawing: the shape that was drawn below its middle last
  const shape = text => {
    const box = text.getBoundingClientRect(), x = box.x + box.width / 2, y = box.y + box.height / 2;
    const svg = text.ownerSVGElement, back = ground(svg);
    const below = [...svg.querySelectorAll("rect, path, circle")].filter(of => {
      const at = of.getBoundingClientRect();
      return of.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING && !of.closest("defs")
        && at.left <= x && x <= at.right && at.top <= y && y <= at.bottom;
    });
    return below.reduce((colour, of) => {
      const style = getComputedStyle(of);
      if (!style.fill.startsWith("rgb")) return colour;
      const fill = parse(style.fill);
      fill[3] *= Number(style.fillOpacity) * Number(style.opacity);
      return over(fill, colour);
    }, back);
  };
  const weak = new Set();
  for (const element of document.body.querySelectorAll("*")) {
    const text = [...element.childNodes].filter(of => of.nodeType === Node.TEXT_NODE).map(of => of.data).join("").trim();
    if (!text || ["SCRIPT", "STYLE", "TITLE", "title", "desc"].includes(element.tagName) || !element.checkVisibility({ visibilityProperty: true })) continue;
    const style = getComputedStyle(element), drawn = element.closest("svg") !== null;
    const back = drawn ? shape(element) : ground(element);
    const colour = over(parse(drawn ? style.fill : style.color), back);
    const size = parseFloat(style.fontSize), large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    const found = ratio(colour, back);
    if (found < (large ? 3 : 4.5)) {
      weak.add(`${found.toFixed(2)} ${element.tagName} ${style.color} on ${back.map(Math.round)}: ${text.slice(0, 40)}`);
    }
  }
  return [...weak].slice(0, 10);
})()
