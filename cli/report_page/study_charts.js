// The charts and the table of a study's page.

import {element, percent} from "./charts.js";
import {shortText} from "./study_data.js";

function titled(node, text) {
  const title = document.createElementNS("http://www.w3.org/2000/svg", "title");
  title.textContent = text;
  node.append(title);
  return node;
}

// SVG elements that charts.js does not make.
function svgElement(name, attributes) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  return node;
}

function frameOfChart(holder, label) {
  const width = Math.min(640, Math.max(280, holder.clientWidth)), height = 190;
  return {width, height, svg: element("svg", {class: "chart", viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": label})};
}

export function drawModes(holder, fractions) {
  const shown = fractions.slice(0, 12), most = Math.max(...shown, 1e-12);
  const {width, svg} = frameOfChart(holder, `Shares of the variance: ${shown.map(percent).join(", ")}`);
  const step = (width - 20) / shown.length;
  svg.append(element("line", {class: "axis", x1: 10, x2: width - 10, y1: 160.5, y2: 160.5}));
  shown.forEach((part, k) => {
    const size = 135 * part / most, x = 10 + k * step, middle = x + step / 2;
    svg.append(titled(element("rect", {class: "mode-bar", x: x + 0.15 * step, width: 0.7 * step, y: 160 - size, height: size}),
                      `Mode ${k + 1}: ${percent(part)}`));
    svg.append(element("text", {x: middle, y: 178, "text-anchor": "middle"}, `${k + 1}`));
    if (step > 46) svg.append(element("text", {x: middle, y: 155 - size, "text-anchor": "middle"}, `${shortText(100 * part)} %`));
  });
  holder.replaceChildren(svg);
}

const classOf = (subject, index, chosen) =>
    `dot${subject.group === 1 ? " second" : ""}${subject.outlier ? " outlier" : ""}${index === chosen ? " chosen" : ""}`;

function dot(subject, index, chosen, place, choose) {
  const node = svgElement("circle", {class: classOf(subject, index, chosen), r: 4.5, ...place});
  node.addEventListener("click", () => choose(index));
  return titled(node, `${subject.name}: ${shortText(subject.distance)}`);
}

export function drawDistances(holder, subjects, chosen, choose) {
  const most = Math.max(...subjects.map(subject => subject.distance), 1e-300), taken = new Map();
  const outliers = subjects.filter(subject => subject.outlier).map(subject => subject.name);
  const sentence = outliers.length === 0 ? "No outlier."
      : `${outliers.length === 1 ? "Outlier" : "Outliers"}: ${outliers.slice(0, 12).join(", ")}${outliers.length > 12 ? ", ..." : "."}`;
  const {width, svg} = frameOfChart(holder, `Distances from the mean, up to ${shortText(most)}. ${sentence}`);
  const x = distance => 16 + distance / most * (width - 32);
  svg.append(element("line", {class: "axis", x1: 16, x2: width - 16, y1: 160.5, y2: 160.5}));
  for (const part of [0, 0.5, 1]) {
    svg.append(element("text", {x: x(part * most), y: 178, "text-anchor": ["start", "middle", "end"][2 * part]}, shortText(part * most)));
  }
  const bins = Math.floor((width - 32) / 10), counts = new Map();
  const binOf = subject => Math.round(subject.distance / most * bins);
  for (const subject of subjects) counts.set(binOf(subject), (counts.get(binOf(subject)) ?? 0) + 1);
  const step = Math.min(10, 145 / Math.max(...counts.values()));
  subjects.forEach((subject, i) => {
    const bin = binOf(subject), height = taken.get(bin) ?? 0;
    taken.set(bin, height + 1);
    svg.append(dot(subject, i, chosen, {cx: x(bin / bins * most), cy: 153 - step * height}, choose));
  });
  holder.replaceChildren(svg, element("p", {class: `chart-text${outliers.length ? " outlier" : ""}`}, sentence));
}

export function drawScores(holder, subjects, groups, chosen, choose) {
  const {width, height, svg} = frameOfChart(holder, "Scores of the subjects, mode 1 to the right, mode 2 up");
  const most = Math.max(1, ...subjects.flatMap(subject => subject.scores.slice(0, 2).map(Math.abs)));
  const x = score => width / 2 + score / most * (width / 2 - 20), y = score => height / 2 - score / most * (height / 2 - 14);
  svg.append(element("line", {class: "axis", x1: 8, x2: width - 8, y1: y(0), y2: y(0)}));
  svg.append(element("line", {class: "axis", x1: x(0), x2: x(0), y1: 6, y2: height - 6}));
  svg.append(element("text", {x: width - 8, y: y(0) - 6, "text-anchor": "end"}, `mode 1, ${shortText(most)}`));
  svg.append(element("text", {x: x(0) + 6, y: 16}, `mode 2, ${shortText(most)}`));
  subjects.forEach((subject, i) => svg.append(dot(subject, i, chosen, {cx: x(subject.scores[0]), cy: y(subject.scores[1])}, choose)));
  const keys = groups.flatMap((name, k) => [element("span", {class: `key${k === 1 ? " second" : ""}`}), name]);
  holder.replaceChildren(svg, element("p", {class: "chart-text"}, ...keys));
}

/** Fills the table once; returns a function that marks a row as chosen. */
export function fillTable(table, columns, subjects, failed, choose) {
  const cell = value => element("td", {}, value === null ? "–" : typeof value === "number" ? shortText(value) : value);
  const head = element("tr", {}, ...["Name", ...columns].map(name => element("th", {scope: "col"}, name)));
  const rows = subjects.map((subject, i) => {
    const button = element("button", {type: "button", "aria-label": `Show ${subject.name}`}, subject.name);
    const row = element("tr", {}, element("th", {scope: "row"}, button), ...subject.values.map(cell));
    row.classList.toggle("outlier", subject.outlier);
    row.addEventListener("click", () => choose(i));
    return row;
  });
  const lost = failed.map(({name, text}) =>
      element("tr", {class: "outlier"}, element("th", {scope: "row"}, name), element("td", {colspan: columns.length}, text)));
  table.replaceChildren(element("caption", {hidden: ""}, "Figures of each subject"), element("thead", {}, head),
                        element("tbody", {}, ...rows, ...lost));
  return chosen => rows.forEach((row, i) => row.classList.toggle("chosen", i === chosen));
}
