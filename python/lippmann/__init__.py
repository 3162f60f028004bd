"""Renders, opens, views and saves light fields of 3D scenes as NumPy arrays.

Arrays of views have the axes (rows, columns, y, x, channel). Row 0 of the views is the LOWEST eye. Column 0 is the leftmost eye.
`views[::-1]` starts with the highest row, as in data sets that count from the top left. In each view, y = 0 is the top row of
pixels. Rendered colours are linear light: float32, 1 is white. Opened colours are stored as in the file: uint8 and uint16 are
sRGB codes, float32 is linear light. Lengths are millimetres of the display: x to the right, y up, z towards the viewer. z = 0 is
the display's plane.

>>> import lippmann
>>> field = lippmann.render("room", lippmann.camera_grid(rows=3, columns=3, size=(64, 64)), layers=["depth"])
>>> field.views.shape, field.depth.shape
((3, 3, 64, 64, 3), (3, 3, 64, 64))
"""

from ._core import version as __version__
from ._dataset import DatasetReport, dataset
from ._errors import Error, LippmannWarning
from ._light_field import LightField, formats, open, show, to_codes
from ._optics import (
    Display,
    Optics,
    camera_grid,
    display,
    display_from_toml,
    displays,
    lenticular_sheet,
    microlens_array,
    optics,
    own_optics,
    quilt,
    single_view,
)
from ._random import random_camera_grid, random_display, random_scene, training_data
from ._render import Animation, frames, render
from ._scene import Material, Object, Scene, Skin, load, scenes

__all__ = [
    "Animation",
    "DatasetReport",
    "Display",
    "Error",
    "LightField",
    "LippmannWarning",
    "Material",
    "Object",
    "Optics",
    "Scene",
    "Skin",
    "camera_grid",
    "dataset",
    "display",
    "display_from_toml",
    "displays",
    "formats",
    "frames",
    "lenticular_sheet",
    "load",
    "microlens_array",
    "open",
    "optics",
    "own_optics",
    "quilt",
    "random_camera_grid",
    "random_display",
    "random_scene",
    "render",
    "scenes",
    "show",
    "single_view",
    "to_codes",
    "training_data",
]
