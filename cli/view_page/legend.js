// The legend of the color scale, and a picture of the views with it.

import {categoryColors, colorMaps, cssOf, specialColors} from "./color_maps.js";

const find = id => document.getElementById(id);

function node(name, text = "", style = {}) {
  const made = document.createElement(name);
  made.textContent = text;
  Object.assign(made.style, style);
  return made;
}

function swatch(color, text) {
  const made = node("span", text), box = node("span", "", {background: cssOf(color)});
  box.className = "swatch";
  made.prepend(box);
  return made;
}

/** Shows the scale of a quantity, or hides the legend without one; `curves`: names of kinds of curves with their colors. */
export function showLegend({quantity, range, map, values, inverted, curves}) {
  const legend = find("legend"), ticks = find("legend-ticks");
  legend.hidden = !quantity && curves.length === 0;
  const named = curves.map(({name, color}) => swatch(color.map(value => 255 * value), name));
  legend.classList.toggle("categories", !quantity || Boolean(quantity.categories));
  find("legend-title").textContent = quantity ? quantity.title + (quantity.unit ? ` (${quantity.unit})` : "") : "Singular curves";
  if (!quantity) {
    ticks.replaceChildren(...named);
  } else if (quantity.categories) {
    const used = [...new Set(values)].sort((a, b) => a - b), list = used.slice(0, 8);
    const name = i => (typeof quantity.categories === "function" ? quantity.categories(i) : quantity.categories[i]);
    ticks.replaceChildren(...list.map(i => swatch(categoryColors[i % 8], name(i))), ...(used.length > 8 ? [node("span", `and ${used.length - 8} more`)] : []));
  } else {
    const colors = colorMaps[quantity.map ?? map];
    find("legend-bar").style.background = `linear-gradient(to right, ${[0, 32, 64, 96, 128, 160, 192, 224, 255].map(i => cssOf(colors[i])).join(", ")})`;
    const count = 4, text = i => quantity.text(range[0] + i / count * (range[1] - range[0]));
    ticks.replaceChildren(...Array.from({length: count + 1}, (_, i) => node("span", text(i), {left: `${100 * i / count}%`})));
    if (inverted > 0) find("legend-title").prepend(swatch(specialColors.inverted, `${inverted} inverted. `));
  }
}

/** Downloads the views with their names and the legend as a PNG. */
export function savePicture(canvas, stage, name) {
  const ratio = canvas.width / canvas.clientWidth, made = document.createElement("canvas"), context = made.getContext("2d");
  Object.assign(made, {width: canvas.width, height: canvas.height});
  const style = getComputedStyle(document.documentElement);
  context.fillStyle = style.getPropertyValue("--card");
  context.fillRect(0, 0, made.width, made.height);
  context.drawImage(canvas, 0, 0);
  const corner = stage.getBoundingClientRect();
  context.scale(ratio, ratio);
  context.fillStyle = style.getPropertyValue("--text");
  const bar = find("legend-bar"), box = bar.getBoundingClientRect();
  if (!find("legend").hidden && box.height > 0) {
    const colors = getComputedStyle(bar).backgroundImage.match(/rgb\([^)]*\)/g) ?? [];
    const gradient = context.createLinearGradient(box.left - corner.left, 0, box.right - corner.left, 0);
    colors.forEach((color, i) => gradient.addColorStop(i / (colors.length - 1), color));
    context.fillStyle = gradient;
    context.fillRect(box.left - corner.left, box.top - corner.top, box.width, box.height);
  }
  for (const text of stage.querySelectorAll("#names p, #legend-title, #legend-ticks > span, .swatch")) {
    const place = text.getBoundingClientRect(), own = getComputedStyle(text);
    if (place.width === 0 || find("legend").contains(text) && find("legend").hidden) continue;
    const [x, y] = [place.left - corner.left + parseFloat(own.paddingLeft), place.top - corner.top + parseFloat(own.paddingTop)];
    if (text.className === "swatch") {
      context.fillStyle = own.backgroundColor;
      context.fillRect(x, y, place.width, place.height);
      continue;
    }
    context.font = own.font;
    context.textBaseline = "top";
    context.fillStyle = own.color;
    context.fillText(text.textContent, x + (text.querySelector(".swatch") ? 16 : 0), y + 2);
  }
  made.toBlob(blob => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${name}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  });
}
