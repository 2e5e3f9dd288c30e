// The page: its controls, the names of the views and the place pointed at. The address may preset a view, as
// #result=1&color=checker&morph=0.5&degree=8&edges&theme=dark&turn=X,Y,Z,W&zoom=2&picture (only the views) &check (for
// tests).

import {element, drawChart, drawCurve, drawLegend, drawTable, figure, percent} from "./charts.js";
import {automaticRange, quantitiesOf, scaleRanges} from "./colors.js";
import {meshOf} from "./mesh_data.js";
import {Reconstruction} from "./reconstruction.js";
import {Camera, product, rotation} from "./viewer/camera.js";
import {Renderer} from "./viewer/renderer.js";
import {modes} from "./viewer/shaders.js";
import {Viewer} from "./viewer/viewer.js";

const legendHeight = 56;  // in CSS pixels, kept free below two views above each other
const byId = id => document.getElementById(id);
const data = JSON.parse(byId("results").textContent), results = data.results;
const quantities = quantitiesOf(data.levels);
const preset = new URLSearchParams(location.hash.slice(1));
const canvas = byId("canvas"), stage = byId("stage"), meshes = [];
const chosenRange = {quasiConformal: 0, area: 0};  // 0: automatic
const camera = new Camera();
const look = {morph: Number(preset.get("morph")) || 0, mode: "quasiConformal", coding: null, bounds: [0, 1],
              edges: preset.has("edges")};
const reconstructions = [];  // of the results that have harmonics, once looked at
let chosen = 0, degree = null, zUp = null, viewer = null, pointed = null;

const rangeOf = mode => chosenRange[mode] || automaticRange(quantities[mode], results[chosen]);

function say(text) {
  byId("message").textContent = text;
  byId("message").hidden = false;
  stage.classList.add("empty");
}

function redraw() {
  viewer?.redraw();
}

// What each view shows and where it begins.
function nameViews() {
  const map = results[chosen].polycube ? "Polycube" : "Sphere";
  const shape = degree !== null ? `Harmonics to degree ${degree}` : "Shape";
  const names = [shape + (look.morph === 0 ? "" : ` to ${map.toLowerCase()}, ${Math.round(100 * look.morph)} %`), map];
  viewer.renderer.views().forEach((view, index) => {
    const name = byId(["shape-name", "sphere-name"][index]);
    name.textContent = names[index];
    Object.assign(name.style, {left: `${view.x}px`, top: `${view.y}px`});
  });
}

function showPointed(found) {
  pointed = found;
  placeMarkers();
  byId("reading").hidden = !pointed;
  if (!pointed) return;
  const text = (quantity, level) => (level === quantity.noLevel ? "none" : figure(quantity.octaves(level)));
  const [quasiConformal, area] = viewer.renderer.mesh.levels.subarray(2 * pointed.triangle, 2 * pointed.triangle + 2);
  byId("reading").textContent = `Quasi-conformal distortion ${text(quantities.quasiConformal, quasiConformal)} · area ratio ` +
                                text(quantities.area, area);
}

// The place pointed at, in the other view.
function placeMarkers() {
  const {renderer} = viewer;
  ["shape-marker", "sphere-marker"].forEach((id, index) => {
    const marker = byId(id);
    marker.hidden = !pointed || pointed.index === index;
    if (marker.hidden) return;
    const seen = renderer.seenAt(index, pointed.triangle, pointed.weights);
    const front = renderer.pick(seen.x, seen.y, index);
    const view = renderer.views()[index];
    marker.hidden = seen.x < view.x || seen.x > view.x + view.width || seen.y < view.y || seen.y > view.y + view.height;
    marker.classList.toggle("behind", front !== null && front.distance < seen.distance - 0.02);
    Object.assign(marker.style, {left: `${seen.x}px`, top: `${seen.y}px`});
  });
}

function showQuantity() {
  const quantity = quantities[look.mode];
  byId("legend").hidden = byId("scale-field").hidden = !quantity;
  for (const [mode, other] of Object.entries(quantities)) {
    drawChart(byId(`${mode}-chart`), other, results[chosen], rangeOf(mode));
    byId(`${mode}-chart`).parentElement.classList.toggle("chosen", mode === look.mode);
  }
  if (quantity) {
    const range = rangeOf(look.mode), [low, high] = quantity.bounds(range);
    look.coding = quantity.coding;
    look.bounds = [low, high];
    const sign = low < 0 ? value => `1/${value} to ${value}` : value => `1 to ${value}`;
    byId("scale").replaceChildren(
        element("option", {value: 0}, `automatic (${sign(automaticRange(quantity, results[chosen]))})`),
        ...scaleRanges.map(value => element("option", {value}, sign(value))));
    byId("scale").value = chosenRange[look.mode];
    drawLegend(quantity, range);
    viewer?.renderer.setColors(quantity.colors);
  }
  redraw();
}

function choose(index) {
  chosen = Math.min(results.length - 1, Math.max(0, index));
  const result = results[chosen], count = value => value.toLocaleString("en");
  const large = result.triangles > 200000 ? ", all of them drawn" : "";
  byId("summary").textContent = `${result.name}: ${count(result.vertices)} vertices, ${count(result.triangles)} triangles` +
                                large;
  canvas.setAttribute("aria-label", `${result.name}: the shape beside its map to the ${result.polycube ? "polycube" : "sphere"}, in three dimensions`);
  if (zUp !== result.zUp) setUp(result.zUp);
  if (viewer) {
    try {
      viewer.setMesh(meshes[chosen] ??= meshOf(result));
    } catch (error) {
      viewer = null;
      say(`This result cannot be shown: ${error.message}. Its figures are below.`);
    }
  }
  byId("degree-field").hidden = !viewer || !result.harmonics;
  if (result.harmonics) byId("degree").max = result.harmonics.degree + 1;
  setDegree(viewer && result.harmonics && degree !== null ? Math.min(degree, result.harmonics.degree) : null);
  drawTable(results, chosen);
  drawCurve(byId("energy-chart"), byId("energy-card"), result.energies ?? []);
  showQuantity();
}

// The shape as its harmonics to this degree give it, a single point to degree 0; null: the shape itself.
function setDegree(value) {
  const mesh = meshes[chosen], highest = results[chosen].harmonics?.degree;
  if (viewer && (degree !== null || value !== null)) {
    if (value !== null) reconstructions[chosen] ??= new Reconstruction(results[chosen], mesh);
    viewer.renderer.setShape(value !== null ? reconstructions[chosen].at(value) : mesh.positions);
  }
  degree = value;
  byId("degree").value = value ?? highest + 1;
  byId("degree-text").textContent = value !== null
      ? `${value}${value === 0 ? " (a point)" : ""}, off by ${percent(reconstructions[chosen].distance(value))}`
      : "the shape itself";
  redraw();
}

// Seen from above the front corner. With z up, x is taken for forward, as is usual there; with y up, z.
function firstTurn() {
  if (preset.has("turn")) return preset.get("turn").split(",").map(Number);
  const pitch = rotation([1, 0, 0], 0.26), yaw = rotation([0, 1, 0], zUp ? -0.65 : 0.52);
  return product(pitch, product(yaw, zUp ? rotation([1, 0, 0], -Math.PI / 2) : [0, 0, 0, 1]));
}

function setUp(z) {
  zUp = z;
  byId("up").value = z ? "z" : "y";
  camera.lookFrom(firstTurn());
  redraw();
}

function setMode(mode) {
  look.mode = mode;
  document.querySelector(`input[name="coloring"][value="${mode}"]`).checked = true;
  showQuantity();
}

function setMorph(value) {
  look.morph = value;
  byId("morph").value = value;
  redraw();
}

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  byId("theme").setAttribute("aria-pressed", dark);
  redraw();
}

const player = {running: false};
function play(running) {
  player.running = running;
  byId("play").textContent = running ? "Pause" : "Play";
  byId("play").setAttribute("aria-pressed", running);
  if (!running) return;
  const start = performance.now(), phase = Math.acos(1 - 2 * look.morph);
  const step = now => {
    if (!player.running) return;
    setMorph(Math.round(500 * (1 - Math.cos(phase + (now - start) / 1100))) / 1000);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function makeViewer() {
  const keys = {m: () => play(!player.running)};
  modes.forEach((mode, i) => {
    keys[i + 1] = () => setMode(mode);
  });
  try {
    viewer = new Viewer(new Renderer(canvas, camera, look, {views: 2, bottom: legendHeight}), {
      keys,
      onLayout: () => stage.classList.toggle("stacked", viewer.renderer.stacked),
      onDraw: nameViews,
      onPoint: showPointed,
      onLost: () => say("The graphics unit was lost; load the page again."),
    });
  } catch (error) {
    console.warn(error.message);
    say("The views need WebGL 2, which this browser does not offer or has switched off. The figures are below.");
  }
}

function listenToControls() {
  byId("coloring").addEventListener("change", event => setMode(event.target.value));
  byId("morph").addEventListener("input", event => {
    play(false);
    setMorph(Number(event.target.value));
  });
  byId("degree").addEventListener("input", event => {
    const value = Number(event.target.value);
    setDegree(value > results[chosen].harmonics.degree ? null : value);
  });
  byId("play").addEventListener("click", () => play(!player.running));
  byId("edges").addEventListener("change", event => {
    look.edges = event.target.checked;
    redraw();
  });
  byId("scale").addEventListener("change", event => {
    chosenRange[look.mode] = Number(event.target.value);
    showQuantity();
  });
  byId("up").addEventListener("change", event => setUp(event.target.value === "z"));
  byId("reset").addEventListener("click", () => {
    camera.reset();
    redraw();
  });
  byId("theme").addEventListener("click", () => setTheme(document.documentElement.dataset.theme !== "dark"));
  if (results.length > 1) {
    byId("results-choice").hidden = false;
    results.forEach((result, index) => {
      const input = element("input", {type: "radio", name: "result", value: index});
      input.checked = index === chosen;
      input.addEventListener("change", () => choose(index));
      byId("results-choice").append(element("label", {}, input, element("span", {}, result.name)));
    });
  }
}

// For tests: every result in every coloring, and whether what is pointed at is found in the other view.
function check() {
  const report = {frames: [], pointed: 0, reconstructions: []}, {renderer} = viewer;
  results.forEach((result, index) => {
    choose(index);
    for (const mode of modes) {
      setMode(mode);
      viewer.drawNow();
      report.frames.push({result: result.name, mode, shape: renderer.statistics(0), sphere: renderer.statistics(1),
                          error: renderer.gl.getError()});
    }
    if (result.harmonics) {
      setDegree(result.harmonics.degree);
      viewer.drawNow();
      const distances = Array.from({length: degree + 1}, (_, i) => reconstructions[index].distance(i));
      report.reconstructions.push({result: result.name, distances, shape: renderer.statistics(0)});
      setDegree(null);
    }
    const view = renderer.views()[1], x = view.x + 0.55 * view.width, y = view.y + 0.45 * view.height;
    const found = renderer.pick(x, y), seen = found && renderer.seenAt(1, found.triangle, found.weights);
    if (seen && Math.hypot(seen.x - x, seen.y - y) < 1) ++report.pointed;
  });
  document.documentElement.dataset.check = JSON.stringify(report);
}

setTheme(preset.has("theme") ? preset.get("theme") === "dark" : matchMedia("(prefers-color-scheme: dark)").matches);
document.documentElement.classList.toggle("picture", preset.has("picture"));
byId("edges").checked = look.edges;
byId("morph").value = look.morph;
makeViewer();
camera.zoom = Number(preset.get("zoom")) || 1;
chosen = Number(preset.get("result")) || 0;
degree = preset.has("degree") ? Number(preset.get("degree")) || 0 : null;
listenToControls();
choose(chosen);
if (modes.includes(preset.get("color"))) setMode(preset.get("color"));
if (viewer && preset.has("check")) check();
