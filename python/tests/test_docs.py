# SPDX-License-Identifier: Apache-2.0
"""The Python that the pages show runs: the blocks of a section, one after another."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import boxwood as bw

ROOT = Path(__file__).parents[2]
PAGES = ["python/README.md", "docs/guide/python.md", "docs/guide/python_from_others.md"]
OTHERS = re.compile(r"^import (trimesh|open3d|igl)", re.MULTILINE)
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks_by_section(page):
    for section in re.split(r"^#+ ", (ROOT / page).read_text(), flags=re.MULTILINE)[1:]:
        blocks = BLOCK.findall(section)
        if blocks:
            yield section.splitlines()[0], blocks


def run(blocks, names):
    for block in blocks:
        for library in OTHERS.findall(block):
            pytest.importorskip(library, exc_type=ImportError)
        exec(compile(block, "a block of the page", "exec"), names)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Where the files are that the pages name."""
    mesh = bw.generate("torus_knot", 2000)
    for name in ("dragon.ply", "part.off"):
        mesh.save(tmp_path / name)
    monkeypatch.chdir(tmp_path)


def test_readme_of_the_package_runs(folder):
    run([block for _, blocks in blocks_by_section(PAGES[0]) for block in blocks], {})
    assert Path("dragon.png").exists()


def test_guide_runs_from_top_to_bottom(folder):
    run([block for _, blocks in blocks_by_section(PAGES[1]) for block in blocks], {})
    for name in ("thickness.ply", "depth.png", "normals.png", "heat.png", "dragon.boxwood"):
        assert Path(name).exists()


SECTIONS = dict(blocks_by_section(PAGES[2]))


@pytest.mark.parametrize("section", SECTIONS)
def test_snippets_for_those_who_know_other_libraries_run(section, folder):
    run(SECTIONS[section], {})


def test_answers_are_those_of_trimesh(folder):
    names = {}
    run(SECTIONS["trimesh: rays"][:1], names)
    theirs = dict(names)
    run(SECTIONS["trimesh: rays"][1:], names)
    for name in ("first", "blocked", "inside"):
        assert (names[name] == theirs[name]).all(), name
    assert names["distance"] == pytest.approx(theirs["distance"])


def test_answers_are_those_of_libigl(folder):
    names = {}
    run(SECTIONS["libigl"][:1], names)
    theirs = dict(names)
    run(SECTIONS["libigl"][1:], names)
    for name in ("squared", "signed"):
        assert names[name] == pytest.approx(theirs[name]), name
    assert names["winding"] == pytest.approx(theirs["winding"], abs=0.02)
    assert names["hits"].counts[0] == len(theirs["hits"])
