# SPDX-License-Identifier: Apache-2.0
"""The scripts of examples/python run, and their pictures show something."""

from __future__ import annotations

import re
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

import boxwood as bw

FOLDER = Path(__file__).parents[2] / "examples" / "python"
TABLE = (FOLDER.parent / "README.md").read_text()
SCRIPTS = re.findall(r"^\| .*\(python/(\w+)\.py\)", TABLE, re.M)


def read_png(path):
    """The pixels of a PNG with 8 bits a channel, as Image.save writes them."""
    data = path.read_bytes()
    place, packed = 8, b""
    while place < len(data):
        (length,) = struct.unpack_from(">I", data, place)
        kind, body = data[place + 4 : place + 8], data[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack_from(">IIBB", body)
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    assert depth == 8
    channels = {2: 3, 6: 4}[color]
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, -1)
    return width, height, rows[:, 1:].reshape(height, width, channels)


def run(script, *arguments, folder):
    return subprocess.run(
        [sys.executable, FOLDER / f"{script}.py", *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def test_there_are_examples():
    assert len(SCRIPTS) >= 6


def test_quick_start_writes_a_mesh_and_its_picture(tmp_path):
    done = run("quick_start", tmp_path, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(bw.load(tmp_path / "sphere.ply").faces) == 5120
    width, height, pixels = read_png(tmp_path / "sphere.png")
    assert (width, height) == (320, 240)
    assert len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)) > 10


@pytest.mark.parametrize("script", SCRIPTS)
def test_example_makes_a_picture_without_arguments(script, tmp_path):
    done = run(script, "--width", "120", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(f"{script}.png: ")
    width, height, pixels = read_png(tmp_path / f"{script}.png")
    assert width == 120 and height in (40, 90)
    assert len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)) > 20


@pytest.mark.parametrize("script", SCRIPTS)
def test_example_takes_a_mesh_file(script, tmp_path):
    bw.generate("torus_knot", 2000).save(tmp_path / "knot.ply")
    done = run(script, "knot.ply", "--up", "z", "--width", "60", "-o", "a.png", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "a.png").exists()
