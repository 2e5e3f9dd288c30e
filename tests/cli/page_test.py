#!/usr/bin/env python3
"""The report page: what it holds agrees with the files that it was made from, it loads nothing, and a browser shows it.

    page_test.py COMMAND

Makes two shapes, maps them and writes their page with the command. The part in the browser is left out, saying so,
where there is no Chromium.
"""
import base64
import html.parser
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import numpy

COMMAND = sys.argv[1]
NAME = "wick<e>d & 'odd'.obj"  # of a file: nothing in a name may get out of its place in the page


def run(*arguments):
    done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        sys.exit(f"{arguments}: exit {done.returncode}\n{done.stdout}{done.stderr}")


def check(condition, message):
    if not condition:
        sys.exit(f"failed: {message}")


def read_obj(path):
    positions, triangles = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return numpy.array(positions), numpy.array(triangles)


# --- what the page holds, read by the description in packed_mesh.h and packed_mesh.cpp


def decoded_triangles(codes, count):
    """The walk over the triangles."""
    numbers = []
    value = shift = 0
    for byte in codes:
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            numbers.append(value)
            value = shift = 0
    numbers = iter(numbers)
    met = 0
    triangles, waiting = [], []

    def corner(code):
        nonlocal met
        met += code == 1
        return met - 1 if code == 1 else met - (code - 1)

    front = 0
    while len(triangles) < count:
        if front == len(waiting):
            a, b, c = (corner(next(numbers)) for _ in range(3))
            triangles.append((a, b, c))
            waiting += [(a, b), (b, c), (c, a)]
            continue
        a, b = waiting[front]
        front += 1
        code = next(numbers)
        if code:
            c = corner(code)
            triangles.append((b, a, c))
            waiting += [(a, c), (c, b)]
    check(all(number == 0 for number in numbers), "codes are left over")
    return numpy.array(triangles)


def decoded_directions(data):
    raw = data.reshape(-1, 2, 3).astype(float) @ [1, 256, 65536]
    x, y = (2 * raw / (2**24 - 1) - 1).T
    z = 1 - abs(x) - abs(y)
    folded = z < 0
    x[folded], y[folded] = (numpy.where(x < 0, -1, 1) * (1 - abs(y)))[folded], (numpy.where(y < 0, -1, 1) * (1 - abs(x)))[folded]
    directions = numpy.stack([x, y, z], axis=1)
    return directions / numpy.linalg.norm(directions, axis=1)[:, None]


def decoded(result):
    """The bytes of the packed members."""
    return {key: numpy.frombuffer(base64.b64decode(result[key]), numpy.uint8)
            for key in ("positions", "directions", "connections", "quasiConformal", "areaRatio")}


def check_result(result, levels, shape_path, map_path):
    positions, triangles = read_obj(shape_path)
    directions = read_obj(map_path)[0]
    directions /= numpy.linalg.norm(directions, axis=1)[:, None]
    data = decoded(result)
    check(result["vertices"] == len(positions) and result["triangles"] == len(triangles), "counts")

    # Which vertex of the file each of the page is, by its position.
    steps = data["positions"].view("<u2").reshape(-1, 3)
    wanted = numpy.round((positions - result["low"]) / result["step"]).astype(int)
    vertex_at = {tuple(step): vertex for vertex, step in enumerate(wanted)}
    check(len(vertex_at) == len(positions), "the shape's vertices are too close to each other for this test")
    vertex_of = numpy.array([vertex_at.get(tuple(step), -1) for step in steps])
    check(sorted(vertex_of) == list(range(len(positions))), "positions differ")

    walked = vertex_of[decoded_triangles(data["connections"], len(triangles))]
    turned = numpy.array([numpy.roll(t, -numpy.argmin(t)) for t in walked])
    wanted = numpy.array([numpy.roll(t, -numpy.argmin(t)) for t in triangles])
    check(sorted(map(tuple, turned)) == sorted(map(tuple, wanted)), "triangles differ")

    # The page's directions are the file's, all turned by one rotation.
    shown = numpy.empty_like(directions)
    shown[vertex_of] = decoded_directions(data["directions"])
    u, _, v = numpy.linalg.svd(shown.T @ directions)
    check(numpy.linalg.det(u @ v) > 0, "the map is mirrored")
    worst = numpy.abs(shown - directions @ (u @ v).T).max()
    check(worst < 5e-7, f"directions differ by {worst}")  # steps of 1.2e-7 in octahedral coordinates, stretched up to 3

    # Distortion of each triangle, within half a level.
    p, q, r = positions[walked].transpose(1, 0, 2)
    area = numpy.linalg.norm(numpy.cross(q - p, r - p), axis=1) / 2
    a, b, c = directions[walked].transpose(1, 0, 2)
    dots = (a * b).sum(1) + (b * c).sum(1) + (c * a).sum(1)
    angle = 2 * numpy.arctan2((a * numpy.cross(b - a, c - a)).sum(1), 1 + dots)
    check(abs(angle.sum() - 4 * math.pi) < 1e-9 * 4 * math.pi, "the map does not cover the sphere once")
    ratio = angle / area * area.sum() / (4 * math.pi)
    first = numpy.stack([q - p, r - p], axis=2)
    second = numpy.stack([b - a, c - a], axis=2)
    metric, image = (numpy.einsum("nki,nkj->nij", m, m) for m in (first, second))
    trace = numpy.trace(numpy.linalg.solve(metric, image), axis1=1, axis2=2)
    determinant = numpy.linalg.det(image) / numpy.linalg.det(metric)
    root = numpy.sqrt(numpy.maximum(trace**2 / 4 - determinant, 0))
    quasi_conformal = (trace / 2 + root) / numpy.sqrt(determinant)
    for key, values, code in (("quasiConformal", quasi_conformal, levels["quasiConformal"]), ("areaRatio", ratio, levels["area"])):
        octaves = numpy.log2(values) / code["octaves"]
        expected = code["zero"] + code["span"] * numpy.sign(octaves) * numpy.sqrt(abs(octaves))
        # 0.05: near 1 the level goes with the square root, which magnifies the roundoff of this other way to compute it.
        off = abs(data[key] - numpy.clip(expected, 0, 255)).max()
        check(off < 0.55, f"{key} is off by {off} levels")
        share = numpy.bincount(data[key], weights=area / area.sum(), minlength=256)
        check(numpy.allclose(share, result[key + "Share"], atol=1e-9), f"shares of {key}")


# --- nothing is loaded


class References(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.found, self.policy = [], None

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if values.get("http-equiv", "").lower() == "content-security-policy":
            self.policy = values["content"]
        self.found += [value for key, value in attributes if key in ("src", "href", "srcset", "action", "data", "poster")]


def check_alone(page):
    references = References()
    references.feed(page)
    check(references.policy and "default-src 'none'" in references.policy, "no policy that forbids loading")
    check(all(value.startswith("data:") for value in references.found), f"references: {references.found}")
    for address in re.findall(r"(?:https?:)?//[a-z0-9-]+\.[^\s\"'<>)]*", page.lower()):
        # The name of SVG is no address that anything is loaded from.
        check(address == "http://www.w3.org/2000/svg", f"an address: {address}")
    for word in ("fetch(", "XMLHttpRequest", "WebSocket", "importScripts", "@import", "sendBeacon", "url("):
        check(word not in page, word)


# --- in a browser


def browse(browser, folder, address, *options):
    """The document after its script ran, and what it said on the console."""
    done = subprocess.run(
        [browser, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", f"--user-data-dir={folder}/profile",
         "--enable-logging=stderr", "--window-size=1200,900", "--virtual-time-budget=10000", *options, "--dump-dom", address],
        capture_output=True, text=True, timeout=240)
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


# Put at the end of the script in a copy of the page: what it reads from the results.
READ_BACK = """
document.documentElement.dataset.meshes = JSON.stringify(
    JSON.parse(document.getElementById("results").textContent).results.map(meshOf).map(mesh =>
        Object.fromEntries(Object.entries(mesh).map(([name, values]) => [name, Array.from(values)]))));
"""


def check_read_back(meshes, results):
    """The page's script and this one read the same."""
    check(len(meshes) == len(results), "not every result was read by the page's script")
    for mesh, result in zip(meshes, results):
        data = decoded(result)
        triangles = decoded_triangles(data["connections"], result["triangles"])
        check(mesh["triangles"] == triangles.ravel().tolist(), "the page's script reads other triangles")
        shown = numpy.array(mesh["directions"]).reshape(-1, 4)[:, :3]
        # float32 there, doubles here
        check(abs(shown - decoded_directions(data["directions"])).max() < 1e-6, "the page's script reads other directions")
        shown = numpy.array(mesh["positions"]).reshape(-1, 4)[:, :3]
        steps = data["positions"].view("<u2").reshape(-1, 3).astype(float)
        steps -= (steps.max(0) + steps.min(0)) / 2
        steps *= 1.15 / numpy.linalg.norm(steps, axis=1).max()
        check(abs(shown - steps).max() < 1e-6, "the page's script reads other positions")
        p, q, r = steps[triangles].transpose(1, 0, 2)
        normals = numpy.zeros_like(steps)
        for corner in range(3):
            numpy.add.at(normals, triangles[:, corner], numpy.cross(q - p, r - p))
        normals /= numpy.linalg.norm(normals, axis=1)[:, None]
        off = abs(numpy.array(mesh["normals"]).reshape(-1, 4)[:, :3] - normals).max()
        check(off < 1e-3, f"the page's normals are off by {off}")  # differences of float32 positions of thin triangles
        check(mesh["levels"] == numpy.stack([data["quasiConformal"], data["areaRatio"]], 1).ravel().tolist(), "levels")


def basis(directions, degree):
    """Real spherical harmonics as libs/harmonics/functions/coefficients.h has them, by the recurrence of the plain P_lm."""
    x, y, z = directions.T
    sine, phi = numpy.hypot(x, y), numpy.arctan2(y, x)
    values = numpy.zeros((len(directions), (degree + 1) ** 2))
    for m in range(degree + 1):
        before, now = 0, math.prod(range(1, 2 * m, 2)) * sine**m
        for l in range(m, degree + 1):
            if l > m:
                before, now = now, ((2 * l - 1) * z * now - (l + m - 1) * before) / (l - m)
            size = math.sqrt((2 * l + 1) / (4 * math.pi) * math.factorial(l - m) / math.factorial(l + m))
            values[:, l * l + l + m] = size * now * (math.sqrt(2) * numpy.cos(m * phi) if m else 1)
            if m:
                values[:, l * l + l - m] = size * now * math.sqrt(2) * numpy.sin(m * phi)
    return values


def reconstructions(result):
    """What the slider shows: the vertices by the page's harmonics to each degree from 0, in steps, one array each."""
    harmonics = result["harmonics"]
    degree = harmonics["degree"]
    turned = decoded_directions(decoded(result)["directions"])
    values = basis(turned @ numpy.reshape(harmonics["facing"], (3, 3)).T, degree)
    coefficients = numpy.frombuffer(base64.b64decode(harmonics["coefficients"]), "<f4").reshape(-1, 3).astype(float)
    check(len(coefficients) == (degree + 1) ** 2, "not as many coefficients as the degree has")
    return [values[:, :(l + 1) ** 2] @ coefficients[:(l + 1) ** 2] for l in range(degree + 1)]


def steps_of(result):
    return decoded(result)["positions"].view("<u2").reshape(-1, 3).astype(float)


def distances(result):
    """How far the shape is from its sums to each degree, over its diameter."""
    steps = steps_of(result)
    diameter = 2 * numpy.linalg.norm(steps - (steps.max(0) + steps.min(0)) / 2, axis=1).max()
    return [numpy.sqrt(((made - steps) ** 2).sum(1).mean()) / diameter for made in reconstructions(result)]


def check_harmonics(result, rebuilt_by_degree, shape_path):
    """The page's harmonics make the surfaces that the command wrote: degree -> file."""
    positions, _ = read_obj(shape_path)
    vertex_at = {tuple(step): vertex
                 for vertex, step in enumerate(numpy.round((positions - result["low"]) / result["step"]).astype(int))}
    vertex_of = [vertex_at[tuple(step)] for step in steps_of(result).astype(int)]
    made = reconstructions(result)
    size = numpy.ptp(positions, axis=0).max()
    for degree, path in rebuilt_by_degree.items():
        off = abs(numpy.array(result["low"]) + result["step"] * made[degree] - read_obj(path)[0][vertex_of]).max()
        # float32 coefficients, and directions of 24 bits that functions of this degree magnify a little
        check(off < 2e-5 * size, f"the surface of degree {degree} is off by {off / size} of its size")
    center = numpy.array(result["low"]) + result["step"] * made[0]
    check(numpy.ptp(center, axis=0).max() == 0, "degree 0 is no point")


def check_in_browser(folder, path, results):
    names = [result["name"] for result in results]
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser is None:
        print("skipped: what a browser makes of the page (there is no chromium)")
        return
    with open(path, encoding="utf-8") as file:
        page = file.read()
    tried = os.path.join(folder, "tried.html")
    with open(tried, "w", encoding="utf-8") as file:
        file.write(page.replace("\n</script>\n</body>", READ_BACK + "</script>\n</body>"))
    document, console = browse(browser, folder, f"file://{tried}#check", "--use-angle=swiftshader",
                               "--enable-unsafe-swiftshader")
    check(not console, f"console: {console}")
    found = re.search(r'data-check="([^"]*)"', document)
    check(found, "the page's script did not come to its end")
    report = json.loads(html.unescape(found.group(1)))
    check_read_back(json.loads(html.unescape(re.search(r'data-meshes="([^"]*)"', document).group(1))), results)
    check([frame["result"] for frame in report["frames"]] == [name for name in names for _ in range(4)], "results shown")
    for frame in report["frames"]:
        check(frame["error"] == 0, f"WebGL error: {frame}")
        # The sphere fills 84 % of the shorter side of its view, 0.84^2 pi / 4 of a square.
        check(0.2 < frame["sphere"]["drawn"] < 0.56, f"sphere: {frame}")
        check(0.02 < frame["shape"]["drawn"] < 0.6, f"shape: {frame}")
        check(min(frame["shape"]["colors"], frame["sphere"]["colors"]) > 50, f"colors: {frame}")
    shown = {(frame["result"], frame["shape"]["colors"], frame["sphere"]["colors"]) for frame in report["frames"]}
    check(len(shown) == len(report["frames"]), "colorings look alike")
    check([entry["result"] for entry in report["reconstructions"]] == names, "shapes made of harmonics")
    for rebuilt, result in zip(report["reconstructions"], results):
        off = distances(result)
        check(numpy.allclose(rebuilt["distances"], off, rtol=1e-3), f"harmonics: {rebuilt['distances']}, not {off}")
        check(0.02 < rebuilt["shape"]["drawn"] < 0.6, f"the shape by its harmonics: {rebuilt}")
    check(report["pointed"] == len(names), "what is pointed at is not found where it is drawn")
    check(document.count('class="bar"') > 40, "no histograms")
    check("One to one, checked exactly" in document, "no figures")

    document, console = browse(browser, folder, f"file://{path}", "--disable-3d-apis")
    check(not [line for line in console if "Uncaught" in line], f"without WebGL: {console}")
    message = re.search(r'<p class="message"[^>]*>', document)
    check(message and "hidden" not in message.group(0), "without WebGL there is no message")
    check("One to one, checked exactly" in document, "without WebGL there are no figures")
    print("in the browser: every result in every coloring, and the message without WebGL")


def main():
    with tempfile.TemporaryDirectory() as folder:
        at = lambda name: os.path.join(folder, name)
        names = ["creature.obj", NAME]
        maps = [at("map1.obj"), at("map2.obj")]
        for name, kind, seed, map_path in zip(names, ("creature", "blob"), ("1", "2"), maps):
            run("make", kind, "-o", at(name), "--resolution", "3000", "--seed", seed)
            run("sphere", at(name), "-o", map_path, "--quiet")
        title = "Two </script> maps & <b>more</b>"
        run("page", at(names[0]), maps[0], at(names[1]), maps[1], "-o", at("report.html"), "--title", title, "--degree",
            "10", "--quiet")
        with open(at("report.html"), encoding="utf-8") as file:
            page = file.read()
        check(page.count("</script>") == 2 and "<b>" not in page, "the title got out of its place")
        check(f"<title>{html.escape(title, quote=False)}</title>" in page, "the title is not there")
        data = json.loads(re.search(r'<script type="application/json" id="results">(.*?)</script>', page, re.S).group(1))
        results = data["results"]
        check([result["name"] for result in results] == names, "names")
        for result, name, map_path in zip(results, names, maps):
            check_result(result, data["levels"], at(name), map_path)
            off = distances(result)
            check(off[10] < 0.5 * off[2] < 0.5 * off[0], f"more degrees come no nearer: {off}")
        check_alone(page)

        # One map, by the verb that makes it.
        run("sphere", at(names[0]), "-o", at("map3.obj"), "--page", at("one.html"), "--quiet")
        with open(at("one.html"), encoding="utf-8") as file:
            one = file.read()
        check_alone(one)
        data = json.loads(re.search(r'id="results">(.*?)</script>', one, re.S).group(1))
        check_result(data["results"][0], data["levels"], at(names[0]), at("map3.obj"))
        check(data["results"][0]["harmonics"] is None, "harmonics that nobody asked for")

        # With the harmonics, by their verb: the slider shows the surfaces that it writes.
        rebuilt = {}
        for degree in (3, 10):
            rebuilt[degree] = at(f"degree{degree}.obj")
            run("harmonics", at(names[0]), "--sphere", maps[0], "--degree", "10", "--low", str(degree), "-o", at("c.sh"),
                "--reconstruct", rebuilt[degree], "--page", at("harmonics.html"), "--quiet")
        with open(at("harmonics.html"), encoding="utf-8") as file:
            one = file.read()
        check_alone(one)
        data = json.loads(re.search(r'id="results">(.*?)</script>', one, re.S).group(1))
        check_result(data["results"][0], data["levels"], at(names[0]), maps[0])
        check_harmonics(data["results"][0], rebuilt, at(names[0]))
        check(["Degree of the harmonics", "10"] in data["results"][0]["figures"], "the degree is not told")

        # A shape that lies otherwise is rotated to how the first one lies; its map has the same directions.
        angle = 2.1
        with open(at(names[0]), encoding="utf-8") as source, open(at("turned.obj"), "w", encoding="utf-8") as out:
            for line in source:
                if line.startswith("v "):
                    x, y, z = (float(word) for word in line.split()[1:4])
                    x, y = x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)
                    line = f"v {x!r} {z!r} {-y!r}\n"
                out.write(line)
        pairs = [at(names[0]), maps[0], at("turned.obj"), maps[0]]
        run("page", *pairs, "-o", at("aligned.html"), "--align", "shape", "--quiet")
        with open(at("aligned.html"), encoding="utf-8") as file:
            data = json.loads(re.search(r'id="results">(.*?)</script>', file.read(), re.S).group(1))
        first, second = (steps_of(result) * result["step"] + result["low"] for result in data["results"])
        # The alignment is exact for two positions of one shape; positions are rounded to steps of the box over 65535.
        off = abs(numpy.sort(first, axis=0) - numpy.sort(second, axis=0)).max() / numpy.ptp(first, axis=0).max()
        check(off < 1e-4, f"the turned shape is not aligned: {off}")
        refused = subprocess.run([COMMAND, "page", *pairs[:2], "-o", at("wrong.html"), "--align", "shape"],
                                 capture_output=True, text=True, timeout=60)
        check(refused.returncode == 2 and "--align" in refused.stderr, f"one shape to align: {refused}")

        # A map of another shape is refused.
        refused = subprocess.run([COMMAND, "page", at(names[0]), maps[1], "-o", at("wrong.html")], capture_output=True,
                                 text=True, timeout=60)
        check(refused.returncode == 2 and "invalid-argument" in refused.stderr, f"a wrong map: {refused}")
        check(not os.path.exists(at("wrong.html")), "a page was written for a wrong map")

        check_in_browser(folder, at("report.html"), results)
    print("ok")


main()
