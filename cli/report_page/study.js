// The page of a study: the mean shape with maps of its points, sliders of its modes, and the subjects. The address may
// preset a view, as #color=group_q&mode_1=2&subject=3&theme=dark&turn=X,Y,Z,W&check (for tests).

import {element} from "./charts.js";
import {cssColor} from "./colors.js";
import {drawDistances, drawModes, drawScores, fillTable} from "./study_charts.js";
import {coding, levelsOf, MovedMean, numbersOf, scaleOf} from "./study_data.js";
import {Camera, product, rotation} from "./viewer/camera.js";
import {Renderer} from "./viewer/renderer.js";
import {Viewer} from "./viewer/viewer.js";

const byId = id => document.getElementById(id);
const data = JSON.parse(byId("results").textContent);
const preset = new URLSearchParams(location.hash.slice(1));
const canvas = byId("canvas"), camera = new Camera();
const look = {morph: 0, mode: "quasiConformal", coding, bounds: [0, 1], edges: false};
const moved = new MovedMean(data);
const amounts = data.shifts.map(() => 0);
const shown = {map: null, values: null, scale: null, subject: null};
let viewer = null, markRow = null;

// What the surface may be colored by; the values of the last one change with the sliders.
const maps = [...data.maps.map(map => ({...map, numbers: null})), {name: "shift", title: "Displacement shown, along normals", kind: "shift"},
              {name: "plain", title: "Plain", kind: "plain"}];

function valuesOf(map) {
  if (map.kind === "shift") return moved.alongNormals(moved.displacement(amounts));
  map.numbers ??= map.kind === "vectors" ? moved.alongNormals(numbersOf(map)) : numbersOf(map);
  return map.numbers;
}

function drawLegendOf({colors, ticks}, title) {
  byId("legend-title").textContent = title;
  byId("legend-bar").style.background =
      `linear-gradient(to right, ${colors.filter((_, i) => i % 15 === 0).map(cssColor).join(",")})`;
  byId("legend-ticks").replaceChildren(...ticks.map(([place, text]) => {
    const mark = element("span", {}, text);
    mark.style.left = `${100 * place}%`;
    return mark;
  }));
}

function color() {
  const {map} = shown;
  byId("legend").hidden = map.kind === "plain";
  look.mode = map.kind === "plain" ? "plain" : "quasiConformal";
  shown.values = null;
  if (map.kind !== "plain") {
    shown.values = valuesOf(map);
    shown.scale = scaleOf({shift: "signed", vectors: "signed"}[map.kind] ?? map.kind, shown.values);
    drawLegendOf(shown.scale, map.title);
    moved.mesh.levels = levelsOf(shown.values, moved.triangles, shown.scale);
    viewer?.renderer.setColors(shown.scale.colors);
  }
  viewer?.setMesh(moved.mesh);
  move(false);
}

function move(recolor = shown.map.kind === "shift") {
  if (recolor) return color();
  const names = data.shifts.flatMap(({name}, k) => (amounts[k] === 0 ? [] : [`${name} ${amounts[k] > 0 ? "+" : "−"}${Math.abs(amounts[k]).toFixed(1)}`]));
  const subject = shown.subject === null ? "" : `${data.subjects[shown.subject].name}, by its scores: `;
  byId("shape-name").textContent = subject + (names.length === 0 ? "Mean" : names.slice(0, 3).join(", ") + (names.length > 3 ? ", ..." : ""));
  viewer?.renderer.setShape(moved.positionsAt(amounts));
  viewer?.redraw();
}

const sliders = data.shifts.map((shift, k) => {
  const input = element("input", {type: "range", min: -shift.limit, max: shift.limit, step: 0.1, value: 0});
  const output = element("output", {});
  byId("sliders").append(element("label", {}, element("span", {}, shift.name), output, input));
  input.addEventListener("input", () => {
    markSubject(null);
    setAmount(k, Number(input.value));
    move();
  });
  return {input, output, unit: shift.unit};
});

function setAmount(k, value) {
  amounts[k] = Math.min(data.shifts[k].limit, Math.max(-data.shifts[k].limit, value));
  sliders[k].input.value = amounts[k];
  sliders[k].output.textContent = `${amounts[k].toFixed(1)} ${sliders[k].unit}`;
}

function markSubject(index) {
  shown.subject = index;
  markRow?.(index);
  drawDistances(byId("outliers-chart"), data.subjects, index, choose);
  byId("scores-card").hidden = data.fractions.length < 2;
  if (data.fractions.length >= 2) drawScores(byId("scores-chart"), data.subjects, data.groups, index, choose);
}

// Shows the shape that a subject's scores give.
function choose(index) {
  markSubject(index);
  data.shifts.forEach((_, k) => setAmount(k, data.subjects[index].scores[k] ?? 0));
  move();
}

function toMean() {
  markSubject(null);
  data.shifts.forEach((_, k) => setAmount(k, 0));
  move();
}

function showReading(found) {
  const reading = byId("reading");
  reading.hidden = !found || !shown.values;
  if (reading.hidden) return;
  const corners = moved.triangles.subarray(3 * found.triangle, 3 * found.triangle + 3);
  const value = corners.reduce((sum, v, k) => sum + found.weights[k] * shown.values[v], 0);
  reading.textContent = `${shown.map.title}: ${value.toLocaleString("en", {maximumSignificantDigits: 3})}`;
}

function setUp(up) {
  const z = up === "z";
  byId("up").value = up;
  const pitch = rotation([1, 0, 0], 0.26), yaw = rotation([0, 1, 0], z ? -0.65 : 0.52);
  const first = product(pitch, product(yaw, z ? rotation([1, 0, 0], -Math.PI / 2) : [0, 0, 0, 1]));
  camera.lookFrom(preset.has("turn") ? preset.get("turn").split(",").map(Number) : first);
  viewer?.redraw();
}

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  byId("theme").setAttribute("aria-pressed", dark);
  viewer?.redraw();
}

function say(text) {
  byId("message").textContent = text;
  byId("message").hidden = false;
  byId("stage").classList.add("empty");
}

function setMap(name) {
  shown.map = maps.find(map => map.name === name) ?? maps[0];
  byId("coloring").value = shown.map.name;
  color();
}

function makeViewer() {
  try {
    viewer = new Viewer(new Renderer(canvas, camera, look), {
      onPoint: showReading, onLost: () => say("The graphics unit was lost; load the page again."),
    });
  } catch (error) {
    console.warn(error.message);
    say("The view needs WebGL 2, which this browser does not offer or has switched off. The figures are below.");
  }
}

function listenToStudy() {
  byId("coloring").append(...maps.map(({name, title}) => element("option", {value: name}, title)));
  byId("coloring").addEventListener("change", event => setMap(event.target.value));
  byId("edges").addEventListener("change", event => {
    look.edges = event.target.checked;
    viewer?.redraw();
  });
  byId("up").addEventListener("change", event => setUp(event.target.value));
  byId("reset").addEventListener("click", () => {
    camera.reset();
    viewer?.redraw();
  });
  byId("theme").addEventListener("click", () => setTheme(document.documentElement.dataset.theme !== "dark"));
  const mean = element("button", {type: "button"}, "Mean shape");
  mean.addEventListener("click", toMean);
  byId("sliders").append(mean);
}

// For tests: the mean in every coloring, and moved by each slider.
function checkStudy() {
  const report = {frames: [], moved: []};
  const frame = name => {
    viewer.drawNow();
    return {name, ...viewer.renderer.statistics(0), error: viewer.renderer.gl.getError()};
  };
  for (const {name} of maps) {
    setMap(name);
    report.frames.push(frame(name));
  }
  data.shifts.forEach(({name, limit}, k) => {
    setAmount(k, limit);
    move();
    report.moved.push(frame(name));
    setAmount(k, 0);
  });
  document.documentElement.dataset.check = JSON.stringify(report);
}

setTheme(preset.has("theme") ? preset.get("theme") === "dark" : matchMedia("(prefers-color-scheme: dark)").matches);
byId("summary").textContent = data.summary;
makeViewer();
listenToStudy();
setUp("y");
drawModes(byId("modes-chart"), data.fractions);
byId("modes-card").hidden = data.fractions.length === 0;
markRow = fillTable(byId("subjects"), data.columns, data.subjects, data.failed, choose);
setMap(preset.get("color") ?? data.first_map);
toMean();
data.shifts.forEach(({id}, k) => {
  if (preset.has(id)) setAmount(k, Number(preset.get(id)) || 0);
});
if (preset.has("subject")) choose(Math.min(data.subjects.length - 1, Math.max(0, Number(preset.get("subject")) || 0)));
else move();
if (viewer && preset.has("check")) checkStudy();
