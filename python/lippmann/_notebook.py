"""Shows a light field in a notebook: one view at a time, selected with sliders."""

from __future__ import annotations

import base64
import struct
import zlib
from typing import Any, List

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import Error

_SIDE, _VIEWS = 320, 81  # longest side of a picture in pixels, and largest number of pictures


def png(codes: NDArray[Any]) -> bytes:
    """Returns a PNG file of codes (y, x, 3), uint8."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    height, width = codes.shape[:2]
    rows = np.concatenate([np.zeros((height, 1), np.uint8), codes.reshape(height, 3 * width)], axis=1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6))
        + chunk(b"IEND", b"")
    )


class Shown:
    """A picture that notebooks display: `lippmann.show(field.refocus(10))`."""

    def __init__(self, codes: NDArray[Any]) -> None:
        self.codes = codes

    def _repr_png_(self) -> bytes:
        return png(self.codes)

    def __repr__(self) -> str:
        return f"<lippmann picture of {self.codes.shape[1]}x{self.codes.shape[0]} pixels>"


def _small(view: NDArray[Any]) -> NDArray[Any]:
    """Returns the view as uint8 codes, reduced to at most _SIDE pixels per side by averaging blocks of pixels."""
    step = max(1, -(-max(view.shape[:2]) // _SIDE))
    height, width = view.shape[0] // step * step, view.shape[1] // step * step
    if step > 1 and height and width:
        blocks = view[:height, :width].reshape(height // step, step, width // step, step, 3)
        view = blocks.mean(axis=(1, 3), dtype=np.float32)
    if view.dtype == np.uint8:
        return view
    if view.dtype == np.uint16:
        return (view >> 8).astype(np.uint8)
    return view


def _codes(views: NDArray[Any], view: NDArray[Any]) -> NDArray[Any]:
    small = _small(view)
    if small.dtype == np.uint8:
        return np.ascontiguousarray(small)
    if views.dtype == np.float32:
        return _core.codes_of(np.ascontiguousarray(small), _core.Tone(0.0, "none"))
    codes: NDArray[Any] = np.rint(small / (1 if views.dtype == np.uint8 else 257)).astype(np.uint8)
    return codes


def _picture(codes: NDArray[Any]) -> str:
    return "data:image/png;base64," + base64.b64encode(png(codes)).decode()


def _chosen(count: int, most: int) -> List[int]:
    return sorted({round(i) for i in np.linspace(0, count - 1, min(count, max(most, 1)))})


def _shown_size(views: NDArray[Any]) -> str:
    """Returns the CSS size of a view: its longest side is _SIDE pixels, so that small views are enlarged."""
    height, width = views.shape[2:4]
    scale = _SIDE / max(height, width)
    return f"width:{round(width * scale)}px;height:{round(height * scale)}px;image-rendering:{'pixelated' if scale > 2 else 'auto'}"


def html_of(field: Any) -> str:
    try:
        views = field.views
    except Error:
        return f'<img alt="{field!r}" src="{_picture(_small(field.codes))}">'.replace("<lippmann", "&lt;lippmann")
    rows = _chosen(views.shape[0], 9 if views.shape[1] > 1 else _VIEWS)
    columns = _chosen(views.shape[1], _VIEWS // len(rows))
    size = _shown_size(views)
    middle = len(rows) // 2, len(columns) // 2
    pictures = "".join(
        f'<img style="display:{"inline" if (i, j) == middle else "none"};{size}" src="{_picture(_codes(views, views[row, column]))}">'
        for i, row in enumerate(rows)
        for j, column in enumerate(columns)
    )
    show = (
        "const box = this.closest('[data-columns]'), s = box.querySelectorAll('input'), p = box.querySelectorAll('img'), "
        "v = +s[1].value * +box.dataset.columns + +s[0].value; p.forEach((e, i) => e.style.display = i === v ? 'inline' : 'none')"
    )

    def slider(count: int, at: int, name: str) -> str:
        hidden = ";display:none" if count < 2 else ""
        return (
            f'<input type="range" aria-label="{name}" min="0" max="{count - 1}" value="{at}" '
            f'style="width:{_SIDE}px{hidden}" oninput="{show}">'
        )

    text = repr(field).strip("<>")
    sliders = slider(len(columns), middle[1], "views from left to right") + "<br>" + slider(len(rows), middle[0], "views upwards")
    return f'<div data-columns="{len(columns)}"><div>{pictures}</div>{sliders}<div><small>{text}</small></div></div>'
