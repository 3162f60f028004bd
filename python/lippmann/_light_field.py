"""A light field: its views as arrays, what eyes see of it, and files of all formats."""

from __future__ import annotations

import contextlib
import os
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np

from . import _core, _notebook
from ._arguments import array, choice, integer, number, pair, path as _path, positive
from ._errors import Error, Naming, Reading, known, warn_of_ignored
from ._optics import Display, Optics, display_of

_SIZE = 1 << 15
_FAR_MM = 1e9  # largest accepted coordinate of an eye
_RENDERED_WITH = "a frame of lippmann.render with its name among `layers`"


def formats() -> Dict[str, str]:
    """Returns the formats that `open` reads and `LightField.save` writes, as a dict from names to one-line descriptions."""
    return dict(_core.formats())


def to_codes(picture: Any) -> np.ndarray:
    """Converts linear light of the shape (..., 3) to sRGB codes, uint8."""
    given = np.asarray(picture)
    if given.dtype.kind not in "fiu" or given.ndim < 2 or given.shape[-1] != 3 or given.size == 0:
        raise Error("picture", f"has the type {given.dtype} and the shape {given.shape}", "linear light of the shape (..., 3)")
    flat = np.ascontiguousarray(given, dtype=np.float32).reshape(-1, given.shape[-2], 3)
    return _core.codes_of(flat).reshape(given.shape)


def show(picture: Any, *, enlarge: int = 1) -> _notebook.Shown:
    """Returns an object that a notebook displays as a picture, if it is the last line of a cell.

    picture: (y, x, 3) of uint8 codes or linear light, or (y, x) of numbers, which are shown as grey: the lowest finite value is black,
        the highest is white.
    enlarge: integer factor for both sides.
    """
    given = np.asarray(picture)
    if given.ndim == 2 and given.size and given.dtype.kind in "fiu":
        finite = np.isfinite(given)
        low, high = (given[finite].min(), given[finite].max()) if finite.any() else (0.0, 0.0)
        grey = (np.where(finite, given, low).astype(np.float64) - low) / max(float(high) - float(low), 1e-30)
        given = np.repeat(np.rint(grey * 255).astype(np.uint8)[..., None], 3, axis=2)
    codes = given if given.dtype == np.uint8 and given.ndim == 3 and given.shape[2] == 3 else to_codes(given)
    if codes.ndim != 3:
        raise Error("picture", f"has the shape {given.shape}", "the shape (y, x, 3) or (y, x)")
    factor = integer(enlarge, "enlarge", 1, 64)
    return _notebook.Shown(np.ascontiguousarray(codes.repeat(factor, axis=0).repeat(factor, axis=1)))


class LightField:
    """The views of a scene at one time: (rows, columns, y, x, channel). Row 0 is the lowest, column 0 the leftmost.

    lippmann.render and lippmann.frames render light fields. lippmann.open opens them. The constructor makes one from arrays:

    views: (rows, columns, y, x, 3) of uint8 or uint16 (sRGB codes) or float32 (linear light).
    depth: (rows, columns, y, x) in mm in front of the plane in which views coincide. -inf where there is no surface.
    distance_mm, baseline_mm, pixel_mm: the cameras, as in lippmann.camera_grid. Give all three or none.

    `field[r, c]` is a view (y, x, 3). `field[r]` is a row of views. `len(field)` is the number of rows. np.asarray(field) is `views`.
    Attributes that are unknown, such as the depth of a light field without depth, raise an Error that is also an AttributeError.
    Test for them with hasattr(field, "depth"). Light fields can be pickled and deeply copied.

    Arrays that share the light field's memory are read-only. Copy an array to change it.
    """

    def __init__(
        self,
        views: Any,
        depth: Any = None,
        *,
        distance_mm: Optional[float] = None,
        baseline_mm: Optional[float] = None,
        pixel_mm: Optional[float] = None,
    ) -> None:
        samples = np.asarray(views)
        if samples.dtype not in (np.uint8, np.uint16):
            samples = array(views, "views", (None, None, None, None, 3))
        elif samples.ndim != 5 or samples.shape[4] != 3 or samples.size == 0:
            raise Error("views", f"has the shape {samples.shape}", "the shape (rows, columns, y, x, 3)")
        rows, columns, height, width = samples.shape[:4]
        if rows * columns > 1 << 16 or height * rows * columns > np.iinfo(np.int32).max or width > _SIZE:
            raise Error("views", f"has the shape {samples.shape}", "at most 65536 views of at most 32768 pixels a side")
        z = None if depth is None else array(depth, "depth", samples.shape[:4], finite=False)
        self._start(views=_core.Views(np.ascontiguousarray(samples), z))
        cameras = {"distance_mm": distance_mm, "baseline_mm": baseline_mm, "pixel_mm": pixel_mm}
        missing = [name for name, value in cameras.items() if value is None]
        if len(missing) == 3:
            return
        if missing:
            raise Error(missing[0], "is missing", "distance_mm, baseline_mm and pixel_mm, or none of them")
        distance, baseline, pixel = (positive(value, name) for name, value in cameras.items())
        self._own.set_cameras(distance, (baseline, baseline), pixel)

    def _start(
        self,
        views: Any = None,
        film: Any = None,
        placement: Any = None,
        optics: Optional[Optics] = None,
        display: Optional[Display] = None,
    ) -> None:
        self._own, self._film, self._placement, self._optics, self._display = views, film, placement, optics, display
        self._shown: Any = None
        self._layers: Dict[str, np.ndarray] = {}
        self.path: Optional[str] = None  # file or folder that lippmann.open read

    @classmethod
    def _of_film(cls, film: Any, placement: Any, display: Optional[Display]) -> "LightField":
        field = cls.__new__(cls)
        field._start(film=film, placement=placement, optics=placement.optics, display=display)
        return field

    @classmethod
    def _of_file(cls, views: Any, optics: Optional[Optics], path: str) -> "LightField":
        field = cls.__new__(cls)
        field._start(views=views, optics=optics)
        field.path = path
        return field

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_shown": None, "_layers": {}}  # computed again when needed

    @property
    def _views(self) -> Any:
        if self._own is None:
            self._own = self._film.views()
        return self._own

    @property
    @known
    def views(self) -> np.ndarray:
        """(rows, columns, y, x, 3), not copied. Rendered views are linear light, float32. Opened views have the type of the file."""
        return self._views.views

    @property
    @known
    def shape(self) -> Tuple[int, ...]:
        """(rows, columns, y, x, channel)."""
        return self.views.shape

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> np.ndarray:
        """Returns `views`, for np.asarray(field). copy: None copies only if necessary, False raises ValueError if a copy is necessary."""
        views = self.views
        if dtype is not None and views.dtype != dtype:
            if copy is False:
                raise ValueError(f"{views.dtype} cannot become {np.dtype(dtype)} without a copy")
            return views.astype(dtype)
        return views.copy() if copy else views

    def __len__(self) -> int:
        return len(self.views)

    def __getitem__(self, index: Any) -> np.ndarray:
        return self.views[index]

    @property
    @known
    def depth(self) -> np.ndarray:
        """(rows, columns, y, x), float32: mm in front of the display's plane. Negative behind the plane; -inf where there is no surface."""
        depth = self._views.depth
        if depth is None:
            raise Error("depth", "is not known", 'layers=["depth"] when rendering, or a file that has it')
        return depth

    @property
    @known
    def disparity(self) -> np.ndarray:
        """(rows, columns, y, x), float32: shift of a point, in pixels, from a view to its neighbour.

        The disparity is the shift to the left between a view and the next view on the right. For views of the last column, it is the
        shift between the previous view and this view. In a grid with a single column, it is the shift downwards between a view and the
        next higher view. It is positive in front of the display, as in the HCI benchmark. It is -inf where there is no surface, as in
        `depth`. The disparity of a receding point approaches -step / pixel_mm, where step is the distance between neighbouring eyes.
        """
        distance, pixel, eyes = self._cameras()
        rows, columns = eyes.shape[:2]
        if rows * columns < 2:
            raise Error("disparity", "needs two views, but there is only one", "several views")
        across = columns > 1
        places = eyes[..., 0] if across else eyes[..., 1].T
        steps = np.diff(places, axis=1)
        steps = np.concatenate([steps, steps[:, -1:]], axis=1)
        steps = (steps if across else steps.T)[..., None, None] / pixel[1 if across else 0]
        depth = self.depth.astype(np.float64)
        with np.errstate(divide="ignore", invalid="ignore"):
            disparity = steps * (distance / (distance - depth) - 1.0)
        return np.where(depth == -np.inf, -np.inf, disparity).astype(np.float32)

    @property
    @known
    def normals(self) -> np.ndarray:
        """(rows, columns, y, x, 3), float32: unit normals in world space that face the viewer. 0 where there is no surface."""
        return self.layer("normal")

    @property
    @known
    def motion(self) -> np.ndarray:
        """(rows, columns, y, x, 2), float32: motion in the view since the previous frame, in pixels to the right and down."""
        return self.layer("motion")

    def layer(self, name: str) -> np.ndarray:
        """Returns (rows, columns, y, x, channels), float32: a layer that was requested in lippmann.frames or lippmann.render. Light fields
        that were not rendered have only the layer depth, if their depth is known.
        """
        name = choice(name, "name", _core.layer_names)
        if self._film is None:
            if name == "depth":
                return self.depth[..., None]
            raise Error("layer", f"{name!r} is not known of a light field that was not rendered", _RENDERED_WITH)
        if name not in self._layers:
            rows, columns = self.shape[:2]
            flat = self._film.layer_of_views(name, rows * columns)
            self._layers[name] = flat.reshape(rows, columns, *flat.shape[1:])
        return self._layers[name]

    @property
    @known
    def picture(self) -> np.ndarray:
        """(y, x, 3), float32, linear: the picture of the panel. Depending on the optics: a quilt, an integral image or native pixels."""
        return self._panel().picture if self._film is None else self._film.picture

    @property
    @known
    def codes(self) -> np.ndarray:
        """(y, x, 3), uint8: `picture` as sRGB codes, as `lippmann render` writes it. (y, x, 4) for transparent frames."""
        return to_codes(self.picture) if self._film is None else self._film.codes

    @property
    @known
    def alpha(self) -> np.ndarray:
        """(rows, columns, y, x), float32, 0 to 1: the covered share of each pixel of a transparent frame.

        The views of a transparent frame hold only the light of the covered share. The views over a background of linear light are
        views + (1 - alpha[..., None]) * background.
        """
        self._require_alpha()
        return self.layer("alpha")[..., 0]

    @property
    @known
    def rgba(self) -> np.ndarray:
        """(rows, columns, y, x, 4), uint8: sRGB codes of transparent views with straight alpha, as picture files store them."""
        alpha = self.alpha[..., None]
        shown = alpha > 0
        straight = np.divide(self.views, alpha, out=np.zeros_like(self.views), where=shown)
        return np.concatenate([to_codes(straight), np.floor(np.clip(alpha, 0, 1) * 255 + 0.5).astype(np.uint8)], axis=-1)

    def _require_alpha(self) -> None:
        if not self._is_transparent:
            raise Error("alpha", "is not known", "transparent=True when rendering")

    @property
    def _is_transparent(self) -> bool:
        return self._film is not None and self._film.is_transparent

    def panel_layer(self, name: str) -> np.ndarray:
        """Returns (y, x, channels), float32: a layer in the layout of `picture`."""
        name = choice(name, "name", _core.layer_names)
        if self._film is None:
            raise Error("layer", f"{name!r} is not known of a light field that was not rendered", _RENDERED_WITH)
        return self._film.layer(name)

    @property
    def optics(self) -> Optional[Optics]:
        """The optics of the light field; None if unknown."""
        return self._optics

    @property
    def report(self) -> Dict[str, Any]:
        """Figures of the rendering: frame, kind, seconds, cpu_seconds, rays and others. Empty if the light field was not rendered.

        estimated_psnr_db is the estimated quality of the frame. psnr_at_least_db and psnr_at_most_db are the limits of the estimate. All
        three are None if there is no estimate.
        """
        return {} if self._film is None else self._film.report

    @property
    @known
    def eyes_mm(self) -> np.ndarray:
        """(rows, columns, 2), float64: x and y of each view's eye, in the plane z = distance_mm."""
        return self._cameras()[2]

    @property
    @known
    def distance_mm(self) -> float:
        """Distance from the eyes to the plane in which views coincide."""
        return self._cameras()[0]

    @property
    @known
    def pixel_mm(self) -> Tuple[float, float]:
        """(height, width) in mm of a view's pixel, in the plane in which views coincide."""
        return self._cameras()[1]

    @property
    @known
    def world_from_camera(self) -> np.ndarray:
        """(rows, columns, 4, 4), float64: pose of each camera, in mm. The camera's x axis points right, y up and z backwards."""
        return self._poses()[0]

    @property
    @known
    def intrinsics_px(self) -> np.ndarray:
        """(rows, columns, 4), float64: focal lengths and principal point (fx, fy, cx, cy) of each camera."""
        return self._poses()[1]

    @property
    @known
    def units_per_mm(self) -> float:
        """Scene units per mm of the display."""
        return self._placed().units_per_mm

    @property
    @known
    def world_from_display(self) -> np.ndarray:
        """(4, 4), float64: transform from mm of the display to world space, at this frame."""
        self._placed()
        return self._film.world_from_display

    def _placed(self) -> Any:
        if self._placement is None:
            raise Error("scene", "is not known of a light field that was not rendered", "lippmann.render")
        return self._placement

    def _cameras(self) -> Any:
        cameras = self._views.cameras
        if cameras is None:
            raise Error("cameras", "are not known", "LightField(views, distance_mm=, baseline_mm=, pixel_mm=)")
        return cameras

    def _poses(self) -> Any:
        poses = self._views.poses
        if poses is None:
            raise Error("cameras", "are not known", "LightField(views, distance_mm=, baseline_mm=, pixel_mm=)")
        return poses

    def _panel(self) -> Any:
        if self._shown is None:
            self._shown = self._views.panel(self._optics, None) if self._film is None else self._film.panel()
        return self._shown

    def refocus(self, z_mm: float = 0.0, size: Optional[Tuple[int, int]] = None) -> np.ndarray:
        """Returns (y, x, 3), float32, linear: the light field focused at the depth z_mm, positive in front of the display.

        size: (height, width) in pixels. None: one pixel per sample of the display. If the positions of the cameras are unknown, they
        are assumed as in `lippmann replay`.
        """
        depth, shape = number(z_mm, "z_mm"), self._size(size)
        with Naming():
            return self._panel().refocus(depth, shape)

    def eye(
        self,
        x: Optional[float] = None,
        y: Optional[float] = None,
        z: Optional[float] = None,
        *,
        size: Optional[Tuple[int, int]] = None,
        pupil_mm: float = 0.0,
        focus_mm: float = 0.0,
        nearest: bool = False,
        crosstalk: Union[float, str] = 0.0,
    ) -> np.ndarray:
        """Returns (y, x, 3), float32, linear: the picture that an eye at (x, y, z) mm sees through the display.

        x, y, z: None is the coordinate of the intended viewing position.
        pupil_mm: diameter of the eye's pupil. 0 is a pinhole, which ignores focus_mm with a LippmannWarning.
        focus_mm: depth at which the eye is focused, in front of the display.
        nearest: True does not interpolate between the pixels below a lens.
        crosstalk: blur of each lens, as in `lippmann replay --crosstalk`. Either a standard deviation from 0 to 8 in pixels of the panel
            (for quilts in views), such as display.crosstalk_px of a native frame; or the share of light of each neighbour, such as "10%".
        """
        panel = self._panel()
        eye = tuple(
            float(at) if given is None else number(given, name, -_FAR_MM, _FAR_MM)
            for given, at, name in zip((x, y, z), panel.optics.default_eye_mm, "xyz")
        )
        pupil = number(pupil_mm, "pupil_mm", 0.0, 1e6)
        focus, blur = number(focus_mm, "focus_mm"), _crosstalk(crosstalk)
        if focus != 0.0 and pupil == 0.0:
            warn_of_ignored("focus_mm", "a pinhole has no focus, and pupil_mm is 0")
        shape = self._size(size)
        with Naming(eye="z", pupil="pupil_mm", focus="focus_mm"):
            return panel.eye(eye, shape, pupil, focus, bool(nearest), blur)

    def epi(self, row: Optional[int] = None, column: Optional[int] = None) -> np.ndarray:
        """Returns an epipolar-plane image, float32, linear. Give either `row` or `column`.

        row: a row of pixels, counted from the top. The image is (eyes, x, 3), with the leftmost eye first.
        column: a column of pixels. The image is (y, eyes, 3), with the lowest eye first.
        """
        if (row is None) == (column is None):
            raise Error("row", "and column are both given, or neither", "one of the two")
        panel = self._panel()
        of_row = row is not None
        line = integer(row, "row", 0, _SIZE) if of_row else integer(column, "column", 0, _SIZE)
        with Naming(**{"epi": "row", "epi-column": "column"}):
            return panel.epi_row(line) if of_row else panel.epi_column(line)

    @staticmethod
    def _size(size: Optional[Tuple[int, int]]) -> Optional[Tuple[int, int]]:
        return None if size is None else pair(size, "size", 1, _SIZE)

    def save(
        self,
        path: Union[str, "os.PathLike[str]"],
        format: Optional[str] = None,
        *,
        bits: Optional[int] = None,
        tiles: Optional[Tuple[int, int]] = None,
        display: Any = None,
    ) -> List[str]:
        """Writes the light field and returns the paths of the written files. Creates a missing folder.

        format: one of lippmann.formats(), as in `lippmann convert`. None writes the panel's picture as .png or .exr. Transparent frames
            can only be written with None, as a .png with alpha.
        bits: bits per sample of float views: 8, 16, or 32 (linear floats, .exr). None: 32 for .exr, else 8.
        tiles: (rows, columns) of a quilt.
        display: a name or a file, for the format "native".

        Arguments that the format does not use are ignored with a LippmannWarning.
        """
        where = _path(path, "path")
        if self._is_transparent and (format is not None or not where.endswith(".png")):
            raise Error("path" if format is None else "format", "cannot store alpha", "a .png without `format`, or arrays")
        tiling = None if tiles is None else pair(tiles, "tiles", 1, 256)
        panel = None if display is None else display_of(display, "display")
        if format is None:
            if bits is not None:
                warn_of_ignored("bits", "without `format` the file extension decides")
            _warn_of_strays(tiling, panel, "")
            with _folder_of(where):
                self._write_picture(where)
            return [where]
        views = self._views
        if views.views.dtype == np.float32:
            wanted = (32 if where.endswith(".exr") else 8) if bits is None else integer(bits, "bits", 8, 32)
            if wanted not in (8, 16, 32):
                raise Error("bits", f"is {wanted}", "8, 16 or 32")
            views = views if wanted == 32 else views.with_codes(wanted)
        elif bits is not None:
            raise Error("bits", "cannot be chosen for sRGB codes", "no bits")
        name = choice(format, "format", list(formats()))
        _warn_of_strays(tiling, panel, name)
        with _folder_of(where), Naming(where, views="format"):
            return [os.fspath(file) for file in views.save(where, name, tiling, panel)]

    def _write_picture(self, where: str) -> None:
        if self._film is not None:
            return self._film.write(where)
        _core.write_picture(self._panel().picture, where)

    def to_xarray(self) -> Any:
        """Returns an xarray.Dataset of the views, and of depth, alpha and the positions of the eyes if known. The axes are row, column, y,
        x and channel. Lengths have the attribute units = "mm". An attribute of the views states whether they are linear radiance (float32)
        or sRGB codes. Raises ImportError if xarray (python3-xarray) is not installed.
        """
        try:
            import xarray  # type: ignore[import]
        except ImportError:
            raise ImportError("xarray is not installed: apt install python3-xarray, or pip install xarray") from None
        axes = ("row", "column", "y", "x")
        meaning = "linear radiance" if self.views.dtype == np.float32 else "sRGB codes"
        data: Dict[str, Any] = {"views": (axes + ("channel",), self.views, {"long_name": meaning})}
        if self._views.depth is not None:
            data["depth"] = (axes, self.depth, {"units": "mm"})
        if self._is_transparent:
            data["alpha"] = (axes, self.alpha)
        places: Dict[str, Any] = {"channel": ["red", "green", "blue"]}
        if self._views.cameras is not None:
            places["eye_x_mm"] = (axes[:2], self.eyes_mm[..., 0], {"units": "mm"})
            places["eye_y_mm"] = (axes[:2], self.eyes_mm[..., 1], {"units": "mm"})
        return xarray.Dataset(data, places, {"row_0": "lowest", "column_0": "leftmost"})

    def _repr_html_(self) -> str:
        return _notebook.html_of(self)

    def __repr__(self) -> str:
        try:
            shape, dtype = self.shape, self.views.dtype
        except Error:  # optics without views have only the panel's picture
            return f"<lippmann.LightField: a panel of {self.picture.shape[1]}x{self.picture.shape[0]} pixels>"
        rows, columns, height, width = shape[:4]
        return f"<lippmann.LightField: {rows} x {columns} views (rows x columns), {width}x{height} pixels, {dtype}>"


@contextlib.contextmanager
def _folder_of(path: str) -> Iterator[None]:
    """Creates the folder of `path`. If the body raises an exception, removes the created folders."""
    folder = os.path.dirname(path)
    missing = []
    while folder and not os.path.isdir(folder):
        missing.append(folder)
        folder = os.path.dirname(folder)
    try:
        for one in reversed(missing):
            _make(one)
        yield
    except BaseException:
        for one in missing:
            with contextlib.suppress(OSError):
                os.rmdir(one)
        raise


def _make(folder: str) -> None:
    try:
        os.makedirs(folder, exist_ok=True)  # another process may have created it meanwhile
    except OSError as error:
        raise Error(folder, f"cannot be created: {error.strerror}", "a folder that can be written to") from None


def _warn_of_strays(tiles: Any, display: Any, format: str) -> None:
    for argument, value, of in (("tiles", tiles, "quilt"), ("display", display, "native")):
        if value is not None and format != of:
            warn_of_ignored(argument, f"only the format {of!r} uses it")


def _crosstalk(value: Union[float, str]) -> float:
    return _core.read_crosstalk(value) if isinstance(value, str) else number(value, "crosstalk", 0.0, 8.0)


def open(
    path: Union[str, "os.PathLike[str]"],
    *,
    format: Optional[str] = None,
    frame: int = 0,
    views: Optional[Tuple[int, int]] = None,
    tiles: Optional[Tuple[int, int]] = None,
    display: Any = None,
) -> LightField:
    """Opens a light field from a file or folder of any format in lippmann.formats(), with depth and cameras if the files state them.

    format: a name in lippmann.formats(). None: determined by the file name and by a report.json beside the file.
    frame: index of the frame in a folder of frames.
    views: (rows, columns) of the grid, if the files do not state it.
    tiles: (rows, columns) of a quilt. Ignored for other formats, with a LippmannWarning.
    display: a name or a file, for the format "native". Ignored for other formats, with a LippmannWarning.
    """
    name = "" if format is None else choice(format, "format", list(formats()))
    where = _path(path, "path")
    with Reading(where):
        files = _core.light_fields_in(where, name)
    file = files[integer(frame, "frame", 0, len(files) - 1)]
    grid = None if views is None else pair(views, "views", 1, 1 << 16)
    tiling = None if tiles is None else pair(tiles, "tiles", 1, 256)
    panel = None if display is None else display_of(display, "display")
    with Naming(os.fspath(file), stereo="path"):
        core, optics, found = _core.open_light_field(file, name, grid, tiling, panel)
    _warn_of_strays(tiling, panel, found)
    return LightField._of_file(core, optics, os.fspath(file))
