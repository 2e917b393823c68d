# SPDX-License-Identifier: Apache-2.0
"""What benchmarks in Python have in common."""

from __future__ import annotations

import os
import platform
import subprocess
import time
from collections.abc import Callable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DRAGON = str(ROOT / "data/dragon_871k.off")


def timed(call: Callable[[], object]) -> tuple[float, object]:
    """Seconds, and what was returned."""
    start = time.perf_counter()
    result = call()
    return time.perf_counter() - start, result


def machine(packages: tuple[str, ...]) -> dict[str, object]:
    """Where the figures come from, with the versions of those packages that are there."""
    cpu = "unknown"
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            cpu = line.split(":", 1)[1].strip()
    commit = subprocess.run(
        ["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True
    ).stdout.strip()
    versions = {}
    for name in ("numpy", *packages):
        try:
            versions[name] = version(name)
        except PackageNotFoundError:
            continue
    return {
        "cpu": cpu,
        "threads": os.cpu_count(),
        "compiler": os.environ.get("BOXWOOD_COMPILER", "unknown"),
        "python": platform.python_version(),
        "commit": commit,
        "packages": versions,
    }
