# SPDX-License-Identifier: Apache-2.0
"""How fast are rays from Python? Boxwood against trimesh with embreex, Open3D's RaycastingScene and
its own batch in C++: the same mesh and rays, each called as its users call it, in turns, on all
threads. The best pass of each counts.

Usage: ./dev bench python [MESH] [--rays N] [--passes N] [--json FILE] [--check]
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from python_contest import conclude, parse, timed

import boxwood as bw

Rays = tuple[np.ndarray, np.ndarray]
#: At least so many times as fast, for camera and random rays.
TARGETS = {"trimesh+embreex": (6.0, 4.0), "open3d": (2.0, 1.3), "C++": (0.95, 0.95)}


class Boxwood:
    """numpy arrays in, of one precision."""

    def __init__(self, mesh: bw.Mesh, dtype: type) -> None:
        self.scene = bw.Scene(mesh)
        self.dtype = dtype

    def prepare(self, origins: np.ndarray, directions: np.ndarray) -> Callable[[], object]:
        o, d = origins.astype(self.dtype), directions.astype(self.dtype)
        return lambda: timed(lambda: self.scene.closest_hit(o, d))

    @staticmethod
    def triangles(result: object) -> np.ndarray:
        return result.triangle


class Trimesh:
    """What mesh.ray is when embreex is installed; triangles alone are asked for."""

    def __init__(self, mesh: bw.Mesh) -> None:
        import trimesh

        self.mesh = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
        if "pyembree" not in type(self.mesh.ray).__module__:
            raise ImportError("trimesh doesn't use embreex")

    def prepare(self, origins: np.ndarray, directions: np.ndarray) -> Callable[[], object]:
        o, d = np.ascontiguousarray(origins), np.ascontiguousarray(directions)
        self.mesh.ray.intersects_first(o[:1], d[:1])
        return lambda: timed(lambda: self.mesh.ray.intersects_first(o, d))

    @staticmethod
    def triangles(result: object) -> np.ndarray:
        return np.asarray(result)


class Open3d:
    """Rays as it wants them, a tensor of six floats a ray, made before the clock starts."""

    def __init__(self, mesh: bw.Mesh) -> None:
        import open3d as o3d

        self.core = o3d.core
        self.scene = o3d.t.geometry.RaycastingScene()
        self.scene.add_triangles(
            o3d.core.Tensor(mesh.vertices.astype(np.float32)),
            o3d.core.Tensor(mesh.faces.astype(np.uint32)),
        )

    def prepare(self, origins: np.ndarray, directions: np.ndarray) -> Callable[[], object]:
        rays = self.core.Tensor(np.hstack([origins, directions]).astype(np.float32))
        return lambda: timed(lambda: self.scene.cast_rays(rays))

    @staticmethod
    def triangles(result: object) -> np.ndarray:
        return result["primitive_ids"].numpy().view(np.int32)


class Twin:
    """The batch in C++, in a process of its own."""

    def __init__(self, mesh_file: str, precision: str, folder: Path) -> None:
        program = os.environ["BOXWOOD_PYTHON_TWIN"]
        self.process = subprocess.Popen(
            [program, mesh_file], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self.precision, self.folder = precision, folder

    def prepare(self, origins: np.ndarray, directions: np.ndarray) -> Callable[[], object]:
        numbers = np.hstack([origins, directions]).astype(np.float64)
        path = self.folder / f"rays-{abs(hash(numbers[-1].tobytes()))}"
        numbers.tofile(path)

        def run() -> tuple[float, object]:
            self.process.stdin.write(f"{self.precision} {path}\n")
            self.process.stdin.flush()
            return float(self.process.stdout.readline()), None

        return run

    @staticmethod
    def triangles(result: object) -> None:
        return None


def camera_rays(mesh: bw.Mesh, count: int) -> Rays:
    """Of pictures from three quarters, as many pixels as rays, an origin for each."""
    side = round(count**0.5)
    origin, directions = bw.PinholeCamera.framing(mesh, width=side, height=side).rays()
    return np.repeat(origin[None], side * side, axis=0), directions.reshape(-1, 3)


def random_rays(mesh: bw.Mesh, count: int) -> Rays:
    """Chords of the ball around the mesh."""
    random = np.random.default_rng(1)
    low, high = mesh.bounds
    radius = np.linalg.norm(high - low) / 2
    ends = random.normal(size=(2, count, 3))
    ends *= radius / np.linalg.norm(ends, axis=2, keepdims=True)
    return (low + high) / 2 + ends[0], ends[1] - ends[0]


def contestants(mesh: bw.Mesh, mesh_file: str, folder: Path) -> dict[str, object]:
    found: dict[str, object] = {
        "boxwood float32": Boxwood(mesh, np.float32),
        "boxwood float64": Boxwood(mesh, np.float64),
        "C++ float32": Twin(mesh_file, "float", folder),
        "C++ float64": Twin(mesh_file, "double", folder),
    }
    for name, make in (("trimesh+embreex", Trimesh), ("open3d", Open3d)):
        try:
            found[name] = make(mesh)
        except ImportError as error:
            print(f"{name} is left out: {error}", file=sys.stderr)
    return found


def measure(
    players: dict[str, object], rays: Rays, passes: int
) -> tuple[dict[str, float], dict[str, float]]:
    """The best seconds of each, and which part of the hits is another triangle than Boxwood's."""
    runs = {name: player.prepare(*rays) for name, player in players.items()}
    best = dict.fromkeys(players, float("inf"))
    triangles = {}
    for k in range(passes):
        # In another order each time: the threads of who came before may still look for work.
        names = np.random.default_rng(k).permutation(list(runs))
        for name in names:
            seconds, result = runs[name]()
            best[name] = min(best[name], seconds)
            if name not in triangles:
                triangles[name] = players[name].triangles(result)
    exact = triangles["boxwood float64"]
    others = {
        name: float((found != exact).mean())
        for name, found in triangles.items()
        if found is not None
    }
    return best, others


def main() -> int:
    arguments = parse(__doc__, "rays", passes=7)
    mesh = bw.load(arguments.mesh)
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        players = contestants(mesh, arguments.mesh, Path(folder))
        for kind, make in (("camera", camera_rays), ("random", random_rays)):
            rays = make(mesh, arguments.rays)
            best, others = measure(players, rays, arguments.passes)
            results[kind] = {"rays": len(rays[0]), "seconds": best, "other_triangles": others}
            print(f"\n{kind}: {len(rays[0])} rays, {mesh!r}")
            for name, seconds in best.items():
                ratio = seconds / best["boxwood float32"]
                apart = f"{others[name]:.1e}" if name in others else ""
                rate = len(rays[0]) / seconds / 1e6
                print(f"  {name:<16} {1e3 * seconds:8.1f} ms {rate:7.2f} M/s {ratio:6.2f}  {apart}")
    print("\nThe last column: rays that hit another triangle than in float64, ties included.")

    targets = []
    for column, kind in enumerate(("camera", "random")):
        seconds = results[kind]["seconds"]
        for peer in ("trimesh+embreex", "open3d"):
            if peer in seconds:
                ratio = seconds[peer] / seconds["boxwood float32"]
                targets.append((f"{kind}: float32 to {peer}", ratio, TARGETS[peer][column]))
        for precision in ("float32", "float64"):
            ratio = seconds[f"C++ {precision}"] / seconds[f"boxwood {precision}"]
            targets.append((f"{kind}: {precision} to C++", ratio, TARGETS["C++"][column]))
    return conclude(arguments, targets, ("trimesh", "embreex", "open3d"), results)


if __name__ == "__main__":
    sys.exit(main())
