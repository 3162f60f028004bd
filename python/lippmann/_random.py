"""Random scenes, displays and light fields for training. Equal seeds give equal results, bit for bit."""

from __future__ import annotations

import dataclasses
import itertools
from typing import Any, Iterable, Iterator, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._arguments import integer, pair
from ._light_field import LightField
from ._optics import Display, Optics, camera_grid, display_from_toml
from ._options import Layer
from ._render import render
from ._scene import Material, Scene


def _generator(seed: Any, purpose: int) -> np.random.Generator:
    return np.random.Generator(np.random.PCG64([integer(seed, "seed", 0, (1 << 63) - 1), purpose]))


def _material(rng: np.random.Generator, textured: float = 0.7) -> Material:
    texture = None
    if rng.random() < textured:
        cells = int(rng.integers(4, 33))
        texture = rng.integers(0, 256, (cells, cells, 3), dtype=np.uint8).repeat(8, axis=0).repeat(8, axis=1)
    return Material(
        color=tuple(rng.uniform(0.2, 1.0, 3)),
        roughness=float(rng.uniform(0.2, 1.0)),
        metallic=float(rng.random() < 0.2),
        texture=texture,
    )


def _ball(rng: np.random.Generator, rings: int = 24, sectors: int = 48) -> Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Returns the mesh of a ball with a random, wavy radius: positions, triangles, uvs."""
    v, u = np.meshgrid(np.linspace(0, 1, rings + 1), np.linspace(0, 1, sectors + 1), indexing="ij")
    theta, phi = np.pi * v, 2 * np.pi * u
    lumps = rng.uniform(0, 0.15, 3)
    radius = 1 + lumps[0] * np.sin(3 * theta) + np.sin(theta) * (lumps[1] * np.sin(2 * phi) + lumps[2] * np.cos(5 * phi))
    around = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), -np.sin(theta) * np.sin(phi)], axis=-1)
    positions = (radius[..., None] * around).reshape(-1, 3)
    first = (np.arange(rings)[:, None] * (sectors + 1) + np.arange(sectors)).reshape(-1)
    below = first + sectors + 1
    triangles = np.concatenate([np.stack([first, below, below + 1], 1), np.stack([first, below + 1, first + 1], 1)])
    return positions, triangles, np.stack([u, v], axis=-1).reshape(-1, 2)


def _turn(rng: np.random.Generator) -> NDArray[Any]:
    """Returns a quaternion, uniformly distributed over all rotations: K. Shoemake, "Uniform random rotations", Graphics Gems III, 1992."""
    a, b, c = rng.random(3)
    s, t = np.sqrt(1 - a), np.sqrt(a)
    return np.array([s * np.sin(2 * np.pi * b), s * np.cos(2 * np.pi * b), t * np.sin(2 * np.pi * c), t * np.cos(2 * np.pi * c)])


def random_scene(seed: int, *, objects: int = 12, frames: int = 1) -> Scene:
    """Returns a scene of textured shapes in front of a wall, near the display's plane. The display is 10 scene units high.
    With several frames, the shapes move and rotate."""
    rng = _generator(seed, 0)
    scene = Scene(f"random {seed}", frames=frames)
    count = integer(objects, "objects", 0, 1 << 16)
    times = np.linspace(0, 1, scene.frame_count)[:, None]
    wall = np.array([[-40, -40, 0], [40, -40, 0], [40, 40, 0], [-40, 40, 0]], np.float32)
    scene.add_mesh(
        wall + (0, 0, -rng.uniform(4, 12)),
        [[0, 1, 2], [0, 2, 3]],
        uvs=wall[:, :2] * rng.uniform(0.02, 0.1),
        material=_material(rng, textured=1.0),
        name="wall",
    )
    for i in range(count):
        at, size, surface = rng.uniform((-6, -5, -4), (6, 5, 2)), rng.uniform(0.4, 1.6), _material(rng)
        if rng.random() < 0.3:
            plain = dataclasses.replace(surface, texture=None)  # boxes have no uvs
            placed = scene.add_box((-size / 2,) * 3, (size / 2,) * 3, material=plain, name=f"object {i}")
        else:
            positions, triangles, uvs = _ball(rng)
            placed = scene.add_mesh(positions * size, triangles, uvs=uvs, material=surface, name=f"object {i}")
        move = rng.uniform(-1, 1, 3) * (scene.frame_count > 1)
        start, end = _turn(rng), _turn(rng)
        turns = start + (end if start @ end >= 0 else -end) * times - start * times if scene.frame_count > 1 else start[None]
        placed.animate(translation=at + move * times, rotation=turns)
    sky = rng.uniform(0.3, 1.0)
    scene.set_background(tuple(sky * rng.uniform(0.7, 1.0, 3)))
    scene.add_light(
        "directional", direction=(rng.uniform(-1, 1), rng.uniform(-1, -0.3), -1), color=rng.uniform(0.6, 1, 3), intensity=2.0
    )
    scene.place_display((0, 0, 0), height=10.0, viewing_distance=float(rng.uniform(25, 60)))
    return scene


def random_camera_grid(seed: int, *, rows: int = 5, columns: int = 5, size: Tuple[int, int] = (128, 128)) -> Optics:
    """Returns a camera grid at a random distance (200 to 800 mm) with a random baseline (1 to 3 degrees, as seen from the display)."""
    rng = _generator(seed, 1)
    distance = float(rng.uniform(200, 800))
    baseline = distance * float(np.tan(np.radians(rng.uniform(1, 3))))
    return camera_grid(rows, columns, size, baseline_mm=baseline, distance_mm=distance)


def random_display(seed: int, *, size: Tuple[int, int] = (256, 192)) -> Display:
    """Returns a slanted panel with a random calibration: lens pitch, slope, phase and view cone. size: (height, width) in pixels."""
    rng = _generator(seed, 2)
    height, width = pair(size, "size", 8, 1 << 14)
    dpi = float(rng.uniform(150, 500))
    below = rng.uniform(6, 15)  # number of sub-pixels below a lens
    return display_from_toml(
        f"""description = "random {seed}"
kind = "slanted-panel"
pixels = [{width}, {height}]
dpi = {dpi:.6f}
view_cone_deg = {rng.uniform(25, 60):.6f}
[calibration]
pitch = {3 * dpi / below:.6f}
slope = {(-1 if rng.random() < 0.5 else 1) * rng.uniform(4, 9):.6f}
center = {rng.uniform(0, 1):.6f}
[quilt]
tiles = [8, 6]
size = [{8 * width}, {6 * height}]
aspect = {width / height:.6f}
"""
    )


def training_data(
    seed: int = 0,
    count: Optional[int] = None,
    *,
    rows: int = 5,
    columns: int = 5,
    size: Tuple[int, int] = (128, 128),
    layers: Union[Layer, Iterable[Layer]] = ("depth",),
    objects: int = 12,
    spp: int = 16,
    **options: Any,
) -> Iterator[LightField]:
    """Yields light fields of random scenes and random cameras, with views, depth and disparity.

    count: number of light fields. None: endless.
    seed: light field i shows random_scene(seed + i) through random_camera_grid(seed + i). Several processes can share the work by
        taking different seeds.

    Other options are those of lippmann.render.
    """
    first = integer(seed, "seed", 0, 1 << 62)
    numbers = itertools.count(first) if count is None else range(first, first + integer(count, "count", 0, 1 << 62))
    for number in numbers:
        scene = random_scene(number, objects=objects)
        optics = random_camera_grid(number, rows=rows, columns=columns, size=size)
        yield render(scene, optics, layers=layers, spp=spp, seed=number & 0xFFFFFFFF, fit_depth=False, **options)
