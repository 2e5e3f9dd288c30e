#!/usr/bin/env python3
"""What the command reads and writes at the edges of formats: notes told once, solids turned, float32.

    readers_test.py COMMAND
"""
import json
import math

from command import Glb, InFolder, kind_of, main, not_positive, read_obj, run

SOLID = """MeshVersionFormatted 2
Dimension 3
Vertices
8
0 0 0 0
1 0 0 0
1 1 0 0
0 1 0 0
0 0 1 0
1 0 1 0
1 1 1 0
0 1 1 0
Tetrahedra
5
1 4 2 5 1
2 4 3 7 1
2 6 5 7 1
4 7 5 8 1
2 5 4 7 1
End
"""


class Readers(InFolder):
    def written(self, name, text):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(text)
        return self.path(name)

    def notes(self, *arguments):
        report = self.path("report.json")
        done = run(*arguments, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            return json.load(file)["notes"]

    def scaled(self, name, *factors):
        """A made blob, each axis by its factor."""
        positions, triangles = read_obj(self.made("blob", 800))
        with open(self.path(name), "w", encoding="ascii") as file:
            file.writelines("v %r %r %r\n" % tuple(x * f for x, f in zip(p, factors)) for p in positions)
            file.writelines("f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles)
        return self.path(name), triangles

    def test_solids_whose_cells_are_all_inverted_are_turned_with_a_note(self):
        turned = self.written("turned.mesh", SOLID)
        for arguments in (("info", turned), ("convert", turned, self.path("out.vtk")),
                          ("frames", turned, "-o", self.path("out.frames"))):
            self.assertEqual(self.notes(*arguments), ["all 5 tetrahedra were inverted, and were reversed"])
        if "untangle" in run("--help").stdout:
            self.assertEqual(self.notes("untangle", turned, "-o", self.path("out.mesh")),
                             ["all 5 tetrahedra were inverted, and were reversed"])
        some = self.written("some.mesh", SOLID.replace("1 4 2 5 1", "1 2 4 5 1"))
        self.assertEqual(kind_of(run("info", some).stderr, some), "inverted-cell")

    def test_prisms_are_cut_and_cells_that_are_not_read_are_refused_also_quietly(self):
        mixed = SOLID.replace("\n8\n", "\n10\n", 1).replace("Tetrahedra", "0 0 2 0\n1 0 2 0\nTetrahedra")
        mixed = mixed.replace("End", "Prisms\n1\n5 8 9 6 7 10 1\nEnd")
        for first, second in (("4 2", "2 4"), ("4 3", "3 4"), ("6 5", "5 6"), ("7 5", "5 7"), ("5 4", "4 5")):
            mixed = mixed.replace(f" {first} ", f" {second} ")
        path = self.written("mixed.mesh", mixed)
        self.assertEqual(self.notes("info", path), ["1 prism was cut into 3 tetrahedra"])
        curved = self.written("curved.mesh", mixed.replace("Prisms\n1\n5", "PrismsP2\n1\n5"))
        for quiet in ((), ("--quiet",)):
            done = run("convert", curved, self.path("out.vtk"), *quiet)
            self.assertEqual((done.returncode, kind_of(done.stderr, curved)), (2, "unsupported"))
            self.assertIn("1 cell ", done.stderr)

    def test_weld_joins_the_cells_of_solids_and_is_told_once(self):
        apart = self.written("apart.mesh", "Vertices 8\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                                           "0 0 -1 0\nTetrahedra 2\n1 2 3 4 0\n5 7 6 8 0\nEnd\n")
        self.assertEqual(self.notes("info", apart), [])
        self.assertEqual(self.notes("info", apart, "--weld"), ["3 vertices were welded to others at the same position"])
        soup = self.path("soup.stl")
        self.assertEqual(run("convert", self.made("cube", 100), soup).returncode, 0)
        for name in ("soup.stl", "soup.obj", "soup.glb"):
            if name != "soup.stl":
                positions, triangles = read_obj(self.made("cube", 100))
                with open(self.path("soup.obj"), "w", encoding="ascii") as file:
                    for t in triangles:
                        file.writelines("v %r %r %r\n" % positions[v] for v in t)
                    file.writelines(f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(len(triangles)))
            if name == "soup.glb":
                self.assertEqual(run("convert", self.path("soup.obj"), self.path(name)).returncode, 0)
            notes = self.notes("info", self.path(name), "--weld")
            self.assertEqual(len([note for note in notes if "joined" in note or "welded" in note]), 1, notes)

    def test_the_endings_are_the_same_whole_list_for_reading_and_writing(self):
        other, cube = self.written("a.xyz", "0 0 0"), self.made("cube")
        for done in (run("info", other), run("convert", cube, self.path("b.xyz"))):
            self.assertEqual(done.returncode, 2)
            self.assertIn("the ending '.xyz' is none of .obj .off .ply .stl .mesh .vtk .msh .white .inp .vtp .vtu .gii .glb .gltf", done.stderr)

    def test_spheres_of_long_shapes_are_on_the_sphere_and_their_surface_is_that_of_the_file(self):
        for name, factors in (("long", (1000, 1, 1)), ("flat", (1000, 1000, 1)), ("large", (3e4, 3e4, 3e4)),
                              ("tiny", (1e-20, 1e-20, 1e-20)), ("huge", (1e20, 1e20, 1e20)), ("tinier", (1e-35,) * 3)):
            path, triangles = self.scaled(f"{name}.obj", *factors)
            out = self.path(f"{name}.glb")
            done = run("sphere", path, "-o", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            glb = Glb(out)
            for in_float32 in (False, True):
                sphere = glb.sphere(in_float32)
                self.assertEqual(not_positive(sphere, triangles), 0)
                self.assertLess(max(abs(math.hypot(*p) - 1) for p in sphere), 1e-6, name)
            self.assertEqual(run("convert", out, self.path("back.obj")).returncode, 0)
            positions, back = read_obj(path)[0], read_obj(self.path("back.obj"))[0]
            size = max(max(map(abs, p)) for p in positions)
            self.assertLess(max(math.dist(p, q) for p, q in zip(positions, back)), 1e-6 * size, name)

    def test_what_float32_cannot_hold_is_refused(self):
        for factor in (1e-100, 1e-300, 1e100):
            path, _ = self.scaled("shape.obj", factor, factor, factor)
            for verb, out in (("sphere", "x.gltf"), ("sphere", "x.glb"), ("convert", "x.glb"), ("convert", "x.stl")):
                target = [self.path(out)] if verb == "convert" else ["-o", self.path(out)]
                done = run(verb, path, *target)
                self.assertEqual((done.returncode, kind_of(done.stderr, self.path(out))), (2, "unsupported"), done.stderr)
                self.assertIn("float32", done.stderr)


if __name__ == "__main__":
    main()
