// The page: controls, mouse, touch and keys. The address may preset a view, as
// #result=1&color=checker&morph=0.5&degree=8&edges&theme=dark&turn=X,Y,Z,W&zoom=2&picture (only the views) &check (for
// tests).

(() => {
  const byId = id => document.getElementById(id);
  const data = JSON.parse(byId("results").textContent), results = data.results;
  const quantities = quantitiesOf(data.levels);
  const preset = new URLSearchParams(location.hash.slice(1));
  const canvas = byId("canvas"), stage = byId("stage"), meshes = [];
  const chosenRange = {quasiConformal: 0, area: 0};  // 0: automatic
  const state = {turn: [0, 0, 0, 1], zoom: Number(preset.get("zoom")) || 1, shifts: [[0, 0], [0, 0]],
                 morph: Number(preset.get("morph")) || 0, mode: "quasiConformal",
                 coding: null, bounds: [0, 1], edges: preset.has("edges")};
  const reconstructions = [];  // of the results that have harmonics, once looked at
  let chosen = 0, degree = null, zUp = null, viewer = null, waiting = false, stale = false, mouse = null, pointed = null;

  const rangeOf = mode => chosenRange[mode] || automaticRange(quantities[mode], results[chosen]);

  function say(text) {
    byId("message").textContent = text;
    byId("message").hidden = false;
    stage.classList.add("empty");
  }

  // Draws with the browser's next picture, both views only if they have changed.
  function update() {
    if (waiting || !viewer) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      if (stale) drawNow();
      else pointAtMouse();
    });
  }

  function redraw() {
    stale = true;
    update();
  }

  function drawNow() {
    stale = false;
    viewer.stacked = stage.clientWidth < 620;
    stage.classList.toggle("stacked", viewer.stacked);
    viewer.draw(state);
    const [shape, sphere] = viewer.views();
    for (const [id, view] of [["shape-name", shape], ["sphere-name", sphere]]) {
      Object.assign(byId(id).style, {left: `${view.x}px`, top: `${view.y}px`});
    }
    const shapeName = degree !== null ? `Harmonics to degree ${degree}` : "Shape";
    byId("sphere-name").textContent = results[chosen].polycube ? "Polycube" : "Sphere";
    byId("shape-name").textContent = shapeName + (state.morph === 0 ? "" :
        ` to ${results[chosen].polycube ? "polycube" : "sphere"}, ${Math.round(100 * state.morph)} %`);
    pointAtMouse();
  }

  function pointAtMouse() {
    pointed = mouse && viewer.pick(state, mouse.x, mouse.y);
    placeMarkers();
  }

  // The place pointed at, in both views.
  function placeMarkers() {
    ["shape-marker", "sphere-marker"].forEach((id, index) => {
      const marker = byId(id);
      marker.hidden = !pointed || pointed.index === index;
      if (marker.hidden) return;
      const seen = viewer.seenAt(state, index, pointed.triangle, pointed.weights);
      const front = viewer.pick(state, seen.x, seen.y, index);
      const view = viewer.views()[index];
      marker.hidden = seen.x < view.x || seen.x > view.x + view.width || seen.y < view.y || seen.y > view.y + view.height;
      marker.classList.toggle("behind", front !== null && front.distance < seen.distance - 0.02);
      Object.assign(marker.style, {left: `${seen.x}px`, top: `${seen.y}px`});
    });
    byId("reading").hidden = !pointed;
    if (!pointed) return;
    const text = (quantity, level) => (level === quantity.noLevel ? "none" : figure(quantity.octaves(level)));
    const [quasiConformal, area] = viewer.mesh.levels.subarray(2 * pointed.triangle, 2 * pointed.triangle + 2);
    byId("reading").textContent = `Quasi-conformal distortion ${text(quantities.quasiConformal, quasiConformal)} · area ratio ` +
                                  text(quantities.area, area);
  }

  function showQuantity() {
    const quantity = quantities[state.mode];
    byId("legend").hidden = byId("scale-field").hidden = !quantity;
    for (const [mode, other] of Object.entries(quantities)) {
      drawChart(byId(`${mode}-chart`), other, results[chosen], rangeOf(mode));
      byId(`${mode}-chart`).parentElement.classList.toggle("chosen", mode === state.mode);
    }
    if (quantity) {
      const range = rangeOf(state.mode), [low, high] = quantity.bounds(range);
      state.coding = quantity.coding;
      state.bounds = [low, high];
      const sign = low < 0 ? value => `1/${value} to ${value}` : value => `1 to ${value}`;
      byId("scale").replaceChildren(
          element("option", {value: 0}, `automatic (${sign(automaticRange(quantity, results[chosen]))})`),
          ...scaleRanges.map(value => element("option", {value}, sign(value))));
      byId("scale").value = chosenRange[state.mode];
      drawLegend(quantity, range);
      viewer?.setColors(quantity.colors);
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
    mouse = null;
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
      viewer.setShape(value !== null ? reconstructions[chosen].at(value) : mesh.positions);
    }
    degree = value;
    byId("degree").value = value ?? highest + 1;
    byId("degree-text").textContent = value !== null
        ? `${value}${value === 0 ? " (a point)" : ""}, off by ${percent(reconstructions[chosen].distance(value))}`
        : "the shape itself";
    redraw();
  }

  // Turns both views about an axis of the picture.
  function turnBy(axis, angle) {
    state.turn = product(rotation(axis, angle), state.turn);
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
    state.turn = firstTurn();
    redraw();
  }

  // Zooms about a place of the canvas, or about the center of each view.
  function zoomBy(factor, x, y) {
    const zoom = Math.min(400, Math.max(0.3, state.zoom * factor)), actual = zoom / state.zoom;
    state.zoom = zoom;
    const index = x === undefined ? -1 : viewer.viewAt(x, y);
    state.shifts = state.shifts.map((shift, i) => {
      if (i !== index) return shift.map(value => value * actual);
      const view = viewer.views()[i];
      const at = [2 * (x - view.x) / view.width - 1, 1 - 2 * (y - view.y) / view.height];
      return shift.map((value, k) => at[k] + (value - at[k]) * actual);
    });
    redraw();
  }

  function shiftBy(index, dx, dy) {
    const view = viewer.views()[index];
    state.shifts[index][0] += 2 * dx / view.width;
    state.shifts[index][1] -= 2 * dy / view.height;
    redraw();
  }

  function reset() {
    Object.assign(state, {turn: firstTurn(), zoom: 1, shifts: [[0, 0], [0, 0]]});
    redraw();
  }

  function setMode(mode) {
    state.mode = mode;
    document.querySelector(`input[name="coloring"][value="${mode}"]`).checked = true;
    showQuantity();
  }

  function setMorph(value) {
    state.morph = value;
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
    const start = performance.now(), phase = Math.acos(1 - 2 * state.morph);
    const step = now => {
      if (!player.running) return;
      setMorph(Math.round(500 * (1 - Math.cos(phase + (now - start) / 1100))) / 1000);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  function listenToPointers() {
    const pointers = new Map();
    const placeOf = event => {
      const box = canvas.getBoundingClientRect();
      return {x: event.clientX - box.left, y: event.clientY - box.top};
    };
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("turning");
      pointers.set(event.pointerId, placeOf(event));
      mouse = null;
      update();
    });
    canvas.addEventListener("pointermove", event => {
      const now = placeOf(event), before = pointers.get(event.pointerId);
      if (!before) {
        mouse = event.pointerType === "mouse" ? now : null;
        update();
        return;
      }
      pointers.set(event.pointerId, now);
      const dx = now.x - before.x, dy = now.y - before.y, index = viewer.viewAt(before.x, before.y);
      if (pointers.size === 2) {
        const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
        const distance = place => Math.hypot(place.x - other.x, place.y - other.y) || 1;
        zoomBy(distance(now) / distance(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
        shiftBy(index, dx / 2, dy / 2);
      } else if (event.shiftKey || event.buttons & 6) {
        shiftBy(index, dx, dy);
      } else {
        const view = viewer.views()[index], radius = 0.42 * Math.min(view.width, view.height) * state.zoom;
        turnBy([dy, dx, 0], Math.hypot(dx, dy) / radius);
      }
    });
    const release = event => {
      pointers.delete(event.pointerId);
      if (pointers.size === 0) canvas.classList.remove("turning");
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("pointerleave", () => {
      mouse = null;
      update();
    });
    canvas.addEventListener("contextmenu", event => event.preventDefault());
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1, place = placeOf(event);
      zoomBy(Math.exp(-Math.max(-240, Math.min(240, lines * event.deltaY)) / 400), place.x, place.y);
    }, {passive: false});
  }

  function listenToKeys() {
    const step = () => 0.1 / Math.min(state.zoom, 20);
    const keys = {
      ArrowLeft: () => turnBy([0, 1, 0], -step()), ArrowRight: () => turnBy([0, 1, 0], step()),
      ArrowUp: () => turnBy([1, 0, 0], -step()), ArrowDown: () => turnBy([1, 0, 0], step()),
      "+": () => zoomBy(1.2), "=": () => zoomBy(1.2), "-": () => zoomBy(1 / 1.2), 0: reset,
      m: () => play(!player.running),
    };
    modes.forEach((mode, i) => {
      keys[i + 1] = () => setMode(mode);
    });
    canvas.addEventListener("keydown", event => {
      if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
      event.preventDefault();
      keys[event.key]();
    });
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
      state.edges = event.target.checked;
      redraw();
    });
    byId("scale").addEventListener("change", event => {
      chosenRange[state.mode] = Number(event.target.value);
      showQuantity();
    });
    byId("up").addEventListener("change", event => setUp(event.target.value === "z"));
    byId("reset").addEventListener("click", reset);
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
    const report = {frames: [], pointed: 0, reconstructions: []};
    results.forEach((result, index) => {
      choose(index);
      for (const mode of modes) {
        setMode(mode);
        drawNow();
        report.frames.push({result: result.name, mode, shape: viewer.statistics(0), sphere: viewer.statistics(1),
                            error: viewer.gl.getError()});
      }
      if (result.harmonics) {
        setDegree(result.harmonics.degree);
        drawNow();
        const distances = Array.from({length: degree + 1}, (_, i) => reconstructions[index].distance(i));
        report.reconstructions.push({result: result.name, distances, shape: viewer.statistics(0)});
        setDegree(null);
      }
      const view = viewer.views()[1];
      const found = viewer.pick(state, view.x + 0.55 * view.width, view.y + 0.45 * view.height);
      const seen = found && viewer.seenAt(state, 1, found.triangle, found.weights);
      if (seen && Math.hypot(seen.x - view.x - 0.55 * view.width, seen.y - view.y - 0.45 * view.height) < 1) ++report.pointed;
    });
    document.documentElement.dataset.check = JSON.stringify(report);
  }

  setTheme(preset.has("theme") ? preset.get("theme") === "dark" : matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.classList.toggle("picture", preset.has("picture"));
  byId("edges").checked = state.edges;
  byId("morph").value = state.morph;
  try {
    viewer = new Viewer(canvas);
  } catch (error) {
    console.warn(error.message);
    say("The views need WebGL 2, which this browser does not offer or has switched off. The figures are below.");
  }
  chosen = Number(preset.get("result")) || 0;
  degree = preset.has("degree") ? Number(preset.get("degree")) || 0 : null;
  listenToControls();
  choose(chosen);
  if (modes.includes(preset.get("color"))) setMode(preset.get("color"));
  if (!viewer) return;
  listenToPointers();
  listenToKeys();
  new ResizeObserver(drawNow).observe(stage);
  canvas.addEventListener("webglcontextlost", event => {
    event.preventDefault();
    say("The graphics unit was lost; load the page again.");
  });
  if (preset.has("check")) check();
})();
