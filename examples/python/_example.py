# SPDX-License-Identifier: Apache-2.0
"""What the examples have in common: their arguments."""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import boxwood as bw


@dataclass
class Given:
    """What an example works on, and where its picture goes."""

    mesh: bw.Mesh
    picture: Path
    width: int
    height: int
    up: str


def begin(about: str, mesh: bw.Mesh, up: str = "y") -> Given:
    """The mesh that the command line names, or else the given one."""
    parser = argparse.ArgumentParser(description=about.splitlines()[0])
    add = parser.add_argument
    add("mesh", nargs="?", help="a mesh file; without, one from a formula")
    add("-o", "--output", type=Path, default=Path(sys.argv[0]).stem + ".png", metavar="PICTURE")
    add("--width", type=int, default=960, help="of the picture, in pixels")
    add("--up", choices=["y", "z"], default=up, help="the mesh's axis that points upward")
    named = parser.parse_args()
    if named.mesh:
        mesh = bw.load(named.mesh)
    return Given(mesh, named.output, named.width, named.width * 3 // 4, named.up)
