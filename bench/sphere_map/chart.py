"""Line charts as PNG, drawn by Chromium (Debian: chromium) from SVG; nothing else is needed."""
import html
import math
import os
import shutil
import subprocess
import tempfile

COLOURS = ("#2667b5", "#c9542c", "#3f8f4f", "#8a4fa3", "#b98a17", "#4a9aa5", "#a33b60", "#5d6670")
WIDTH, HEIGHT = 520, 340
LEFT, RIGHT, TOP, BOTTOM = 62, 16, 34, 46


def ticks(low, high, log):
    if log:
        values = [10.0 ** e for e in range(math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9) + 1)]
        if len(values) < 3:
            values = [m * 10.0 ** e for e in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
                      for m in (1, 2, 5) if low <= m * 10.0 ** e * (1 + 1e-9) and m * 10.0 ** e <= high * (1 + 1e-9)]
        return values
    step = 10.0 ** math.floor(math.log10((high - low) / 4))
    step *= next(m for m in (1, 2, 5, 10) if (high - low) / (step * m) <= 6)
    return [step * i for i in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def label(value):
    if value != 0 and (abs(value) >= 1e5 or abs(value) < 1e-3):
        exponent = math.floor(math.log10(abs(value)) + 1e-9)
        factor = value / 10.0 ** exponent
        power = f'10<tspan dy="-5" font-size="9">{exponent}</tspan>'
        return power if abs(factor - 1) < 1e-6 else f"{factor:g}·{power}"
    return f"{value:g}"


def panel(title, x_title, y_title, curves, x_log=False, y_log=False):
    """An SVG group of WIDTH by HEIGHT; curves: (name, [(x, y), ...]) each."""
    points = [point for _, curve in curves for point in curve]
    x_low, x_high = min(x for x, _ in points), max(x for x, _ in points)
    y_low, y_high = min(y for _, y in points), max(y for _, y in points)
    if not y_log:
        margin = 0.05 * (y_high - y_low)
        y_low, y_high = y_low - margin, y_high + margin

    def place(value, low, high, log, start, end):
        if log:
            value, low, high = math.log(value), math.log(low), math.log(high)
        return start + (end - start) * (value - low) / (high - low)

    def x_of(value):
        return place(value, x_low, x_high, x_log, LEFT, WIDTH - RIGHT)

    def y_of(value):
        return place(value, y_low, y_high, y_log, HEIGHT - BOTTOM, TOP)

    parts = [f'<text x="{LEFT}" y="18" font-weight="bold">{html.escape(title)}</text>']
    for value in ticks(x_low, x_high, x_log):
        x = x_of(value)
        parts.append(f'<line class="grid" x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{HEIGHT - BOTTOM}"/>'
                     f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{label(value)}</text>')
    for value in ticks(y_low, y_high, y_log):
        y = y_of(value)
        parts.append(f'<line class="grid" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
                     f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{label(value)}</text>')
    parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">'
                 f'{html.escape(x_title)}</text>'
                 f'<text transform="translate(14 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">'
                 f'{html.escape(y_title)}</text>')
    for i, (name, curve) in enumerate(curves):
        color = COLOURS[i % len(COLOURS)]
        path = " ".join(f"{x_of(x):.1f},{y_of(y):.1f}" for x, y in curve)
        parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.6"/>')
        y = TOP + 14 + 16 * i
        parts.append(f'<line x1="{WIDTH - 116}" x2="{WIDTH - 98}" y1="{y - 4}" y2="{y - 4}" stroke="{color}" '
                     f'stroke-width="2.5"/><text x="{WIDTH - 92}" y="{y}">{html.escape(name)}</text>')
    return "".join(parts)


def write(path, panels):
    """Writes panels beside each other to a PNG."""
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser is None:
        raise SystemExit("chart.py: there is no chromium")
    width = WIDTH * len(panels)
    groups = "".join(f'<g transform="translate({WIDTH * i} 0)">{text}</g>' for i, text in enumerate(panels))
    page = (f'<!doctype html><meta charset="utf-8"><style>body{{margin:0;background:#fff}}text{{font:12px "DejaVu Sans",'
            f'sans-serif;fill:#333}}.grid{{stroke:#ddd}}</style><svg width="{width}" height="{HEIGHT}">{groups}</svg>')
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "chart.html")
        with open(file, "w", encoding="utf-8") as out:
            out.write(page)
        subprocess.run([browser, "--headless=new", "--no-sandbox", "--hide-scrollbars", "--disable-gpu",
                        f"--user-data-dir={folder}/profile", f"--window-size={width},{HEIGHT}",
                        f"--screenshot={os.path.abspath(path)}", f"file://{file}"],
                       check=True, capture_output=True, timeout=300)
