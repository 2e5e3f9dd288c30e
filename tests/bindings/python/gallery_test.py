"""The gallery draws all its pictures, and there is something on them.

    gallery_test.py GALLERY.py
"""

import os
import subprocess
import sys
import tempfile

try:
    import matplotlib.image
    import mpl_toolkits.mplot3d  # noqa: F401
except ImportError as error:
    print("matplotlib is missing:", error)
    sys.exit(77)  # what Meson takes for "skipped"

with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, sys.argv[1], folder, "--triangles", "600"], check=True,
                   env={**os.environ, "MPLCONFIGDIR": folder})
    for name in ("sphere_map", "energy", "harmonics", "spectrum", "polycube"):
        picture = matplotlib.image.imread(os.path.join(folder, name + ".png"))
        assert picture.shape[0] > 200 and picture[..., :3].std() > 0.03, f"{name}: nothing to see"
