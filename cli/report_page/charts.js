// Histograms of distortion whose bars carry the colors of the scale, the legend beside the views, and the table.

import {cssColor, ticksOf} from "./colors.js";

export function element(name, attributes = {}, ...children) {
  const svg = ["svg", "rect", "line", "text", "g", "polyline"].includes(name);
  const node = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

export const percent = part => `${(100 * part).toLocaleString("en", {maximumSignificantDigits: 3})} %`;
export const figure = octaves => (2 ** octaves).toLocaleString("en", {maximumSignificantDigits: 3});

// Shares of area in bins of equal width over the range; what lies beyond it counts in the first and last bin.
function binned(quantity, result, range, count) {
  const [low, high] = quantity.bounds(range), share = quantity.share(result);
  const bins = new Array(count).fill(0);
  const place = octaves => Math.min(count, Math.max(0, (octaves - low) / (high - low) * count));
  for (let level = 0; level < 256; ++level) {
    if (level === quantity.noLevel || share[level] === 0) continue;
    const [start, end] = [level - 0.5, level + 0.5].map(edge => place(quantity.octaves(edge)));
    if (end - start < 1e-9) {
      bins[Math.min(count - 1, Math.floor(start))] += share[level];
      continue;
    }
    for (let bin = Math.floor(start); bin < end; ++bin) {
      bins[bin] += share[level] * (Math.min(end, bin + 1) - Math.max(start, bin)) / (end - start);
    }
  }
  return bins;
}

function sentenceOf(quantity, result) {
  const at = part => figure(quantile(quantity, result, part));
  const none = quantity.share(result)[quantity.noLevel];
  const without = none > 0.0005 ? ` ${percent(none)} of the area has no value.` : "";
  if (quantity.bounds(2)[0] === 0) {
    return `Half of the shape's area has at most ${at(0.5)}, 95 % at most ${at(0.95)}, 99 % at most ${at(0.99)}.` + without;
  }
  return `Median ${at(0.5)}; 90 % of the shape's area is between ${at(0.05)} and ${at(0.95)}.` + without;
}

export function drawChart(holder, quantity, result, range) {
  const width = Math.min(640, Math.max(280, holder.clientWidth)), height = 170, base = 140, top = 10, count = 52;
  const [low, high] = quantity.bounds(range);
  const bins = binned(quantity, result, range, count), most = Math.max(...bins, 1e-12);
  const sentence = sentenceOf(quantity, result);
  const svg = element("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img",
                              "aria-label": `Histogram of ${quantity.title.toLowerCase()}. ${sentence}`});
  const left = 20, span = width - 2 * left;
  bins.forEach((bin, i) => {
    const size = bin / most * (base - top);
    const bar = element("rect", {class: "bar", x: left + i / count * span, width: span / count - 0.8, y: base - size,
                                 height: size, fill: cssColor(quantity.colors[Math.round((i + 0.5) / count * 255)])});
    const ends = [i, i + 1].map(edge => figure(low + edge / count * (high - low)));
    const beyond = i === count - 1 ? `${ends[0]} and more` : `${ends[0]} to ${ends[1]}`;
    const title = document.createElementNS("http://www.w3.org/2000/svg", "title");
    title.textContent = `${i === 0 && low < 0 ? `${ends[1]} and less` : beyond}: ${percent(bin)} of the area`;
    bar.append(title);
    svg.append(bar);
  });
  svg.append(element("line", {class: "axis", x1: left, x2: width - left, y1: base + 0.5, y2: base + 0.5}));
  const placeOf = octaves => left + (octaves - low) / (high - low) * span;
  for (const tick of ticksOf(quantity, range)) {
    const x = placeOf(tick.octaves);
    svg.append(element("line", {class: "axis", x1: x, x2: x, y1: base, y2: base + 5}));
    svg.append(element("text", {x, y: base + 19, "text-anchor": "middle"}, tick.text));
  }
  const median = Math.min(high, Math.max(low, quantile(quantity, result, 0.5)));
  svg.append(element("line", {class: "median", x1: placeOf(median), x2: placeOf(median), y1: top - 4, y2: base}));
  svg.append(element("text", {x: placeOf(median) + (median > (low + high) / 2 ? -5 : 5), y: top + 5,
                              "text-anchor": median > (low + high) / 2 ? "end" : "start"}, "median"));
  holder.replaceChildren(svg, element("p", {class: "chart-text"}, sentence));
}

// Energies of an optimization by iteration, on a scale from the minimum to the maximum.
export function drawCurve(holder, card, energies) {
  card.hidden = energies.length < 2;
  if (card.hidden) return;
  const width = Math.min(640, Math.max(280, holder.clientWidth)), height = 170, base = 140, top = 14, left = 64, right = 20;
  const low = Math.min(...energies), high = Math.max(...energies), last = energies.length - 1;
  const text = value => value.toLocaleString("en", {maximumSignificantDigits: 6});
  const x = i => left + i / last * (width - left - right);
  const y = value => base - (high > low ? (value - low) / (high - low) : 0) * (base - top);
  const sentence = `From ${text(energies[0])} to ${text(energies[last])} in ${last} iterations.`;
  const svg = element("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img",
                              "aria-label": `Curve of the energy. ${sentence}`});
  svg.append(element("line", {class: "axis", x1: left, x2: width - right, y1: base + 0.5, y2: base + 0.5}));
  for (const value of high > low ? [low, high] : [low]) {
    svg.append(element("line", {class: "axis", x1: left - 5, x2: left, y1: y(value), y2: y(value)}));
    svg.append(element("text", {x: left - 8, y: y(value) + 4, "text-anchor": "end"}, text(value)));
  }
  for (const i of [0, last]) {
    svg.append(element("text", {x: x(i), y: base + 19, "text-anchor": "middle"}, `${i}`));
  }
  svg.append(element("polyline", {class: "curve", points: energies.map((value, i) => `${x(i)},${y(value)}`).join(" ")}));
  holder.replaceChildren(svg, element("p", {class: "chart-text"}, sentence));
}

export function drawLegend(quantity, range) {
  const [low, high] = quantity.bounds(range);
  document.getElementById("legend-title").textContent = quantity.title;
  document.getElementById("legend-bar").style.background =
      `linear-gradient(to right, ${quantity.colors.filter((_, i) => i % 15 === 0).map(cssColor).join(",")})`;
  document.getElementById("legend-ticks").replaceChildren(...ticksOf(quantity, range).map(tick => {
    const mark = element("span", {}, tick.text);
    mark.style.left = `${100 * (tick.octaves - low) / (high - low)}%`;
    return mark;
  }));
}

// One column a result, one row a figure that any of them has.
export function drawTable(results, chosen) {
  const table = document.getElementById("figures");
  const names = [...new Set(results.flatMap(result => result.figures.map(([name]) => name)))];
  document.getElementById("figures-card").hidden = names.length === 0;
  const mark = index => (results.length > 1 && index === chosen ? {class: "chosen"} : {});
  const head = element("tr", {}, element("th", {scope: "col"}, "Figure"),
                       ...results.map((result, i) => element("th", {scope: "col", ...mark(i)}, result.name)));
  const rows = names.map(name => element("tr", {}, element("th", {scope: "row"}, name), ...results.map((result, i) =>
      element("td", mark(i), result.figures.find(([other]) => other === name)?.[1] ?? "–"))));
  table.replaceChildren(element("caption", {hidden: ""}, "Figures of each result"), element("thead", {}, head),
                        element("tbody", {}, ...rows));
}
