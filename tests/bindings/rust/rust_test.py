#!/usr/bin/env python3
"""The Rust crates: their tests with and without features, the example, the page, and the packages as they would be published.

    rust_test.py CARGO TARGET     (environment: ORBICUBE_LIBRARIES, ORBICUBE_PROBLEMS)

Everything is tried without a network and, where they are installed, with the cargo and rustc of Debian, the oldest ones
that are supported.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
RUST = os.path.join(ROOT, "bindings", "rust")


def main():
    cargo, target = sys.argv[1:]
    libraries = os.environ["ORBICUBE_LIBRARIES"]
    environment = dict(os.environ, CARGO_TARGET_DIR=target, CARGO_NET_OFFLINE="true", RUSTFLAGS="-D warnings",
                       LD_LIBRARY_PATH=libraries + os.pathsep + os.environ.get("LD_LIBRARY_PATH", ""))
    for variable, name in (("RUSTC", "rustc"), ("RUSTDOC", "rustdoc")):
        beside = os.path.join(os.path.dirname(cargo), name)
        if os.path.exists(beside):
            environment[variable] = beside
    has_tetrahedra = os.path.exists(os.path.join(libraries, "liborbicube-tetrahedra.so"))

    def run(*command, cwd=RUST, without=(), **more):
        print("$", *command, flush=True)
        subprocess.run([cargo if word == "cargo" else word for word in command], check=True, cwd=cwd,
                       env={name: value for name, value in {**environment, **more}.items() if name not in without})

    run("cargo", "--version")
    run("cargo", "test", "--quiet", *(["--all-features"] if has_tetrahedra else []))
    # One library alone links nothing but itself and base.
    run("cargo", "test", "--quiet", "-p", "orbicube", "--lib", "--no-default-features", "--features", "trust_region")
    run("cargo", "run", "--quiet", "--example", "solvers")

    # A library that Meson builds from the tree, and that is linked statically.
    run("cargo", "run", "--quiet", "-j1", "-p", "orbicube", "--example", "smallest", "--no-default-features", "--features",
        "trust_region", without=("ORBICUBE_LIBRARIES", "LD_LIBRARY_PATH"), ORBICUBE_FROM_TREE="1",
        CARGO_TARGET_DIR=os.path.join(target, "from-tree"))

    # The page's programs, as documentation tests.
    run("cargo", "build", "--quiet", "-p", "orbicube")
    newest = os.path.join(target, "debug", "liborbicube.rlib")
    run(environment.get("RUSTDOC", "rustdoc"), "--test", "--edition", "2021", os.path.join(ROOT, "docs", "rust.md"),
        "-L", "dependency=" + os.path.join(target, "debug", "deps"), "--extern", "orbicube=" + newest,
        "-L", "native=" + libraries)

    # Packages hold all that a build needs: the first is made as it would be published; the second, whose dependency is in no
    # registry yet, is put together from the files that it would have, beside the first.
    run("cargo", "package", "--quiet", "-p", "orbicube-sys", "--allow-dirty")
    with tempfile.TemporaryDirectory() as folder:
        for name in ("orbicube-sys", "orbicube"):
            listed = subprocess.run([cargo, "package", "-p", name, "--list", "--allow-dirty"], cwd=RUST, env=environment,
                                    check=True, capture_output=True, text=True).stdout.split()
            for file in listed:
                source = os.path.join(RUST, name, "Cargo.toml" if file == "Cargo.toml.orig" else file)
                if file != "Cargo.toml" and os.path.exists(source):
                    path = os.path.join(folder, name, "Cargo.toml" if file == "Cargo.toml.orig" else file)
                    os.makedirs(os.path.dirname(path), exist_ok=True)
                    shutil.copy(source, path)
        with open(os.path.join(folder, "orbicube", "src", "lib.rs"), encoding="utf-8") as file:
            modules = re.findall(r"^(?:pub )?mod (\w+);", file.read(), re.MULTILINE)
        missing = [name for name in modules if not os.path.exists(os.path.join(folder, "orbicube", "src", name + ".rs"))]
        if missing:
            sys.exit(f"the package has not {missing}")
        run("cargo", "build", "--quiet", cwd=os.path.join(folder, "orbicube"),
            CARGO_TARGET_DIR=os.path.join(target, "packaged"))


if __name__ == "__main__":
    main()
