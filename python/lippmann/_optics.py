"""Displays by name or file, and custom optics, which map every pixel to a ray.

Sizes are (height, width) in pixels, like the shapes of arrays. Lengths are mm, angles degrees.
"""

from __future__ import annotations

import json
import math
import os
from typing import Any, Callable, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import array, integer, number, pair, path_bytes, positive, text
from ._errors import Error, Naming, Reading

Display = _core.Display
Optics = _core.Optics

_MOST = 32768  # largest number of pixels per side
_FIELDS = {  # fields of the library's optics -> Python's arguments
    "panel": "size",
    "width": "size",
    "height": "size",
    "pixel_pitch_mm": "pixel_mm",
    "view_cone": "view_cone_deg",
    "slant": "slant_deg",
}
_RAYS = "a function of points (n, 2) that returns origins (n, 3) and directions (n, 3)"


def displays() -> List[Display]:
    """Returns the displays known by name, as listed by `lippmann displays`."""
    return list(_core.display_presets())


def display(name: Any) -> Display:
    """Returns a display.

    name: the name of a preset, or a file: a .toml that describes a display of your own, or a .json calibration such as visual.json.
    """
    return display_of(name, "name")


def display_of(display: Any, argument: str) -> Display:
    """Returns the display that a name, a file or a Display defines. argument: the argument's name, for errors."""
    if isinstance(display, Display):
        return display
    where = path_bytes(display, argument)
    with Reading(os.fsdecode(where), display=argument):
        return _core.load_display(where)


def display_from_toml(toml: str) -> Display:
    """Returns the display that a text in the format of a .toml file describes (docs/reference/displays.md)."""
    with Naming(text="toml"):
        return _core.display_from_toml(text(toml, "toml"))


def _views(
    rows: Any, columns: Any, size: Any, pixel_mm: Optional[float], cone_deg: float, distance_mm: Any, baseline_mm: float
) -> Optics:
    grid = integer(rows, "rows", 1, 256), integer(columns, "columns", 1, 256)
    view = pair(size, "size", 1, _MOST)
    if max(grid[0] * view[0], grid[1] * view[1]) > _MOST:
        raise Error("size", f"all views side by side have {grid[0] * view[0]}x{grid[1] * view[1]} pixels", f"{_MOST} a side")
    pixel = 100.0 / view[0] if pixel_mm is None else positive(pixel_mm, "pixel_mm")
    distance = positive(distance_mm, "distance_mm")
    with Naming(**_FIELDS):
        return _core.views(grid, view, pixel, cone_deg, distance, baseline_mm)


def camera_grid(
    rows: int = 5,
    columns: int = 5,
    size: Tuple[int, int] = (256, 256),
    *,
    baseline_mm: float = 10.0,
    distance_mm: float = 500.0,
    pixel_mm: Optional[float] = None,
) -> Optics:
    """Parallel cameras in a grid, as in data sets of light fields.

    rows, columns: size of the grid.
    size: (height, width) of each view in pixels.
    baseline_mm: distance between neighbouring cameras, horizontally and vertically.
    distance_mm: distance from the cameras to the plane in which all views coincide (disparity 0).
    pixel_mm: size of a view's pixel in that plane. None: the size that makes views 100 mm high.
    """
    return _views(rows, columns, size, pixel_mm, 0.1, distance_mm, positive(baseline_mm, "baseline_mm"))


def quilt(
    rows: int = 6,
    columns: int = 8,
    size: Tuple[int, int] = (560, 420),
    *,
    view_cone_deg: float = 40.0,
    distance_mm: float = 500.0,
    pixel_mm: Optional[float] = None,
) -> Optics:
    """Views from left to right at equal angles, which are the tiles of one picture.

    rows, columns: number of tiles. The arrays of the light field have a single row of rows x columns views.
    size: (height, width) of a tile in pixels.
    view_cone_deg: angle over which the views are spread.
    """
    cone = number(view_cone_deg, "view_cone_deg", 0.01, 179.0)
    return _views(rows, columns, size, pixel_mm, cone, distance_mm, 0.0)


def _lenses(size: Any, pixel_mm: Any, viewing_distance_mm: Any) -> Tuple[Tuple[int, int], float, float]:
    distance = number(viewing_distance_mm, "viewing_distance_mm", 1e-3, math.inf, finite=False)
    return pair(size, "size", 1, _MOST), positive(pixel_mm, "pixel_mm"), distance


def lenticular_sheet(
    size: Tuple[int, int] = (512, 512),
    *,
    pixel_mm: float = 0.125,
    lens_pitch_mm: float = 1.0,
    gap_mm: float = 2.0,
    slant_deg: float = 0.0,
    offset_mm: Optional[float] = None,
    viewing_distance_mm: float = math.inf,
) -> Optics:
    """Cylindrical lenses on a panel, with horizontal parallax.

    size: (height, width) of the panel in pixels.
    slant_deg: angle of the lenses from the vertical.
    gap_mm: distance from the panel to the lenses.
    offset_mm: position of a lens's centre, to the right of the panel's centre. None: half a pitch, so that two lenses meet in the
        panel's centre.
    """
    panel, pixel, distance = _lenses(size, pixel_mm, viewing_distance_mm)
    pitch = positive(lens_pitch_mm, "lens_pitch_mm")
    offset = pitch / 2 if offset_mm is None else number(offset_mm, "offset_mm", -1e6, 1e6)
    slant = number(slant_deg, "slant_deg", -89.0, 89.0)
    gap = positive(gap_mm, "gap_mm")
    with Naming(**_FIELDS):
        return _core.lenticular_sheet(panel, pixel, pitch, gap, slant, offset, distance)


def microlens_array(
    size: Tuple[int, int] = (512, 512),
    *,
    pixel_mm: float = 0.125,
    lens_pitch_mm: float = 1.0,
    gap_mm: float = 2.0,
    hexagonal: bool = False,
    offset_mm: Optional[float] = None,
    viewing_distance_mm: float = math.inf,
) -> Optics:
    """Spherical lenses on a panel of `size` = (height, width) pixels, in a square or hexagonal grid, with parallax in all directions."""
    panel, pixel, distance = _lenses(size, pixel_mm, viewing_distance_mm)
    pitch = positive(lens_pitch_mm, "lens_pitch_mm")
    offset = pitch / 2 if offset_mm is None else number(offset_mm, "offset_mm", -1e6, 1e6)
    gap = positive(gap_mm, "gap_mm")
    with Naming(**_FIELDS):
        return _core.microlens_array(panel, pixel, pitch, gap, bool(hexagonal), offset, distance)


def _for_json(value: Any, name: str) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [_for_json(part, name) for part in value]
    if isinstance(value, float) and math.isinf(value) and value > 0:
        return None
    if value is None or not isinstance(value, (bool, int, float, str)) or (isinstance(value, float) and not math.isfinite(value)):
        raise Error(name, f"is {value!r}", "a number, a text or a list of numbers")
    return value


def optics(kind: str, size: Tuple[int, int] = (512, 512), *, pixel_mm: float = 0.125, **values: Any) -> Optics:
    """Optics of any kind, by the names of report.json: `optics("single", (40, 56), distance_mm=500)`.

    kind: the value of "kind" in the "optics" of a report.json.
    size: (height, width) of the panel in pixels.
    pixel_mm: size of a pixel.
    values: the other fields of this kind in report.json, such as lens_pitch_mm and gap_mm. Angles are degrees. math.inf is accepted.
    """
    panel, pixel = pair(size, "size", 1, _MOST), positive(pixel_mm, "pixel_mm")
    members = json.dumps({name: _for_json(value, name) for name, value in values.items()})
    with Naming(**_FIELDS):
        return _core.optics(text(kind, "kind"), panel, pixel, members)


def single_view(size: Tuple[int, int] = (512, 512), *, pixel_mm: float = 0.125, distance_mm: float = 500.0) -> Optics:
    """A pinhole camera at `distance_mm` in front of the display's centre. size: (height, width) in pixels."""
    panel = pair(size, "size", 1, _MOST)
    pixel, distance = positive(pixel_mm, "pixel_mm"), positive(distance_mm, "distance_mm")
    with Naming(**_FIELDS):
        return _core.single_view(panel, pixel, distance)


def _middles(size: Tuple[int, int], samples_per_side: int) -> NDArray[Any]:
    """Divides every pixel into samples_per_side x samples_per_side parts. Returns (n, 2): x and y of the centre of every part, in pixels,
    row by row from the top left.
    """
    y, x = np.mgrid[0 : size[0] * samples_per_side, 0 : size[1] * samples_per_side].astype(np.float32)
    middles: NDArray[Any] = np.stack([x.ravel() + 0.5, y.ravel() + 0.5], axis=1) / samples_per_side
    return middles


def _unit_directions(directions: NDArray[Any]) -> NDArray[Any]:
    """Returns the directions as float32 unit vectors. Scales each vector by its largest component first, so that the squares of very long
    or short vectors neither overflow nor underflow.
    """
    largest = np.abs(directions).max(axis=1, keepdims=True)
    unit: NDArray[Any] = directions / np.where(largest > 0, largest, 1.0)
    unit = (unit / np.maximum(np.linalg.norm(unit, axis=1, keepdims=True), 1.0)).astype(np.float32)
    if not (unit[:, 2] < 0).all():
        raise Error("rays: directions", "do not all have z below 0", "rays that point away from the viewer")
    return unit


def _spread(directions: NDArray[Any], rows: int) -> float:
    """Returns the median distance by which the rays of neighbouring points in a row separate, in mm per mm of depth."""
    slopes = (directions[:, :2].astype(np.float64) / -directions[:, 2:]).reshape(rows, -1, 2)
    steps = np.linalg.norm(np.diff(slopes, axis=1), axis=2)
    return float(np.median(steps)) if steps.size else 0.0


def _pair_of(returned: Any) -> Sequence[Any]:
    try:
        parts = iter(returned)
    except TypeError:
        raise Error("rays", f"has returned {returned!r}", _RAYS) from None
    listed = list(parts)
    if len(listed) != 2:
        raise Error("rays", f"has returned {len(listed)} value{'' if len(listed) == 1 else 's'}", _RAYS)
    return listed


def own_optics(
    rays: Callable[[NDArray[Any]], Tuple[NDArray[Any], NDArray[Any]]],
    size: Tuple[int, int] = (256, 256),
    *,
    pixel_mm: float = 0.1,
    samples_per_side: int = 1,
) -> Optics:
    """Optics given by a function from pixel to ray, such as a simulated lens or a measured display.

    rays: a function that returns the rays of points on the panel. It is called once with all points that are traced, as (n, 2): x from
        the left and y from the top, in pixels. Pixel centres are at + 0.5. It returns origins (n, 3) in mm and directions (n, 3) of any
        length, in the display frame: x to the right, y up, z towards the viewer, (0, 0, 0) in the centre of the display. Directions point
        away from the viewer (z below 0). A ray shows only what lies beyond its origin. Exceptions of the function are passed on.
    size: (height, width) of the panel in pixels.
    pixel_mm: size of a pixel.
    samples_per_side: every pixel has samples_per_side squared rays. Each of its samples (spp) uses one of them.

    Such pictures have no views. They cannot be rendered with reuse or denoising, and replay cannot show them to an eye.
    """
    if not callable(rays):
        raise Error("rays", f"is {rays!r}", _RAYS)
    panel = pair(size, "size", 1, _MOST)
    samples = integer(samples_per_side, "samples_per_side", 1, 16)
    points = _middles(panel, samples)
    origins, directions = _pair_of(rays(points))
    origins = array(origins, "rays: origins", (len(points), 3))
    directions = _unit_directions(array(directions, "rays: directions", (len(points), 3), dtype=np.float64))
    spread = _spread(directions, panel[0] * samples) * samples
    pixel = positive(pixel_mm, "pixel_mm")
    with Naming(**_FIELDS):
        return _core.ray_table(panel, pixel, samples, spread, origins, directions)
