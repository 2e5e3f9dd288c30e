// Color maps and the two quantities that they show. Colors run evenly to the eye: they are interpolated in OKLab
// (Ottosson 2020), with a lightness that falls steadily away from what is good.

function srgbOf([lightness, a, b]) {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s,
  ].map(value => {
    const clipped = Math.min(1, Math.max(0, value));
    return Math.round(255 * (clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * clipped ** (1 / 2.4) - 0.055));
  });
}

// 256 colors through stops of lightness, chroma and hue in degrees.
function colorMap(stops) {
  const lab = stops.map(([lightness, chroma, hue]) =>
      [lightness, chroma * Math.cos(hue * Math.PI / 180), chroma * Math.sin(hue * Math.PI / 180)]);
  return Array.from({length: 256}, (_, i) => {
    const at = i / 255 * (lab.length - 1);
    const stop = Math.min(lab.length - 2, Math.floor(at));
    return srgbOf(lab[stop].map((value, k) => value + (at - stop) * (lab[stop + 1][k] - value)));
  });
}

export const cssColor = ([red, green, blue]) => `rgb(${red},${green},${blue})`;

// The two quantities: a result's shares of area by level, the part of a color scale's range that they use (a range r
// stands for 1 to r or 1/r to r, in octaves), colors, and what values the levels stand for (packed_mesh.h).
export function quantitiesOf(levels) {
  const quantity = (coding, more) => {
    const octaves = level => {
      const part = (level - coding.zero) / coding.span;
      return coding.octaves * part * Math.abs(part);
    };
    return {coding, octaves, noLevel: coding.none, ...more};
  };
  return {
    quasiConformal: quantity(levels.quasiConformal, {
      title: "Quasi-conformal distortion",
      share: result => result.quasiConformalShare,
      bounds: range => [0, Math.log2(range)],
      colors: colorMap([[0.95, 0.025, 110], [0.87, 0.11, 92], [0.74, 0.16, 55], [0.58, 0.19, 20], [0.42, 0.16, 345],
                          [0.27, 0.1, 300]]),
    }),
    area: quantity(levels.area, {
      title: "Area ratio",
      share: result => result.areaRatioShare,
      bounds: range => [-Math.log2(range), Math.log2(range)],
      colors: colorMap([[0.33, 0.13, 265], [0.55, 0.13, 250], [0.77, 0.085, 230], [0.955, 0.008, 100],
                          [0.8, 0.11, 70], [0.6, 0.16, 40], [0.36, 0.13, 25]]),
    }),
  };
}

export const scaleRanges = [1.25, 1.5, 2, 3, 4, 6, 8, 12, 16, 32, 64, 128];

// The minimum number of octaves that `part` of the result's area stays below.
function quantile(quantity, result, part) {
  const share = quantity.share(result);
  let sum = 0, octaves = 0;
  for (let level = 0; level < 256; ++level) {
    if (level === quantity.noLevel || share[level] === 0) continue;
    sum += share[level];
    octaves = quantity.octaves(level);
    if (sum >= part) break;
  }
  return octaves;
}

// The smallest range that shows all but the last hundredths of the result.
export function automaticRange(quantity, result) {
  const needed = Math.max(quantile(quantity, result, 0.98), -quantile(quantity, result, 0.02));
  return scaleRanges.find(range => Math.log2(range) >= needed) ?? scaleRanges.at(-1);
}

// Round values on a scale, far enough from each other to be written side by side.
export function ticksOf(quantity, range) {
  const [low, high] = quantity.bounds(range), least = (high - low) / 7.5;
  const text = value => String(Math.round(100 * value) / 100);
  const above = [1];
  for (const value of [1.25, 1.5, 2, 3, 4, 8, 16, 32, 64]) {
    if (Math.log2(value / above.at(-1)) >= least && Math.log2(range / value) >= least) above.push(value);
  }
  above.push(range);
  const ticks = above.map(value => ({octaves: Math.log2(value), text: text(value)}));
  if (low === 0) return ticks;
  return [...above.slice(1).reverse().map(value => ({octaves: -Math.log2(value), text: `1/${text(value)}`})), ...ticks];
}
