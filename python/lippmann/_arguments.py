"""Checks and converts arguments. An Error names the invalid argument."""

from __future__ import annotations

import math
import os
from typing import Any, Iterable, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ._errors import Error, MissingFileError


def number(value: Any, name: str, lowest: float = -math.inf, highest: float = math.inf, finite: bool = True) -> float:
    """Raises Error unless the value is a number from `lowest` to `highest`."""
    wanted = "a number" + ("" if lowest == -math.inf and highest == math.inf else f" from {lowest:g} to {highest:g}")
    if isinstance(value, (bool, str, bytes)):
        raise Error(name, f"is {value!r}", wanted)
    try:
        result = float(value)
    except (TypeError, ValueError, OverflowError):
        raise Error(name, f"is {value!r}", wanted) from None
    if math.isnan(result) or (finite and math.isinf(result)) or not lowest <= result <= highest:
        raise Error(name, f"is {result:g}", wanted)
    return result


def positive(value: Any, name: str, highest: float = 1e6) -> float:
    result = number(value, name, 0.0, highest)
    if result <= 0.0:
        raise Error(name, f"is {result:g}", f"a number above 0, at most {highest:g}")
    return result


def integer(value: Any, name: str, lowest: int, highest: int) -> int:
    """Accepts floats with a whole value. Raises Error unless the value is from `lowest` to `highest`."""
    result = number(value, name, lowest, highest)
    if result != int(result):
        raise Error(name, f"is {result:g}", f"a whole number from {lowest} to {highest}")
    return int(result)


def choice(value: Any, name: str, accepted: Sequence[str]) -> str:
    if value not in accepted:
        raise Error(name, f"is {value!r}", ", ".join(accepted))
    return str(value)


def path(value: Any, name: str) -> str:
    try:
        result = os.fsdecode(value)
    except TypeError:
        raise Error(name, f"is {value!r}", "a path") from None
    if not result or "\0" in result:
        raise Error(name, f"is {result!r}", "a path without zero bytes")
    return result


def path_bytes(value: Any, name: str) -> bytes:
    """Returns a path as bytes, since file names need not be UTF-8."""
    return os.fsencode(path(value, name))


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise Error(name, f"is {value!r}", "a string")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise Error(name, f"{value!r} cannot be written as UTF-8", "a string without lone surrogates") from None
    return value


def file_path(value: Any, name: str) -> bytes:
    where = path_bytes(value, name)
    if not os.path.isfile(where):
        raise MissingFileError(name, f"there is no file {os.fsdecode(where)!r}", "a file", os.fsdecode(where))
    return where


def array(
    value: Any, name: str, shape: Tuple[Optional[int], ...], finite: bool = True, dtype: Any = np.float32
) -> NDArray[Any]:
    """Returns a C-contiguous array of this type and shape. A None in `shape` allows any length above 0. Raises Error for NaN, and
    for infinities if `finite`.
    """
    wanted = "numbers of the shape (" + ", ".join("n" if n is None else str(n) for n in shape) + ")"
    try:
        given = np.asarray(value)
    except (TypeError, ValueError):
        raise Error(name, "is not an array", wanted) from None
    if given.dtype.kind not in "fiu":
        raise Error(name, f"has the type {given.dtype}", wanted)
    if given.ndim != len(shape) or any(n is not None and n != m for n, m in zip(shape, given.shape)):
        raise Error(name, f"has the shape {given.shape}", wanted)
    if given.size == 0:
        raise Error(name, f"is empty, of the shape {given.shape}", wanted)
    with np.errstate(over="ignore"):
        result = np.ascontiguousarray(given, dtype=dtype)
    wrong = ~np.isfinite(result) if finite else np.isnan(result)
    if wrong.any():
        place = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise Error(name, f"is {given[place]} at {place}", f"finite numbers within {np.dtype(dtype)}" if finite else "numbers")
    return result


def indices(value: Any, name: str, columns: int, count: int) -> NDArray[Any]:
    """Returns an array (n, columns) of uint32. Raises Error unless all values are from 0 to count - 1."""
    wanted = f"integers of the shape (n, {columns}), from 0 to {count - 1}"
    try:
        given = np.asarray(value)
    except (TypeError, ValueError):
        raise Error(name, "is not an array", wanted) from None
    if given.dtype.kind not in "iu":
        raise Error(name, f"has the type {given.dtype}", wanted)
    if given.ndim != 2 or given.shape[1] != columns or given.size == 0:
        raise Error(name, f"has the shape {given.shape}", wanted)
    wrong = (given < 0) | (given >= count)
    if wrong.any():
        place = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise Error(name, f"is {given[place]} at {place}", wanted)
    return np.ascontiguousarray(given, dtype=np.uint32)


def vector(value: Any, name: str, length: int = 3) -> Tuple[float, ...]:
    return tuple(float(v) for v in array(value, name, (length,)))


def pair(value: Any, name: str, lowest: int, highest: int) -> Tuple[int, int]:
    """Returns two whole numbers, such as (height, width). Raises Error unless both are from `lowest` to `highest`."""
    if isinstance(value, (str, bytes)) or not isinstance(value, Iterable):
        raise Error(name, f"is {value!r}", "two whole numbers: (height, width)")
    both = tuple(value)
    if len(both) != 2:
        raise Error(name, f"has {len(both)} numbers", "two whole numbers: (height, width)")
    return integer(both[0], name, lowest, highest), integer(both[1], name, lowest, highest)
