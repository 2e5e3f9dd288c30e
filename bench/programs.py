"""What the Python programs of the benchmarks share: the output of a program, kept from an earlier run, and modules of problems."""
import ctypes
import os
import pathlib
import platform
import subprocess

DOUBLES = ctypes.POINTER(ctypes.c_double)


def measured(path, command, again):
    """Returns the output of a command, which is kept in the file `path`: that of an earlier run if there is one."""
    if again or not os.path.exists(path):
        print("running", " ".join(command), flush=True)
        output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        with open(path, "w", encoding="utf-8") as file:
            file.write(output)
    with open(path, encoding="utf-8") as file:
        return file.read()


def processor():
    """Returns the name of the processor."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def pointer(array):
    """Returns the address of a numpy array of doubles, as the functions of a module take it."""
    return array.ctypes.data_as(DOUBLES)


def load_problems(path, prefix="bench", make=(), sizes=(), numbers=(), arrays=None):
    """
    Loads a module of problems (problem_functions.h). `make`: types of the arguments of its function make but for the index. Its functions
    of a problem besides: `sizes` return a count, `numbers` a double, and `arrays` take the given number of arrays.
    """
    library = ctypes.CDLL(str(pathlib.Path(path).resolve()))

    def function(name, result, *arguments):
        called = getattr(library, f"{prefix}_{name}")
        called.restype, called.argtypes = result, arguments

    function("make", ctypes.c_void_p, ctypes.c_size_t, *make)
    function("free", None, ctypes.c_void_p)
    function("evaluate", ctypes.c_double, ctypes.c_void_p, DOUBLES, DOUBLES)
    if hasattr(library, f"{prefix}_name"):
        function("name", ctypes.c_char_p, ctypes.c_void_p)
    for name in ("count", "problems"):  # of all problems; of one where it is among the sizes
        if hasattr(library, f"{prefix}_{name}") and name not in sizes:
            function(name, ctypes.c_size_t)
    for name in sizes:
        function(name, ctypes.c_size_t, ctypes.c_void_p)
    for name in numbers:
        function(name, ctypes.c_double, ctypes.c_void_p)
    for name, count in (arrays or {}).items():
        function(name, None, ctypes.c_void_p, *[DOUBLES] * count)
    return library
