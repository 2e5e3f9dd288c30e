"""Conan 2 recipe of the libraries: conan create packaging/conan -o "orbicube/*:libraries=trust_region,mesh" """

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, rmdir
from conan.tools.gnu import PkgConfigDeps
from conan.tools.layout import basic_layout
from conan.tools.meson import Meson, MesonToolchain

# The libraries, each with those that it uses, as in the top meson.build, and with the packages that its sources include or link.
LIBRARIES = {
    "base": ([], []),
    "quaternion": (["base"], []),
    "sphere_optimizer": (["base"], []),
    "trust_region": (["base"], []),
    "projected_gradient": (["base"], []),
    "linear": (["base"], ["eigen"]),
    "harmonics": (["base", "linear"], ["eigen", "fast_float"]),
    "mesh": (["base"], ["eigen", "boost", "fast_float", "zlib"]),
    "gltf": (["base", "mesh"], ["eigen", "tinygltf", "nlohmann_json"]),
    "repair": (["base", "linear", "mesh"], ["eigen"]),
    "frame_field": (["base", "quaternion", "sphere_optimizer", "linear", "mesh"], ["eigen"]),
    "sphere_map": (["base", "linear", "mesh"], ["eigen", "stb", "libspng"]),
    "untangle": (["base", "linear", "mesh"], ["eigen"]),
    "polycube": (["base", "linear", "projected_gradient", "trust_region", "mesh", "untangle"], ["eigen"]),
    "correspondence": (["base", "harmonics", "mesh", "sphere_map", "untangle", "polycube"], ["eigen"]),
    "volume_map": (["base", "linear", "quaternion", "sphere_optimizer", "projected_gradient", "trust_region", "mesh", "frame_field", "untangle",
                    "polycube"], ["eigen"]),
    "hexmesh": (["base", "linear", "quaternion", "sphere_optimizer", "projected_gradient", "trust_region", "mesh", "frame_field", "untangle",
                 "polycube", "volume_map"], ["eigen"]),
}
VERSIONS = {"eigen": "3.4.0", "fast_float": "6.1.0", "boost": "1.81.0", "zlib": "[>=1.2.11 <2]", "tinygltf": "2.8.13", "nlohmann_json": "3.11.3",
            "stb": "cci.20230920", "libspng": "0.7.4"}
LINKED = {"zlib", "libspng"}


class Orbicube(ConanFile):
    name = "orbicube"
    version = "0.1.0"
    license = "Apache-2.0"
    description = "Maps of surfaces to spheres and polycubes, frame fields, hexahedral meshes, and the solvers underneath"
    topics = ("mesh", "parameterization", "polycube", "hexahedral", "optimization")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "libraries": ["ANY"]}
    default_options = {"shared": False, "fPIC": True, "libraries": "all"}

    def export_sources(self):
        tree = os.path.join(self.recipe_folder, os.pardir, os.pardir)
        for pattern in ("LICENSE", "meson.build", "meson_options.txt", "libs/*", "capi/*", "cli/meson.build", "bindings/cpp/*"):
            copy(self, pattern, tree, self.export_sources_folder, excludes=["capi/abi/released.json", "capi/abi/0*"])

    def configure(self):
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def layout(self):
        basic_layout(self)

    def _libraries(self):
        """Those of the option, with what they use, in the order of the table."""
        named = str(self.options.libraries).split(",")
        chosen = set(LIBRARIES) if named == ["all"] else {"base", *named}
        for name in reversed(list(LIBRARIES)):
            if name in chosen:
                chosen |= set(LIBRARIES[name][0])
        return [name for name in LIBRARIES if name in chosen]

    def validate(self):
        check_min_cppstd(self, 20)
        unknown = set(str(self.options.libraries).split(",")) - set(LIBRARIES) - {"all"}
        if unknown:
            raise ValueError("orbicube has no libraries " + ", ".join(sorted(unknown)))

    def requirements(self):
        for package in dict.fromkeys(package for name in self._libraries() for package in LIBRARIES[name][1]):
            self.requires(f"{package}/{VERSIONS[package]}", headers=True, libs=package in LINKED)

    def build_requirements(self):
        self.tool_requires("meson/[>=1.0]")
        self.tool_requires("ninja/[>=1.10]")

    def generate(self):
        toolchain = MesonToolchain(self)
        toolchain.project_options |= {"libraries": self._libraries(), "cli": "disabled", "tests": False, "examples": False, "tetgen": "disabled",
                                      "cholmod": "disabled", "meshoptimizer": "disabled"}
        toolchain.generate()
        PkgConfigDeps(self).generate()

    def build(self):
        meson = Meson(self)
        meson.configure()
        meson.build()

    def package(self):
        Meson(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        for folder in ("cmake", "pkgconfig"):  # Conan's generators write their own
            rmdir(self, os.path.join(self.package_folder, "lib", folder))

    def package_info(self):
        for name in self._libraries():
            uses, packages = LIBRARIES[name]
            component = self.cpp_info.components[name]
            component.libs = ["orbicube-" + name.replace("_", "-")]
            component.set_property("cmake_target_name", "orbicube::" + name)
            component.set_property("pkg_config_name", component.libs[0])
            component.requires = uses + [f"{package}::{package}" for package in packages if package in LINKED]
            if self.settings.os in ("Linux", "FreeBSD"):
                component.system_libs = ["m", "pthread", "stdc++"]
