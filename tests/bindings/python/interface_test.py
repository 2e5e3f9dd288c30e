"""The package as a whole: layouts, annotations, how libraries are found, all functions used."""

import ast
import ctypes
import glob
import importlib
import json
import os
import subprocess
import sys
import unittest

import orbicube

PACKAGE = os.path.dirname(os.path.abspath(orbicube.__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(PACKAGE)))
sys.path.insert(0, os.path.join(ROOT, "scripts"))
from raw.c_types import Api  # noqa: E402

with open(os.path.join(ROOT, "api.json"), encoding="utf-8") as file:
    API = Api(json.load(file))
# Left to the layer below: what only a program in C can lend or wants.
NOT_WRAPPED = {"obc_base_version", "obc_gltf_write_surface", "obc_mesh_write_surface", "obc_quaternion_multiply",
               "obc_quaternion_normalize", "obc_quaternion_slerp", "obc_quaternion_rotate", "obc_quaternion_to_matrix",
               "obc_quaternion_from_matrix", "obc_quaternion_symmetric_distance", "obc_quaternion_symmetric_sine_square",
               "obc_quaternion_symmetric_matching", "obc_quaternion_cube_nearest", "obc_harmonics_size",
               "obc_sphere_optimizer_minimize", "obc_trust_region_minimize", "obc_projected_gradient_minimize"}
SOLVERS = ("trust_region", "projected_gradient", "sphere_optimizer")
BY_NAME = {f"obc_{solver}_{end}" for solver in SOLVERS
           for end in ("step", "tell", "get_result", "stop_name", "save_size", "save", "destroy")}


def modules():
    for path in sorted(glob.glob(os.path.join(PACKAGE, "*.py"))):
        name = os.path.splitext(os.path.basename(path))[0]
        yield name, importlib.import_module("orbicube" if name == "__init__" else "orbicube." + name)


class Interface(unittest.TestCase):
    def test_structs_lie_in_memory_as_in_c(self):
        checked = 0
        for library in API.libraries:
            module = importlib.import_module("orbicube.raw." + library)
            for struct in API.libraries[library]["structs"]:
                size, alignment, offsets = API.layout(struct["name"], ctypes.sizeof(ctypes.c_void_p))
                kind = getattr(module, struct["name"])
                self.assertEqual((ctypes.sizeof(kind), ctypes.alignment(kind)), (size, alignment), struct["name"])
                for field, offset in offsets:
                    self.assertEqual(getattr(kind, field).offset, offset, f"{struct['name']}.{field}")
                    checked += 1
        self.assertGreater(checked, 200)

    def test_every_function_can_be_called(self):
        for library in API.libraries:
            module = importlib.import_module("orbicube.raw." + library)
            for function in API.libraries[library]["functions"]:
                try:
                    found = getattr(module, function["name"])
                except ImportError:
                    self.assertEqual(library, "tetrahedra")  # the one that may be left out
                    break
                self.assertEqual(len(found.argtypes), len(function["parameters"]))

    def test_every_function_has_a_place_in_the_layer_that_people_use(self):
        text = ""
        for path in glob.glob(os.path.join(PACKAGE, "*.py")):
            with open(path, encoding="utf-8") as file:
                text += file.read()
        names = {f["name"] for library in API.libraries.values() for f in library["functions"]}
        missing = sorted(name for name in names - NOT_WRAPPED - BY_NAME if "raw." + name not in text)
        # What a header has gained shows up here; it can be called through orbicube.raw until it has a place.
        if missing:
            print("only in orbicube.raw:", ", ".join(missing))
        self.assertLess(len(missing), len(names) // 4)
        self.assertLessEqual(NOT_WRAPPED, names, "names that no header declares")

    def test_everything_public_is_annotated_and_documented(self):
        for name, module in modules():
            self.assertTrue(module.__doc__, name)
            with open(module.__file__, encoding="utf-8") as file:
                tree = ast.parse(file.read())
            for node in ast.walk(tree):
                if isinstance(node, ast.FunctionDef):
                    self.assertIsNotNone(node.returns, f"{name}.{node.name} says not what it answers")
                    for argument in node.args.args + node.args.kwonlyargs:
                        if argument.arg not in ("self", "cls"):
                            self.assertIsNotNone(argument.annotation, f"{name}.{node.name}: {argument.arg}")
        for path in glob.glob(os.path.join(PACKAGE, "raw", "*.pyi")):
            with open(path, encoding="utf-8") as file:
                ast.parse(file.read())

    def test_errors_are_also_what_python_calls_them(self):
        self.assertTrue(issubclass(orbicube.InvalidArgument, ValueError))
        self.assertTrue(issubclass(orbicube.OutOfMemory, MemoryError))
        import pickle
        again = pickle.loads(pickle.dumps(orbicube.FileError(-9, "io", "no such file")))
        self.assertEqual((again.status, again.kind, again.message), (-9, "io", "no such file"))

    def test_a_library_that_is_missing_is_named(self):
        said = subprocess.run([sys.executable, "-c", "import orbicube; orbicube.mesh.version()"], capture_output=True,
                              text=True, env={**os.environ, "ORBICUBE_LIBRARIES": "/nonexistent"}, check=False)
        if said.returncode == 0:
            self.skipTest("the system has the libraries")
        self.assertIn("ImportError: orbicube.", said.stderr)
        self.assertIn("/nonexistent", said.stderr)

    def test_a_solver_loads_nothing_but_itself_and_base(self):
        program = ("import orbicube.trust_region as t; t.version(); "
                   "print(*sorted(line.rsplit('/')[-1].split('.')[0] for line in set(l.split()[-1] for l in "
                   "open('/proc/self/maps')) if 'liborbicube' in line))")
        said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said.split(), ["liborbicube-base", "liborbicube-trust-region"])

    def test_tqdm_is_used_when_it_is_there(self):
        program = """if True:
            import sys, types
            bars = []
            class Tqdm:
                def __init__(self, leave): self.n, self.most, self.phases, self.open = 0, 0, [], True; bars.append(self)
                def set_description(self, phase, refresh): self.phases.append(phase)
                def reset(self, total): self.n = 0
                def update(self, more): assert more >= 0; self.n += more; self.most = max(self.most, self.n)
                def close(self): self.open = False
            module = types.ModuleType("tqdm.auto"); module.tqdm = Tqdm
            sys.modules["tqdm"] = types.ModuleType("tqdm"); sys.modules["tqdm.auto"] = module
            import orbicube
            orbicube.sphere_map.compute(orbicube.mesh.make("sphere", 500), progress=True)
            assert len(bars) == 1 and not bars[0].open, bars  # one line of a terminal, however many phases
            assert len(bars[0].phases) > 3 and bars[0].most > 0
            del sys.modules["tqdm.auto"]; sys.modules["tqdm"] = None
            orbicube.sphere_map.compute(orbicube.mesh.make("sphere", 500), progress=True)
        """
        subprocess.run([sys.executable, "-c", program], check=True)


if __name__ == "__main__":
    unittest.main()
