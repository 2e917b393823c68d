# SPDX-License-Identifier: Apache-2.0
"""How fast are closest points and signed distances from Python? Boxwood against Open3D, libigl and
FCPW: the same mesh and points, each called as its users call it, in turns, on one processor and on
all of them. The best pass of each counts.

Usage: ./dev bench python_queries [MESH] [--points N] [--passes N] [--json FILE] [--check]
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
from python_contest import conclude, parse, timed

import boxwood as bw

#: At least so many times as fast as the best of the others.
TARGET = 1.3


@dataclass
class Question:
    """A call to be timed, and the distances in what it returns."""

    call: Callable[[], object]
    distances: Callable[[object], np.ndarray]
    #: What the call does besides: a call whose time is taken off.
    besides: Callable[[], object] | None = None

    def ask(self) -> tuple[float, np.ndarray]:
        less = timed(self.besides)[0] if self.besides else 0.0
        seconds, found = timed(self.call)
        return max(seconds - less, 1e-9), self.distances(found)


class Boxwood:
    name = "boxwood"

    def __init__(self, mesh: bw.Mesh) -> None:
        self.scene = bw.Scene(mesh)

    def closest_point(self, points: np.ndarray) -> Question:
        return Question(lambda: self.scene.closest_point(points), lambda found: found.distance)

    def signed_distance(self, points: np.ndarray) -> Question:
        return Question(lambda: self.scene.signed_distance(points), lambda found: found.distance)


class Open3d:
    """Tensors of floats, made before the clock starts."""

    name = "open3d"

    def __init__(self, mesh: bw.Mesh) -> None:
        import open3d as o3d

        self.tensor = o3d.core.Tensor
        self.scene = o3d.t.geometry.RaycastingScene()
        self.scene.add_triangles(
            self.tensor(mesh.vertices.astype(np.float32)),
            self.tensor(mesh.faces.astype(np.uint32)),
        )

    def closest_point(self, points: np.ndarray) -> Question:
        asked = self.tensor(points.astype(np.float32))
        return Question(
            lambda: self.scene.compute_closest_points(asked),
            lambda found: np.linalg.norm(found["points"].numpy() - points, axis=1),
        )

    def signed_distance(self, points: np.ndarray) -> Question:
        asked = self.tensor(points.astype(np.float32))
        return Question(
            lambda: self.scene.compute_signed_distance(asked), lambda found: found.numpy()
        )


class Libigl:
    """Closest points with a tree that is kept. Signed distances build theirs in each call, which
    can't be had otherwise, so what a call with one point takes is taken off."""

    name = "libigl"

    def __init__(self, mesh: bw.Mesh) -> None:
        import igl

        self.igl = igl
        self.mesh = (np.asarray(mesh.vertices, np.float64), mesh.faces.astype(np.int64))
        self.tree = igl.AABB()
        self.tree.init(*self.mesh)

    def closest_point(self, points: np.ndarray) -> Question:
        return Question(
            lambda: self.tree.squared_distance(*self.mesh, points), lambda found: np.sqrt(found[0])
        )

    def signed_distance(self, points: np.ndarray) -> Question:
        kind = self.igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_PSEUDONORMAL
        return Question(
            lambda: self.igl.signed_distance(points, *self.mesh, kind),
            lambda found: found[0],
            besides=lambda: self.igl.signed_distance(points[:1], *self.mesh, kind),
        )


class Fcpw:
    """Its vectorised tree, with arrays of floats in the order it asks for, made before the clock
    starts. Signed distances it gives for single points only."""

    name = "fcpw"

    def __init__(self, mesh: bw.Mesh) -> None:
        import fcpw

        self.new_results = fcpw.interaction_3D_list
        self.scene = fcpw.scene_3D()
        self.scene.set_object_count(1)
        self.scene.set_object_vertices(np.asfortranarray(mesh.vertices.astype(np.float32)), 0)
        self.scene.set_object_triangles(np.asfortranarray(mesh.faces.astype(np.int32)), 0)
        self.scene.build(fcpw.aggregate_type.bvh_surface_area, True)

    def closest_point(self, points: np.ndarray) -> Question:
        asked = np.asfortranarray(points.astype(np.float32))
        radii = np.full(len(points), np.inf, np.float32)

        def call() -> object:
            found = self.new_results()
            self.scene.find_closest_points(asked, radii, found)
            return found

        return Question(call, lambda found: np.array([one.d for one in found]))


class Measurement:
    """The best seconds of each for a question, and how far its answers are from Boxwood's: by how
    much a distance differs, and how many signs do."""

    kinds: ClassVar = ("closest_point", "signed_distance")

    def __init__(self, players: list[object], kind: str, points: np.ndarray, passes: int) -> None:
        questions = {one.name: getattr(one, kind)(points) for one in players if hasattr(one, kind)}
        self.seconds = dict.fromkeys(questions, float("inf"))
        self.apart: dict[str, float] = {}
        self.other_signs: dict[str, int] = {}
        exact = None
        for _ in range(passes):
            for name, question in questions.items():
                seconds, distances = question.ask()
                self.seconds[name] = min(self.seconds[name], seconds)
                exact = distances if exact is None else exact
                self.apart[name] = float(np.abs(np.abs(distances) - np.abs(exact)).max())
                self.other_signs[name] = int(((distances < 0) != (exact < 0)).sum())

    def ratio(self) -> float | None:
        others = [seconds for name, seconds in self.seconds.items() if name != Boxwood.name]
        return min(others) / self.seconds[Boxwood.name] if others else None


def points_around(mesh: bw.Mesh, count: int) -> np.ndarray:
    """In its bounds made half as large again."""
    low, high = mesh.bounds
    spread = np.random.default_rng(1).uniform(-1, 1, (count, 3))
    return (low + high) / 2 + 0.75 * (high - low) * spread


def measure(mesh_file: str, count: int, passes: int) -> dict[str, dict[str, object]]:
    mesh = bw.load(mesh_file)
    players: list[object] = [Boxwood(mesh)]
    for make in (Open3d, Libigl, Fcpw):
        try:
            players.append(make(mesh))
        except ImportError as error:
            print(f"{make.name} is left out: {error}", file=sys.stderr)
    points = points_around(mesh, count)
    size = float(np.max(np.subtract(*mesh.bounds[::-1])))
    results = {}
    processors = len(os.sched_getaffinity(0))
    for kind in Measurement.kinds:
        one = Measurement(players, kind, points, passes)
        print(f"\n{kind}, {processors} processors: {count} points, {mesh!r}")
        for name, seconds in one.seconds.items():
            rate, apart = count / seconds / 1e6, one.apart[name] / size
            ratio, signs = seconds / one.seconds[Boxwood.name], one.other_signs[name]
            print(
                f"  {name:<10} {1e3 * seconds:9.1f} ms {rate:7.3f} M/s {ratio:7.2f}  {apart:.1e}"
                f" {signs:6}"
            )
        results[kind] = vars(one) | {"ratio": one.ratio()}
    return results


def measure_on(processors: int, arguments: argparse.Namespace) -> dict[str, dict[str, object]]:
    """In a process of its own, whose libraries find no other processors."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "result.json"
        options = {
            "--points": arguments.points,
            "--passes": arguments.passes,
            "--processors": processors,
            "--json": result,
        }
        words = [str(word) for option in options.items() for word in option]
        subprocess.run([sys.executable, __file__, arguments.mesh, *words], check=True)
        return json.loads(result.read_text())


def main() -> int:
    arguments = parse(__doc__, "points", passes=3, processors="only so many, without targets")
    everything = sorted(os.sched_getaffinity(0))
    if arguments.processors:
        os.sched_setaffinity(0, everything[: arguments.processors])
        measured = measure(arguments.mesh, arguments.points, arguments.passes)
        if arguments.json:
            Path(arguments.json).write_text(json.dumps(measured) + "\n")
        return 0

    counts = {"one": 1, "all": len(everything)}
    results = {name: measure_on(count, arguments) for name, count in counts.items()}
    print(
        "\nThe last columns: the largest difference to Boxwood's distances, by the mesh's size, and"
    )
    print("how many signs are others, which an open mesh leaves undefined.\n")
    targets = [
        (f"{kind}, {threads}: to the best of the others", result["ratio"], TARGET)
        for threads, kinds in results.items()
        for kind, result in kinds.items()
        if result["ratio"] is not None
    ]
    return conclude(arguments, targets, ("open3d", "libigl", "fcpw"), results)


if __name__ == "__main__":
    sys.exit(main())
