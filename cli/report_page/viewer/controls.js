// Mouse, touch and keys of a viewer: dragging turns, the wheel and two fingers zoom, dragging with shift, with another
// button or with two fingers moves one view.

function placeOf(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return {x: event.clientX - box.left, y: event.clientY - box.top};
}

function dragTo(viewer, event, before, now, other) {
  const {renderer} = viewer, index = renderer.viewAt(before.x, before.y), dx = now.x - before.x, dy = now.y - before.y;
  if (other) {
    const distance = place => Math.hypot(place.x - other.x, place.y - other.y) || 1;
    viewer.zoomBy(distance(now) / distance(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
    viewer.shiftBy(index, dx / 2, dy / 2);
  } else if (event.shiftKey || event.buttons & 6) {
    viewer.shiftBy(index, dx, dy);
  } else {
    const view = renderer.views()[index], radius = 0.42 * Math.min(view.width, view.height) * viewer.camera.zoom;
    viewer.turnBy([dy, dx, 0], Math.hypot(dx, dy) / radius);
  }
}

export function listenToPointers(viewer) {
  const {canvas} = viewer, pointers = new Map();
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add("turning");
    pointers.set(event.pointerId, placeOf(canvas, event));
    viewer.point(null);
  });
  canvas.addEventListener("pointermove", event => {
    const now = placeOf(canvas, event), before = pointers.get(event.pointerId);
    if (!before) {
      viewer.point(event.pointerType === "mouse" ? now : null);
      return;
    }
    pointers.set(event.pointerId, now);
    const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    dragTo(viewer, event, before, now, others.length === 1 ? others[0] : null);
  });
  const release = event => {
    pointers.delete(event.pointerId);
    if (pointers.size === 0) canvas.classList.remove("turning");
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => viewer.point(null));
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1, place = placeOf(canvas, event);
    viewer.zoomBy(Math.exp(-Math.max(-240, Math.min(240, lines * event.deltaY)) / 400), place.x, place.y);
  }, {passive: false});
}

/** Arrows turn, + and - zoom, 0 resets; `more`: functions by the name of the key that calls them. */
export function listenToKeys(viewer, more) {
  const step = () => 0.1 / Math.min(viewer.camera.zoom, 20);
  const keys = {
    ArrowLeft: () => viewer.turnBy([0, 1, 0], -step()), ArrowRight: () => viewer.turnBy([0, 1, 0], step()),
    ArrowUp: () => viewer.turnBy([1, 0, 0], -step()), ArrowDown: () => viewer.turnBy([1, 0, 0], step()),
    "+": () => viewer.zoomBy(1.2), "=": () => viewer.zoomBy(1.2), "-": () => viewer.zoomBy(1 / 1.2),
    0: () => viewer.reset(), ...more,
  };
  viewer.canvas.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey || !Object.hasOwn(keys, event.key)) return;
    event.preventDefault();
    keys[event.key]();
  });
}
