// Color maps that are even to the eye and can be distinguished with color-blind eyes: viridis (Smith, van der Walt 2015) and
// cividis (Nunez et al. 2018) by ten of their colors, and a diverging one. Categories have the colors of Okabe and Ito
// (2008).

const rgb = hex => [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16));
const even = text => {
  const stops = text.split(" ").map(hex => rgb(`#${hex}`));
  return Array.from({length: 256}, (_, i) => {
    const at = i / 255 * (stops.length - 1), stop = Math.min(stops.length - 2, Math.floor(at));
    return stops[stop].map((value, k) => Math.round(value + (at - stop) * (stops[stop + 1][k] - value)));
  });
};

export const colorMaps = {
  viridis: even("440154 482878 3e4989 31688e 26828e 1f9e89 35b779 6ece58 b5de2b fde725"),
  cividis: even("00224e 123570 3b496c 575d6d 707173 8a8678 a59c74 c3b369 e1cc55 fee838"),
  diverging: even("053061 2166ac 4393c3 92c5de d1e5f0 f7f7f7 fddbc7 f4a582 d6604d b2182b 67001f"),
};
export const categoryColors = ["#0072b2", "#56b4e9", "#e69f00", "#f0e442", "#009e73", "#cc79a7", "#d55e00", "#999999"].map(rgb);
/** Of inverted cells and of values that there are none of. */
export const specialColors = {inverted: rgb("#d55e00"), none: rgb("#7f7f7f")};

export const cssOf = ([red, green, blue]) => `rgb(${red},${green},${blue})`;
