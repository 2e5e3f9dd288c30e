"""What tests of studies share: comparing folders."""
import os


def files_in(folder):
    """The bytes of all files, by name."""
    result = {}
    for place, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(place, name), "rb") as file:
                result[os.path.relpath(os.path.join(place, name), folder)] = file.read()
    return result
