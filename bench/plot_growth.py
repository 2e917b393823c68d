# SPDX-License-Identifier: Apache-2.0
"""Draws what ./dev bench growth --json measured: growth_build.svg and growth_rays.svg.

Usage: /usr/bin/python3 bench/plot_growth.py RESULTS.json FOLDER

Needs the system's matplotlib: ./dev setup docs
"""

import json
import math
import sys
from pathlib import Path

import matplotlib

matplotlib.use("svg")
# The same file for the same numbers.
matplotlib.rcParams.update({"svg.hashsalt": "boxwood", "svg.fonttype": "none", "font.size": 11})

from matplotlib import pyplot  # noqa: E402

COLORS = {
    "fast": "#2a9d8f",
    "balanced": "#264653",
    "best": "#e76f51",
    "median": "#8d6cab",
    "agglomerative": "#b08d28",
}


def by_name(scores: list[dict]) -> dict[str, list[dict]]:
    """The scores of each name, in order of triangles."""
    result: dict[str, list[dict]] = {}
    for score in sorted(scores, key=lambda score: score["triangles"]):
        result.setdefault(score["name"], []).append(score)
    return result


def draw_builds(scores: list[dict], axes: pyplot.Axes) -> None:
    for name, points in by_name(scores).items():
        n = [point["triangles"] for point in points]
        axes.loglog(
            n,
            [point["build_seconds"] for point in points],
            "o-",
            ms=4,
            color=COLORS.get(name),
            label=name,
        )
    # n log n through the middle of the first name's points, to compare slopes with.
    first = next(iter(by_name(scores).values()))
    anchor = first[len(first) // 2]
    ns = anchor["ns_a_step"]
    n = [point["triangles"] for point in first]
    axes.loglog(n, [1e-9 * ns * x * math.log2(x) for x in n], ":", color="gray", label="n log n")
    axes.set_ylabel("seconds to build, one thread")


def draw_rays(scores: list[dict], axes: pyplot.Axes) -> None:
    for name, points in by_name(scores).items():
        for kind, style in (("primary", "o-"), ("random", "s--")):
            timed = [point for point in points if kind in point["seconds_per_ray"]]
            if timed:
                axes.semilogx(
                    [point["triangles"] for point in timed],
                    [1e9 * point["seconds_per_ray"][kind] for point in timed],
                    style,
                    ms=4,
                    color=COLORS.get(name),
                    label=f"{name}, {kind}",
                )
    axes.set_ylim(bottom=0)
    axes.set_ylabel("nanoseconds a ray, one thread")


def main() -> None:
    results, folder = Path(sys.argv[1]), Path(sys.argv[2])
    scores = json.loads(results.read_text())["scores"]
    for draw, name in ((draw_builds, "growth_build.svg"), (draw_rays, "growth_rays.svg")):
        figure, axes = pyplot.subplots(figsize=(7, 4.2), layout="constrained")
        draw(scores, axes)
        axes.set_xlabel("triangles")
        axes.grid(True, which="major", alpha=0.3)
        axes.legend(frameon=False, fontsize=9)
        figure.savefig(folder / name, metadata={"Date": None})


if __name__ == "__main__":
    main()
