#!/usr/bin/env python3
"""cad_parts.py FOLDER [--count N] [--first I]: writes surfaces of machined parts with sharp edges, as OFF files.

Part I is the same in every run with the same version of Gmsh: its family is I modulo 12, its measures are random with the
seed I. Families: L-shaped brackets, flanges, hollow pipe crossings, plates with countersunk holes and slots, blocks with skewed
cylinders, wedges and cones, gears, stepped shafts with keyways, open housings with ribs and bosses, toruses and trays with
steps, lenses and cut spheres, forks. Each is one solid of Open CASCADE, meshed by Gmsh (both in the package gmsh).
"""
import argparse
import math
import os
import random

import gmsh


def box(x, y, z, dx, dy, dz):
    return (3, gmsh.model.occ.addBox(x, y, z, dx, dy, dz))


def cylinder(x, y, z, dx, dy, dz, radius):
    return (3, gmsh.model.occ.addCylinder(x, y, z, dx, dy, dz, radius))


def cone(x, y, z, dx, dy, dz, first, last):
    return (3, gmsh.model.occ.addCone(x, y, z, dx, dy, dz, first, last))


def sphere(x, y, z, radius):
    return (3, gmsh.model.occ.addSphere(x, y, z, radius))


def fuse(*parts):
    return gmsh.model.occ.fuse([parts[0]], list(parts[1:]))[0][0]


def cut(part, *tools):
    return gmsh.model.occ.cut([part], list(tools))[0][0]


def turn(part, point, axis, angle):
    gmsh.model.occ.rotate([part], *point, *axis, angle)
    return part


def prism(points, height):
    """A polygon in the plane z = 0, moved up."""
    occ = gmsh.model.occ
    tags = [occ.addPoint(x, y, 0) for x, y in points]
    lines = [occ.addLine(a, b) for a, b in zip(tags, tags[1:] + tags[:1])]
    face = occ.addPlaneSurface([occ.addCurveLoop(lines)])
    return next(entity for entity in occ.extrude([(2, face)], 0, 0, height) if entity[0] == 3)


def bracket(rng):
    thick, width, length = rng.uniform(.08, .25), rng.uniform(.4, 1), rng.uniform(.6, 1.2)
    part = fuse(box(0, 0, 0, 1, width, thick), box(0, 0, 0, thick, width, length))
    if rng.random() < .6:
        rib = prism([(0, 0), (rng.uniform(.4, .9), 0), (0, rng.uniform(.4, .6))], thick * .8)
        turn(rib, (0, 0, 0), (1, 0, 0), math.pi / 2)
        gmsh.model.occ.translate([rib], 0, width / 2 + .4 * thick, thick * .5)
        part = fuse(part, rib)
    hole = rng.uniform(.06, .12)
    return cut(part, *(cylinder(.75, width * t, -1, 0, 0, 3, hole) for t in (.22, .78)),
               cylinder(-1, width / 2, length * .8, 3, 0, 0, hole) if length > .85 else
               cylinder(.45, width * .22, -1, 0, 0, 3, hole * .8))


def flange(rng):
    height, hub = rng.uniform(.1, .25), rng.uniform(.35, .5)
    part = fuse(cylinder(0, 0, 0, 0, 0, height, 1), cylinder(0, 0, 0, 0, 0, height + rng.uniform(.2, .8), hub))
    if rng.random() < .5:
        part = fuse(part, cone(0, 0, height, 0, 0, .2, hub + .15, hub))
    count, radius = rng.randint(3, 8), (1 + hub) / 2 + .05
    angles = [2 * math.pi * k / count for k in range(count)]
    return cut(part, cylinder(0, 0, -1, 0, 0, 4, hub * rng.uniform(.5, .85)),
               *(cylinder(radius * math.cos(a), radius * math.sin(a), -1, 0, 0, 3, rng.uniform(.05, .08)) for a in angles))


def crossing(rng):
    outer, other, wall = .3, rng.uniform(.15, .29), rng.uniform(.04, .1)
    angle = rng.uniform(35, 90) * math.pi / 180
    way = (math.cos(angle), math.sin(angle), 0)
    length = 1.2
    part = fuse(cylinder(-1, 0, 0, 2, 0, 0, outer), cylinder(0, 0, 0, *(length * w for w in way), other))
    if rng.random() < .3:
        return part
    return cut(part, cylinder(-2, 0, 0, 4, 0, 0, outer - wall), cylinder(0, 0, 0, *(2 * length * w for w in way), other - wall))


def plate(rng):
    height = rng.uniform(.08, .3)
    part = box(0, 0, 0, 1.6, 1, height)
    tools = []
    for x, y in ((.2, .2), (1.4, .2), (1.4, .8), (.2, .8))[:rng.randint(2, 4)]:
        radius = rng.uniform(.05, .08)
        tools += [cylinder(x, y, -1, 0, 0, 3, radius)]
        tools += [cone(x, y, height - .3 * height, 0, 0, .3 * height, radius, radius + .05) if rng.random() < .5 else
                  cylinder(x, y, height * .5, 0, 0, 1, radius * 1.6)]
    length = rng.uniform(.3, .7)
    slot = fuse(box(.8 - length / 2, .45, -1, length, .1, 3), cylinder(.8 - length / 2, .5, -1, 0, 0, 3, .05),
                cylinder(.8 + length / 2, .5, -1, 0, 0, 3, .05))
    return cut(part, slot, *tools)


def skewed(rng):
    part = box(0, 0, 0, 1, rng.uniform(.7, 1.3), rng.uniform(.5, 1))
    tools = []
    for k in range(rng.randint(1, 3)):
        tilt = rng.uniform(0, 40) * math.pi / 180
        around = rng.uniform(0, 2 * math.pi)
        way = (math.sin(tilt) * math.cos(around), math.sin(tilt) * math.sin(around), math.cos(tilt))
        centre = (rng.uniform(.3, .7), rng.uniform(.25, .45), .4)
        tools.append(cylinder(*(c - 3 * w for c, w in zip(centre, way)), *(6 * w for w in way), rng.uniform(.08, .2)))
    if rng.random() < .5:
        pin = cylinder(.5, .5, .3, rng.uniform(-.5, .5), rng.uniform(-.3, .3), 1.2, .15)
        return cut(fuse(part, pin), tools[0])
    return cut(part, *tools)


def wedge(rng):
    kind = rng.randrange(4)
    if kind == 0:
        return prism([(0, 0), (1, 0), (rng.uniform(.1, .9), math.tan(rng.uniform(18, 40) * math.pi / 180) * .5)], rng.uniform(.4, 1))
    if kind == 1:
        return fuse(cone(0, 0, 0, 0, 0, rng.uniform(.6, 1.5), .6, 0), cylinder(0, 0, -.4, 0, 0, .4, .6))
    if kind == 2:
        return cut(cone(0, 0, 0, 0, 0, 1, .7, rng.uniform(.1, .4)), box(rng.uniform(-.1, .3), -2, -1, 3, 4, 4))
    part = box(0, 0, 0, 1, 1, .5)
    knife = turn(box(-2, -1, 0, 5, 3, 2), (0, 0, rng.uniform(.05, .2)), (rng.uniform(.2, 1), rng.uniform(-.5, .5), 0),
                 rng.uniform(15, 35) * math.pi / 180)
    gmsh.model.occ.translate([knife], 0, 0, .3)
    return cut(part, knife)


def gear(rng):
    teeth, depth = rng.randint(6, 14), rng.uniform(.12, .25)
    points = []
    for k in range(teeth):
        for part, radius in ((-.32, 1 - depth), (-.18, 1), (.18, 1), (.32, 1 - depth)):
            angle = 2 * math.pi * (k + part) / teeth
            points.append((radius * math.cos(angle), radius * math.sin(angle)))
    height = rng.uniform(.2, .6)
    part = prism(points, height)
    part = cut(part, cylinder(0, 0, -1, 0, 0, 3, rng.uniform(.2, .4)))
    return cut(part, box(0, -.06, -1, .48, .12, 3)) if rng.random() < .5 else part


def shaft(rng):
    z, parts, radius = 0, [], .3
    for k in range(rng.randint(2, 4)):
        length = rng.uniform(.3, .8)
        parts.append(cylinder(0, 0, z, 0, 0, length, radius))
        z += length
        radius = max(.12, radius + rng.choice((-.08, -.05, .06)))
    parts.append(cone(0, 0, z, 0, 0, .05, radius, radius - .05))
    part = fuse(*parts)
    key = box(-.05, .08, rng.uniform(.05, .15), .1, 1, .3)
    return cut(part, key)


def housing(rng):
    wall = rng.uniform(.05, .12)
    part = cut(box(0, 0, 0, 1.2, .8, .5), box(wall, wall, wall, 1.2 - 2 * wall, .8 - 2 * wall, 1))
    bosses = [cylinder(x, y, wall / 2, 0, 0, rng.uniform(.2, .3), .08) for x, y in ((.25, .25), (.95, .55))]
    part = fuse(part, *bosses, box(.6, wall / 2, wall / 2, wall * .8, .8 - wall, rng.uniform(.12, .25)))
    tools = [cylinder(x, y, -1, 0, 0, 3, .04) for x, y in ((.25, .25), (.95, .55))]
    if rng.random() < .6:
        tools.append(cylinder(-1, .4, .3, 3, 0, 0, .1))
    return cut(part, *tools)


def stepped(rng):
    if rng.random() < .5:
        torus, step = gmsh.model.occ.addTorus, rng.uniform(.02, .2)
        other = turn((3, torus(0, 0, step, 1, .35, -1, math.pi)), (0, 0, 0), (0, 0, 1), math.pi)
        return fuse((3, torus(0, 0, 0, 1, .35, -1, math.pi)), other)
    part = cut(box(0, 0, 0, 1.4, 1, .4), box(.15, .15, .15, 1.1, .7, 1))
    return fuse(part, box(.15, .15, .1, rng.uniform(.3, .8), rng.uniform(.02, .7), rng.uniform(.1, .2)))


def lens(rng):
    kind = rng.randrange(3)
    if kind == 0:
        return gmsh.model.occ.intersect([sphere(0, 0, 0, 1)], [sphere(rng.uniform(.5, 1.1), 0, 0, 1)])[0][0]
    if kind == 1:
        return cut(sphere(0, 0, 0, 1), box(rng.uniform(.1, .5), -2, -2, 4, 4, 4), box(-2, -2, rng.uniform(.2, .6), 4, 4, 4))
    return cut(box(-1, -.7, 0, 2, 1.4, .6), sphere(rng.uniform(-.4, .4), rng.uniform(-.3, .3), .7, rng.uniform(.3, .5)),
               sphere(1.1, .8, .2, .4))


def fork(rng):
    arm, width = rng.uniform(.15, .25), .6
    part = fuse(box(-.6, -width / 2, 0, .6, width, .7), box(0, -width / 2, 0, .8, width, arm),
                box(0, -width / 2, .7 - arm, .8, width, arm), cylinder(.8, 0, 0, 0, 0, arm, width / 2),
                cylinder(.8, 0, .7 - arm, 0, 0, arm, width / 2))
    hole = rng.uniform(.1, .2)
    part = cut(part, cylinder(.8, 0, -1, 0, 0, 3, hole), cylinder(-2, 0, .35, 2.2, 0, 0, rng.uniform(.1, .2)))
    return part


FAMILIES = [bracket, flange, crossing, plate, skewed, wedge, gear, shaft, housing, stepped, lens, fork]


def write_part(index, path):
    gmsh.model.add(str(index))
    FAMILIES[index % len(FAMILIES)](random.Random(index))
    gmsh.model.occ.synchronize()
    for dimension in (0, 1, 2):
        for entity in gmsh.model.getEntities(dimension):
            if not gmsh.model.getAdjacencies(*entity)[0].size:
                gmsh.model.removeEntities([entity])
    solids = gmsh.model.getEntities(3)
    if len(solids) != 1:
        raise ValueError(f'{len(solids)} solids')
    low, high = (gmsh.model.getBoundingBox(*solids[0])[k:k + 3] for k in (0, 3))
    diagonal = math.dist(low, high)
    gmsh.option.setNumber('Mesh.MeshSizeMax', diagonal / 25)
    gmsh.option.setNumber('Mesh.MeshSizeFromCurvature', 24)
    gmsh.model.mesh.setOutwardOrientation(solids[0][1])
    gmsh.model.mesh.generate(2)
    tags, points, _ = gmsh.model.mesh.getNodes()
    place = dict(zip(tags, points.reshape(-1, 3)))
    faces = []
    for _, surface in gmsh.model.getBoundary(solids, oriented=False):
        _, corners = gmsh.model.mesh.getElementsByType(2, surface)
        faces += map(tuple, corners.reshape(-1, 3))
    used = sorted({v for face in faces for v in face})
    number = {tag: k for k, tag in enumerate(used)}
    with open(path, 'w') as file:
        file.write(f'OFF\n{len(used)} {len(faces)} 0\n')
        file.writelines('%.17g %.17g %.17g\n' % tuple(place[tag]) for tag in used)
        file.writelines('3 %d %d %d\n' % tuple(number[tag] for tag in face) for face in faces)
    gmsh.model.remove()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder')
    parser.add_argument('--count', type=int, default=24)
    parser.add_argument('--first', type=int, default=0)
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    gmsh.initialize()
    gmsh.option.setNumber('General.Terminal', 0)
    for index in range(options.first, options.first + options.count):
        name = f'{index:03d}-{FAMILIES[index % len(FAMILIES)].__name__}.off'
        try:
            write_part(index, os.path.join(options.folder, name))
            print(name, flush=True)
        except Exception as error:      # Gmsh raises no other class
            print(f'{name} left out: {error}', flush=True)
            gmsh.model.remove()
    gmsh.finalize()


if __name__ == '__main__':
    main()
