# SPDX-License-Identifier: Apache-2.0
"""The quick start of docs/guide/python.md, for trying out an installed wheel: writes sphere.ply and
sphere.png into the folder given."""

import sys
from pathlib import Path

import numpy as np

import boxwood as bw

folder = Path(sys.argv[1])
bw.generate("icosphere", 5120).save(folder / "sphere.ply")

mesh = bw.load(folder / "sphere.ply")
scene = bw.Scene(mesh)
origins, directions = bw.PinholeCamera.framing(scene, width=320, height=240).rays()
hits = scene.closest_hit(origins, directions)
assert hits.hit.any() and not hits.hit.all()
assert np.allclose(
    np.linalg.norm(origins + hits.t[hits.hit][:, None] * directions[hits.hit], axis=1), 1, atol=0.01
)
assert scene.signed_distance([0, 0, 0]).distance < -0.99
bw.render(scene, width=320, height=240).save(folder / "sphere.png")
print(f"{scene!r} in {bw.__file__}: {hits.hit.mean():.0%} of the camera's rays hit")
