"""Types of the options of lippmann.frames and lippmann.render, for type checkers."""

from __future__ import annotations

import os
from typing import Any, Callable, Literal, Union

from numpy.typing import ArrayLike

AngularFilter = Literal["none", "box"]
Denoise = Literal["auto", "none"]
Environment = Union[ArrayLike, "os.PathLike[str]"]
FitTo = Union[Literal["all"], str]  # otherwise the name of a node
Integrator = Literal["path", "whitted"]
Layer = Literal[
    "depth",
    "ray-depth",
    "normal",
    "position",
    "id",
    "albedo",
    "motion",
    "provenance",
    "direct",
    "indirect",
    "disparity",
]
LensArrangement = Literal["square", "hexagonal", "hexagonal-columns"]
Layout = Literal["views", "native"]
Light = Literal["auto", "none"]
Progress = Callable[[int, float], Any]
Reuse = Literal["auto", "none", "copy", "interpolate"]
Sampling = Literal["linear", "lanczos"]
Tone = Literal["none", "neutral", "agx"]
UpAxis = Literal["y", "x", "z", "-x", "-y", "-z"]
