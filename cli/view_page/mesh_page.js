// The page of meshes: its controls and its keys. The address may preset it, as
// #color=jacobian&map=cividis&edges=1&slice=0,0.5&quality=0.5&morph=1&theme=dark&up=z&turn=X,Y,Z,W&zoom=2&picture (only the
// views) &check (for tests).

import {categoryColors, colorMaps, specialColors} from "./color_maps.js";
import {savePicture, showLegend} from "./legend.js";
import {MeshRenderer} from "./mesh_renderer.js";
import {MeshView, curveColors} from "./mesh_view.js";
import {Camera, product, rotation} from "./viewer/camera.js";
import {Viewer} from "./viewer/viewer.js";

const byId = id => document.getElementById(id);
const data = JSON.parse(byId("results").textContent);
const preset = new URLSearchParams(location.hash.slice(1) || data.preset || "");
const canvas = byId("canvas"), stage = byId("stage"), parts = color => color.map(value => value / 255);
const look = {coloring: [], range: [0, 1], edges: false, markInverted: false, base: [0.80, 0.81, 0.83], planes: [],
              inverted: parts(specialColors.inverted), none: parts(specialColors.none)};
const camera = new Camera([0, 0, 0, 1], Number(preset.get("zoom")) || 1, [0, 0], data.items.length);
const calm = 250;  // milliseconds without a turn, after which a large mesh is drawn whole
const slow = 60;   // milliseconds for a picture, from which on meshes are simplified while they are turned
const large = {fast: 150000, slow: 20000};  // triangles, from which on they are
const views = [];
let viewer = null, picked = null, key = "plain", scale = {};  // scale: what the legend shows

function say(text) {
  byId("message").textContent = text;
  byId("message").hidden = false;
  stage.classList.add("empty");
}

// ---- what is shown

function planeFor(view) {
  const axis = byId("axis").value;
  if (axis === "") return null;
  const ends = view.box[axis], sign = byId("other").checked ? -1 : 1, at = Number(byId("at").value);
  // A little to the side, so that centers of cells in the middle are not on the plane.
  const place = ends[0] + (at + 1e-4) * (ends[1] - ends[0]);
  return {normal: [0, 1, 2].map(k => (k === Number(axis) ? sign : 0)), at: sign * place};
}

function showElements() {
  const limit = Number(byId("quality").value);
  byId("at").disabled = byId("other").disabled = byId("axis").value === "";
  byId("quality-text").textContent = limit >= 1 ? "all" : limit.toFixed(2);
  for (const view of views) view.show(planeFor(view), limit < 1 && view.ofCells ? [-Infinity, limit] : null);
  showScale();
  viewer.redraw();
}

function showColors() {
  const found = views.map(view => view.quantity(key)), quantity = found.find(Boolean), map = byId("map").value;
  byId("coloring").value = quantity ? key : "plain";
  look.coloring = found.map(each => (!each ? 0 : each.categories ? 2 : 1));
  byId("map-field").hidden = !quantity || Boolean(quantity.categories || quantity.map);
  look.markInverted = Boolean(quantity?.inverted);
  let inverted = 0, all = [];
  if (quantity) {
    const lists = found.filter(Boolean).map(each => each.values());
    const ranges = lists.map(values => quantity.range(values));
    look.range = [Math.min(...ranges.map(range => range[0])), Math.max(...ranges.map(range => range[1]))];
    if (quantity.inverted) inverted = lists.reduce((sum, values) => sum + values.reduce((count, value) => count + (value <= 0), 0), 0);
    if (quantity.categories) all = lists.flatMap(values => [...new Set(values)]);
    viewer.renderer.setColors(quantity.categories ? categoryColors : colorMaps[quantity.map ?? map]);
  }
  views.forEach(view => view.color(key));
  scale = {quantity, range: look.range, map, values: all, inverted};
  showScale();
  viewer.redraw();
}

// Solids that are transparent around their curves have no colors.
function showScale() {
  const curves = shownCurves(), colored = curves.length === 0 || views.some(({hasCurves}) => !hasCurves);
  showLegend({...scale, quantity: colored ? scale.quantity : null, curves});
}

function shownCurves() {
  const view = views.find(({hasCurves}) => hasCurves), whole = byId("axis").value === "" && Number(byId("quality").value) >= 1;
  if (!view || !whole) return [];
  return view.mesh.curves.map(({name, edges}, kind) => ({name, edges, color: curveColors[kind]})).filter(({edges}) => edges.length > 0);
}

function setColor(value) {
  key = value;
  showColors();
}

// ---- names and the place that is picked

// Views above each other have the height that each needs.
function setHeight() {
  const rows = viewer.renderer.grid(canvas.clientWidth, 1)[1];
  stage.style.height = canvas.clientWidth < viewer.renderer.narrow && !preset.has("picture") ? `${rows * (rows > 1 ? 17 : 22) + 4}rem` : "";
}

function placeNames() {
  viewer.renderer.views().forEach((view, i) => {
    Object.assign(byId("names").children[i].style, {left: `${view.x}px`, top: `${view.y}px`, maxWidth: `${view.width}px`});
  });
  const marker = byId("marker");
  marker.hidden = !picked;
  if (!picked) return;
  const {x, y} = viewer.renderer.seenAt(picked.index, views[picked.index].pointOf(picked.vertex));
  Object.assign(marker.style, {left: `${x}px`, top: `${y}px`});
}

function pick(x, y) {
  const found = viewer.renderer.pick(x, y), view = found && views[found.index];
  picked = null;
  if (found) {
    const element = view.drawn.elements[found.triangle], vertex = view.nearestVertex(element, x, y);
    picked = {index: found.index, element, vertex};
    byId("reading").textContent = view.describe(element, vertex).join("\n");
  }
  byId("reading").hidden = !picked;
  placeNames();
  return picked;
}

function letGo() {
  picked = null;
  byId("reading").hidden = true;
  placeNames();
}

// ---- turning

function firstTurn(zUp) {
  if (preset.has("turn")) return preset.get("turn").split(",").map(Number);
  const pitch = rotation([1, 0, 0], 0.42), yaw = rotation([0, 1, 0], -0.6);
  return product(pitch, product(yaw, zUp ? rotation([1, 0, 0], -Math.PI / 2) : [0, 0, 0, 1]));
}

function setUp(up) {
  byId("up").value = up;
  camera.lookFrom(firstTurn(up === "z"));
  viewer?.redraw();
}

let still = 0, begun = 0, limit = large.fast;

// Waits for the graphics unit, so that the time is that of the picture.
function measure() {
  const {renderer} = viewer;
  if (!renderer.coarse || limit === large.slow) return;
  renderer.gl.readPixels(0, 0, 1, 1, renderer.gl.RGBA, renderer.gl.UNSIGNED_BYTE, new Uint8Array(4));
  if (performance.now() - begun > slow) limit = large.slow;
}

function turned() {
  const {renderer} = viewer;
  views.forEach(view => view.prepareCoarse(limit));
  renderer.coarse = true;
  clearTimeout(still);
  still = setTimeout(() => {
    renderer.coarse = false;
    viewer.redraw();
  }, calm);
}

// ---- the controls

function chooseAxis(axis) {
  const field = byId("axis");
  field.value = field.value === axis ? "" : axis;
  showElements();
  showColors();
}

function moveSlice(step) {
  byId("at").value = Number(byId("at").value) + step;
  showElements();
}

function nextColor() {
  const options = [...byId("coloring").options].map(option => option.value);
  setColor(options[(options.indexOf(key) + 1) % options.length]);
}

function setEdges(shown) {
  look.edges = byId("edges").checked = shown;
  viewer.redraw();
}

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  byId("theme").setAttribute("aria-pressed", dark);
}

function beginDrawing() {
  setHeight();
  begun = performance.now();
}

function endDrawing() {
  placeNames();
  measure();
}

function makeViewer() {
  const keys = {x: () => chooseAxis("0"), y: () => chooseAxis("1"), z: () => chooseAxis("2"), "[": () => moveSlice(-0.02), "]": () => moveSlice(0.02),
                e: () => setEdges(!look.edges), c: nextColor, Escape: letGo,
                p: () => pick(canvas.clientWidth / 2, canvas.clientHeight / 2)};
  const renderer = new MeshRenderer(canvas, camera, look, {views: data.items.length, bottom: 62});
  viewer = new Viewer(renderer, {keys, onLayout: beginDrawing, onDraw: endDrawing, onMove: turned, onLost: () => say("The graphics unit was lost; load the page again.")});
  let down = null;
  canvas.addEventListener("pointerdown", event => down = [event.clientX, event.clientY]);
  canvas.addEventListener("pointerup", event => {
    const box = canvas.getBoundingClientRect();
    if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) pick(event.clientX - box.left, event.clientY - box.top);
    down = null;
  });
}

function addMeshes() {
  data.items.forEach((item, index) => {
    const view = new MeshView(viewer.renderer, index, item), p = view.mesh.framedPositions;
    view.box = [0, 1, 2].map(k => {
      let ends = [Infinity, -Infinity];
      for (let i = k; i < p.length; i += 4) ends = [Math.min(ends[0], p[i]), Math.max(ends[1], p[i])];
      return ends;
    });
    views.push(view);
    const name = document.createElement("p");
    name.className = "view-name";
    name.textContent = item.name;
    byId("names").append(name);
  });
  const titles = new Map([["plain", "Plain"]]);
  for (const view of views) for (const {key: each, title} of view.quantities) titles.set(each, title);
  byId("coloring").replaceChildren(...[...titles].map(([value, title]) => new Option(title, value)));
  byId("quality-field").hidden = !views.some(view => view.ofCells);
  byId("morph-field").hidden = !views.some(view => view.mesh.targets.length > 0);
}

function listen() {
  byId("coloring").addEventListener("change", event => setColor(event.target.value));
  byId("map").addEventListener("change", showColors);
  byId("edges").addEventListener("change", event => setEdges(event.target.checked));
  for (const id of ["axis", "other"]) byId(id).addEventListener("change", () => (showElements(), showColors()));
  byId("at").addEventListener("input", showElements);
  byId("quality").addEventListener("input", () => (showElements(), showColors()));
  byId("morph").addEventListener("input", event => {
    views.forEach(view => view.morph(Number(event.target.value)));
    showElements();
  });
  byId("up").addEventListener("change", event => setUp(event.target.value));
  byId("reset").addEventListener("click", () => viewer.reset());
  byId("theme").addEventListener("click", () => setTheme(document.documentElement.dataset.theme !== "dark"));
  byId("picture").addEventListener("click", () => savePicture(canvas, stage, data.items[0].name));
}

function fillFigures() {
  const rows = [...new Set(data.items.flatMap(({figures}) => figures.map(([name]) => name)))];
  const row = (tag, cells) => {
    const made = document.createElement("tr");
    made.append(...cells.map((text, i) => {
      const cell = document.createElement(i === 0 ? "th" : tag);
      cell.textContent = text;
      return cell;
    }));
    return made;
  };
  const head = document.createElement("thead"), body = document.createElement("tbody");
  head.append(row("th", ["", ...data.items.map(({name}) => name)]));
  body.append(...rows.map(name => row("td", [name, ...data.items.map(({figures}) => figures.find(([own]) => own === name)?.[1] ?? "–")])));
  byId("figures").replaceChildren(head, body);
  byId("summary").textContent = data.items.map(({name, figures}) => `${name}: ${figures.slice(0, 2).map(([what, value]) => `${value} ${what.toLowerCase()}`).join(", ")}`).join(" · ");
}

// For tests: every color, every slice, and what is picked.
function check() {
  const {renderer} = viewer, report = {frames: [], picked: []};
  const frame = what => {
    viewer.drawNow();
    report.frames.push({what, views: views.map((_, i) => renderer.statistics(i)), error: renderer.gl.getError()});
  };
  for (const option of byId("coloring").options) {
    setColor(option.value);
    frame(option.value);
  }
  for (const axis of ["0", "1", "2"]) {
    chooseAxis(axis);
    frame(`slice ${axis}`);
    chooseAxis(axis);
  }
  viewer.drawNow();
  renderer.views().forEach(view => {
    const found = pick(view.x + view.width / 2, view.y + view.height / 2);
    report.picked.push(found && {...found, text: byId("reading").textContent});
  });
  report.values = views.map(view => Object.fromEntries(view.quantities.map(each => [each.key, [...each.values().slice(0, 2000)]])));
  document.documentElement.dataset.check = JSON.stringify(report);
}

function start() {
  setTheme(preset.has("theme") ? preset.get("theme") === "dark" : matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.classList.toggle("picture", preset.has("picture"));
  fillFigures();
  try {
    makeViewer();
  } catch (error) {
    console.warn(error.message);
    say("The views need WebGL 2, which this browser does not offer or has switched off. The figures are below.");
    return;
  }
  const opened = performance.now();
  addMeshes();
  if (preset.has("map")) byId("map").value = preset.get("map");
  if (preset.has("slice")) [byId("axis").value, byId("at").value] = preset.get("slice").split(",");
  if (preset.has("quality")) byId("quality").value = preset.get("quality");
  byId("morph").value = preset.get("morph") ?? 0;
  listen();
  setUp(preset.get("up") ?? data.up ?? "y");
  if (Number(byId("morph").value) > 0) views.forEach(view => view.morph(Number(byId("morph").value)));
  showElements();
  setEdges(preset.has("edges") ? preset.get("edges") !== "0" : views.every(view => view.ofCells || view.geometry.elementCount < 20000));
  setColor(preset.get("color") ?? views[0].first);
  viewer.drawNow();
  document.documentElement.dataset.ready = Math.round(performance.now() - opened);
  if (preset.has("check")) check();
}

start();
