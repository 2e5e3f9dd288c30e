"""The annotations of the package agree with one another and with the stubs of the raw layer: `mypy --strict` finds nothing."""

import os
import shutil
import subprocess
import sys
import tempfile


def main() -> None:
    mypy = shutil.which("mypy")
    if mypy is None:
        print("there is no mypy: types are not checked")
        sys.exit(77)  # what Meson takes for "skipped"
    with tempfile.TemporaryDirectory() as folder:
        # A program of a user's: what is annotated as an array or a number is seen as one, and misuse is found.
        program = os.path.join(folder, "program.py")
        with open(program, "w", encoding="utf-8") as file:
            file.write("import numpy as np\n"
                       "from orbicube import trust_region\n"
                       "result = trust_region.minimize(lambda x: float(x @ x), np.ones(2))\n"
                       "value: float = result.value\n"
                       "wrong: str = result.value\n"
                       "trust_region.minimize(lambda x: float(x @ x), np.ones(2), method='two-radius', max_evaluations=10)\n"
                       "trust_region.minimize(lambda x: float(x @ x), np.ones(2), max_evaluation=10)\n"
                       "trust_region.minimize(lambda x: float(x @ x), np.ones(2), restarts='many')\n")
        package = os.path.abspath(sys.argv[1])
        options = ["--strict", "--cache-dir", os.path.join(folder, "cache")]
        subprocess.run([mypy, *options, package], check=True)
        said = subprocess.run([mypy, *options, program], capture_output=True, text=True, check=False, cwd=folder,
                              env={**os.environ, "MYPYPATH": os.path.dirname(package)}).stdout
        assert said.count("error:") == 4 and all(f"program.py:{line}: error" in said for line in (5, 6, 7, 8)), said


if __name__ == "__main__":
    main()
