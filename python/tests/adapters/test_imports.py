# SPDX-License-Identifier: Apache-2.0
"""The adapters load no library before it is needed."""

from __future__ import annotations

import subprocess
import sys

PROGRAM = """
import sys
import boxwood, boxwood.meshio, boxwood.open3d, boxwood.pyvista, boxwood.trimesh
print([name for name in ("meshio", "open3d", "pyvista", "trimesh") if name in sys.modules])
"""


def test_importing_boxwood_and_its_adapters_imports_no_other_library():
    found = subprocess.run(
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=True
    )
    assert found.stdout.strip() == "[]"
