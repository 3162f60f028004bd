"""The exception for bad input, the category of warnings, and the translation of the library's names to Python's.

The C++ library reports flags of the command line (without hyphens) or fields of optics. The context manager `Naming` replaces
these names by Python's arguments.
"""

from __future__ import annotations

import errno
import functools
import os
import re
import sys
import warnings
from typing import Any, Callable, Mapping, TypeVar, Union

from . import _core

_Value = TypeVar("_Value")

# Arguments whose names in Python differ from the library's.
_ARGUMENTS = {
    "aov": "layers",
    "aperture": "aperture_mm",
    "asset-root": "asset_root",
    "baseline": "baseline_mm",
    "camera-path": "camera_path",
    "f-number": "f_number",
    "fit-to": "fit_to",
    "focal-length": "focal_length_mm",
    "focal-plane": "focal_plane_mm",
    "focus-distance": "focus_distance_mm",
    "frames per second": "frames_per_second",
    "from": "format",
    "lens-arrangement": "lens_arrangement",
    "lens-offset": "lens_offset_px",
    "lens-pitch-px": "lens_pitch_px",
    "lens-rotation": "lens_rotation_deg",
    "lens-row-pitch-px": "lens_row_pitch_px",
    "max-depth": "max_depth",
    "min-psnr": "min_psnr",
    "quilt": "tiles",
    "sensor-width": "sensor_width_mm",
    "to": "format",
}

# Error messages of the library -> messages of this package. Longer phrases precede phrases that they contain.
_PHRASES = (
    ("`optics` single or multiview", "single_view(), camera_grid() or quilt() as `display`"),
    ("`optics` lenticular or microlens", "lenticular_sheet() or microlens_array()"),
    ("`optics` multiview `camera-grid`", "camera_grid()"),
    ("`optics` multiview", "camera_grid() or quilt()"),
    ("`optics` microlens", "microlens_array()"),
    (
        "`from` with a format, such as `from` integral `views` 8x1 or `from` native `display` portrait (see lippmann help convert)",
        "a format, such as format='integral', views=(1, 8) or format='native', display='portrait'",
    ),
    ("`from` quilt `quilt` ", "format='quilt', tiles="),
    ("`keep`", "a slice of the views"),
    ("DisplayPicture::kNative", "layout='native'"),
    ("a name that 'lippmann displays' lists", "a name of lippmann.displays()"),
)

_QUOTED = re.compile("`([a-z]+(?:-[a-z]+)*)`")
_FIELD = re.compile(rf"(?:panel|singleview|{'|'.join(_core.optics_kinds())})\.(\w+)(?:\.[xy])?")
_WANTED_GRID = re.compile(r"\bCxR, such as (\d+)x(\d+)")
_WANTED_ROW = re.compile(r"(?<![\w./\\-])Nx1(?![\w./\\-])")
_GRID = re.compile(r"(?<![\w./\\-])(\d+)x(\d+)(?![\w./\\-])")  # columns x rows, except in file names


class Error(ValueError):
    """Bad input: an argument, a file, a size.

    where: the argument, the file, or the unknown attribute of a light field.
    problem: what is wrong with the input.
    accepted: the input that would be accepted; empty if obvious.
    """

    def __init__(self, where: str, problem: str, accepted: str = "") -> None:
        super().__init__(where, problem, accepted)
        self.where = where
        self.problem = problem
        self.accepted = accepted

    def __str__(self) -> str:
        return f"{self.where}: {self.problem}" + (f" (accepted: {self.accepted})" if self.accepted else "")


class UnknownError(Error, AttributeError):
    """Raised if an object lacks an attribute that other objects of its type have. hasattr() then returns False."""


class MissingFileError(Error, FileNotFoundError):
    """Raised if a file or folder to read does not exist. `filename` is the path."""

    def __init__(self, where: str, problem: str, accepted: str = "", filename: str = "") -> None:
        super().__init__(where, problem, accepted)
        self.errno, self.strerror, self.filename = errno.ENOENT, problem, filename or where

    def __reduce__(self) -> Any:
        return type(self), (self.where, self.problem, self.accepted, self.filename)


def known(get: Callable[[Any], _Value]) -> Callable[[Any], _Value]:
    """Decorates a property that some objects lack: turns its Errors into UnknownErrors."""

    @functools.wraps(get)
    def getter(self: Any) -> _Value:
        try:
            return get(self)
        except UnknownError:
            raise
        except Error as error:
            raise UnknownError(error.where, error.problem, error.accepted) from None

    return getter


def _argument(where: str, names: Mapping[str, str]) -> str:
    """Replaces the library's name of an argument by Python's. where: "NAME" or "NAME:PLACE"."""
    name, colon, place = where.partition(":")
    field = _FIELD.fullmatch(name)
    name = field[1] if field else name
    return names.get(name, _ARGUMENTS.get(name, name)) + colon + place


def _sentence(text: str, names: Mapping[str, str], has_grids: bool = False, file: str = "") -> str:
    """Returns a text with the library's names replaced by Python's. has_grids: turns sizes such as 8x6, which are columns x
    rows, into (rows, columns). file: a file name that stays unchanged."""
    for flags, words in _PHRASES:
        text = text.replace(flags, words)
    text = _QUOTED.sub(lambda found: f"`{names.get(found[1], _ARGUMENTS.get(found[1], found[1].replace('-', '_')))}`", text)
    text = _WANTED_GRID.sub(r"(rows, columns), such as (\2, \1)", text)
    text = _WANTED_ROW.sub("(1, N)", text)
    if not has_grids:
        return text
    in_name = {found[0] for found in _GRID.finditer(file)}
    return _GRID.sub(lambda found: found[0] if found[0] in in_name else f"({found[2]}, {found[1]})", text)


class Naming:
    """A context manager in which errors of the library name Python's arguments.

    file: a path that stays unchanged in messages. names: {name in the library: name of Python's argument}.
    """

    def __init__(self, file: str = "", **names: str) -> None:
        self._file, self._names = file, names

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        if not isinstance(error, Error):
            return
        where = error.where
        if not self._file or (where != self._file and not where.startswith(self._file + ":")):
            where = _argument(where, self._names)
        has_grids = " pixels" not in error.problem
        parts = (_sentence(part, self._names, has_grids, self._file) for part in (error.problem, error.accepted))
        Error.__init__(error, where, *parts)


class Reading(Naming):
    """A Naming for calls that read `file`. Raises MissingFileError if there is no such file or folder."""

    def __init__(self, file: str, **names: str) -> None:
        super().__init__(file, **names)
        self._read = file

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        super().__exit__(kind, error, trace)
        if isinstance(error, Error) and not os.path.exists(self._read):
            raise MissingFileError(error.where, error.problem, error.accepted, self._read) from None


class LippmannWarning(UserWarning):
    """The category of all warnings of this package: unsupported parts of input, values chosen by default, and arguments
    without effect."""


def warn(text: Union[str, bytes]) -> None:
    """Warns at the line of the user's code that called the package. text: bytes if it comes from the C++ library."""
    message = text if isinstance(text, str) else _sentence(text.decode("utf-8", "replace"), {})
    level, caller = 1, sys._getframe()
    while caller.f_back is not None and caller.f_globals.get("__package__") == __package__:
        level, caller = level + 1, caller.f_back
    warnings.warn(message, LippmannWarning, stacklevel=level)


def warn_of_ignored(argument: str, why: str) -> None:
    warn(f"`{argument}` is ignored: {why}.")
