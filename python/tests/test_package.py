# SPDX-License-Identifier: Apache-2.0
"""The package as others meet it: its types, and what it needs."""

from __future__ import annotations

import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

import boxwood as bw

FOLDER = Path(bw.__file__).parent


def test_the_stub_is_what_the_compiled_part_says(tmp_path):
    pytest.importorskip("nanobind")
    command = [sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "boxwood._core"]
    subprocess.run([*command, "-o", tmp_path / "_core.pyi"], check=True)
    assert (tmp_path / "_core.pyi").read_text() == (FOLDER / "_core.pyi").read_text()


def test_types_are_strict(tmp_path):
    pytest.importorskip("mypy")
    project = FOLDER.parent.parent / "pyproject.toml"
    if not project.exists():
        pytest.skip("its settings are beside the sources only")
    command = [sys.executable, "-m", "mypy", "--strict", "-p", "boxwood"]
    command += ["--cache-dir", str(tmp_path), "--config-file", str(project)]
    found = subprocess.run(command, capture_output=True, text=True, cwd=project.parent)
    assert found.returncode == 0, found.stdout


def test_numpy_alone_is_needed():
    """Of all that isn't Python's own."""
    program = "import sys, boxwood; print(*{name.split('.')[0] for name in sys.modules})"
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    others = set()
    for name in loaded.stdout.split():
        spec = find_spec(name) if name in sys.modules or name.isidentifier() else None
        if spec is not None and "site-packages" in (spec.origin or ""):
            others.add(name)
    # Some installations load things of their own at each start.
    bare = subprocess.run(
        [sys.executable, "-c", "import sys; print(*sys.modules)"], capture_output=True, text=True
    )
    others -= {name.split(".")[0] for name in bare.stdout.split()}
    assert others - {"boxwood"} == {"numpy"}


def test_the_version_is_that_of_the_project():
    project = FOLDER.parent.parent / "pyproject.toml"
    if not project.exists():
        pytest.skip("it is beside the sources only")
    assert f'version = "{bw.__version__}"' in project.read_text()


def test_all_names_are_there():
    assert sorted(bw.__all__) == bw.__all__
    assert all(hasattr(bw, name) for name in bw.__all__)
