# SPDX-License-Identifier: Apache-2.0
"""A batch takes the memory of its arrays, and little besides."""

from __future__ import annotations

import subprocess
import sys

import pytest

RAYS = 1_000_000
PROGRAM = """
import sys
import numpy as np
import boxwood as bw

def kilobytes(what):
    # Of this program alone: getrusage would tell of the one that started it, too.
    lines = open("/proc/self/status").read().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(what))


dtype, one_origin, n = sys.argv[1], sys.argv[2] == "one", int(sys.argv[3])
# A small one, as the peak of a build would hide what a batch takes.
scene = bw.Scene(bw.generate("icosphere", 320))
rng = np.random.default_rng(1)
directions = rng.standard_normal((n, 3), dtype=dtype)
origins = np.zeros(3, dtype) if one_origin else rng.standard_normal((n, 3), dtype=dtype)
scene.closest_hit(origins[..., :3] if one_origin else origins[:5000], directions[:5000])
before = kilobytes("VmRSS:")
hits = scene.closest_hit(origins, directions)
after = kilobytes("VmHWM:")
results = sum(getattr(hits, name).nbytes for name in ("t", "triangle", "instance", "uv", "normal"))
print((after - before) * 1024 - results)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="sizes are told in another way elsewhere")
@pytest.mark.parametrize("dtype", ["float32", "float64"])
@pytest.mark.parametrize("origins", ["one", "many"])
def test_a_million_rays_take_their_arrays_and_64_mib(dtype, origins):
    program = [sys.executable, "-c", PROGRAM, dtype, origins, str(RAYS)]
    besides = int(subprocess.run(program, check=True, capture_output=True, text=True).stdout)
    print(f"{besides / 2**20:.1f} MiB besides the arrays")
    assert besides <= 64 * 2**20
