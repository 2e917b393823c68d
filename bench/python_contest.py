# SPDX-License-Identifier: Apache-2.0
"""What benchmarks in Python have in common."""

from __future__ import annotations

import argparse
import json
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


def parse(description: str, asked: str, passes: int, **options: str) -> argparse.Namespace:
    """The command line: a mesh, how many rays or points, how many passes; and those other
    numbers, with what they mean."""
    parser = argparse.ArgumentParser(description=description.split("\n")[0])
    parser.add_argument("mesh", nargs="?", default=DRAGON)
    parser.add_argument(f"--{asked}", type=int, default=1_000_000)
    parser.add_argument("--passes", type=int, default=passes)
    parser.add_argument("--json", help="also write the results there")
    parser.add_argument("--check", action="store_true", help="exit with 1 when a target is short")
    for name, meaning in options.items():
        parser.add_argument(f"--{name}", type=int, help=meaning)
    arguments = parser.parse_args()
    if not Path(arguments.mesh).exists():
        parser.error(f"{arguments.mesh} isn't there; ./dev data brings the dragon")
    return arguments


def conclude(
    arguments: argparse.Namespace,
    targets: list[tuple[str, float, float]],
    packages: tuple[str, ...],
    results: object,
) -> int:
    """Prints what was reached, and of which least; writes the results; returns the exit status."""
    for label, ratio, target in targets:
        print(f"{label:<48} {ratio:6.2f}  {target:5.2f}  {'short' if ratio < target else 'ok'}")
    if arguments.json:
        document = {"machine": machine(packages), "results": results}
        Path(arguments.json).write_text(json.dumps(document, indent=2) + "\n")
    return int(arguments.check and any(ratio < target for _, ratio, target in targets))


def machine(packages: tuple[str, ...]) -> dict[str, object]:
    """Where the figures come from, with the versions of those packages that are there."""
    about = {}
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        key, _, value = line.partition(":")
        about[key.strip()] = value.strip()
    # The name alone doesn't always tell the generation.
    cpu = "{}, family {}, model {}".format(
        *(about.get(key, "unknown") for key in ("model name", "cpu family", "model"))
    )
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
