"""A light field: its views as arrays, what eyes see of it, and files of all formats."""

from __future__ import annotations

import contextlib
import os
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core, _notebook
from ._arguments import array, choice, file_path, integer, number, pair, path as _path, positive, vector
from ._errors import Error, Naming, Reading, known, warn, warn_of_ignored
from ._optics import Display, Optics, display_of
from ._options import LensArrangement, Sampling, Tone

_SIZE = 1 << 15
_FAR_MM = 1e9  # largest accepted coordinate of an eye
_CAMERAS_GIVEN_BY = "LightField(views, distance_mm=, baseline_mm=, pixel_mm=)"
_OF_OTHER = "is not known of a light field that was not rendered"
_RENDERED_WITH = "a frame of lippmann.render with its name among `layers`"


def formats() -> Dict[str, str]:
    """Returns the formats that `open` reads and `LightField.save` writes, as a dict from names to one-line descriptions."""
    return dict(_core.formats())


def to_codes(picture: Any, *, exposure: float = 0.0, tone: Tone = "none") -> NDArray[Any]:
    """Converts linear light of the shape (..., 3) to sRGB codes, uint8. exposure, tone: see LightField.save."""
    given = np.asarray(picture)
    if given.dtype.kind not in "fiu" or given.ndim < 2 or given.shape[-1] != 3 or given.size == 0:
        raise Error("picture", f"has the type {given.dtype} and the shape {given.shape}", "linear light of the shape (..., 3)")
    flat = np.ascontiguousarray(given, dtype=np.float32).reshape(-1, given.shape[-2], 3)
    return _core.codes_of(flat, _tone(exposure, tone)).reshape(given.shape)


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
    depth: (rows, columns, y, x) in mm in front of the plane in which views coincide. -inf where there is no surface. With poses, the
        depth is z in the frame of each camera, below 0.
    distance_mm, baseline_mm, pixel_mm: the cameras, as in lippmann.camera_grid. Give all three or none.
    world_from_camera, intrinsics_px: instead, cameras of any pose, as in the attributes of these names. Give both or none.
    split: (rows, columns) of "train", "validation" or "test", as in the attribute of this name.

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
        world_from_camera: Any = None,
        intrinsics_px: Any = None,
        split: Any = None,
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
        own = _core.Views(np.ascontiguousarray(samples), z)
        self._start(views=own)
        cameras = {"distance_mm": distance_mm, "baseline_mm": baseline_mm, "pixel_mm": pixel_mm}
        poses = {"world_from_camera": world_from_camera, "intrinsics_px": intrinsics_px}
        has_cameras, has_poses = _all_or_none(cameras), _all_or_none(poses)
        if has_cameras and has_poses:
            raise Error("world_from_camera", "cannot be combined with distance_mm", "one of the two")
        if has_cameras:
            distance, baseline, pixel = (positive(value, name) for name, value in cameras.items())
            own.set_cameras(distance, (baseline, baseline), pixel)
        if has_poses:
            _set_poses(own, world_from_camera, intrinsics_px, (rows, columns))
            if z is not None:
                _check_depth_of_poses(z)
        if split is not None:
            _set_splits(own, split, (rows, columns))

    def _start(
        self,
        views: Optional[_core.Views] = None,
        film: Optional[_core.Film] = None,
        placement: Optional[_core.Placement] = None,
        optics: Optional[Optics] = None,
        display: Optional[Display] = None,
        in_world: bool = False,
    ) -> None:
        """in_world: the poses of the cameras of rendered views are relative to the scene instead of the display."""
        self._own, self._film, self._placement, self._optics, self._display = views, film, placement, optics, display
        self._in_world = in_world
        self._shown: Optional[_core.Panel] = None
        self._layers: Dict[str, NDArray[Any]] = {}
        self.path: Optional[str] = None  # file or folder that lippmann.open read

    @classmethod
    def _of_film(cls, film: _core.Film, placement: _core.Placement, display: Optional[Display], in_world: bool) -> "LightField":
        field = cls.__new__(cls)
        field._start(film=film, placement=placement, optics=placement.optics, display=display, in_world=in_world)
        return field

    @classmethod
    def _of_file(cls, views: _core.Views, optics: Optional[Optics], path: str) -> "LightField":
        field = cls.__new__(cls)
        field._start(views=views, optics=optics)
        field.path = path
        return field

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_shown": None, "_layers": {}}  # computed again when needed

    @property
    def _views(self) -> _core.Views:
        if self._own is None:
            assert self._film is not None
            self._own = self._film.views(self._in_world)
        return self._own

    @property
    @known
    def views(self) -> NDArray[Any]:
        """(rows, columns, y, x, 3), not copied. Rendered views are linear light, float32. Opened views have the type of the file."""
        return self._views.views

    @property
    @known
    def shape(self) -> Tuple[int, ...]:
        """(rows, columns, y, x, channel)."""
        return self.views.shape

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        """Returns `views`, for np.asarray(field). copy: None copies only if necessary, False raises ValueError if a copy is necessary."""
        views = self.views
        if dtype is not None and views.dtype != dtype:
            if copy is False:
                raise ValueError(f"{views.dtype} cannot become {np.dtype(dtype)} without a copy")
            return views.astype(dtype)
        return views.copy() if copy else views

    def __len__(self) -> int:
        return len(self.views)

    def __getitem__(self, index: Any) -> NDArray[Any]:
        view: NDArray[Any] = self.views[index]
        return view

    @property
    @known
    def depth(self) -> NDArray[Any]:
        """(rows, columns, y, x), float32: mm in front of the display's plane. Negative behind the plane; -inf where there is no surface.

        If the cameras have poses of their own, the depth is z in the frame of each camera (world_from_camera), in mm: below 0.
        """
        depth = self._views.depth
        if depth is None:
            raise Error("depth", "is not known", 'layers=["depth"] when rendering, or a file that has it')
        return depth

    @property
    @known
    def disparity(self) -> NDArray[Any]:
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
    def normals(self) -> NDArray[Any]:
        """(rows, columns, y, x, 3), float32: unit normals in world space that face the viewer. 0 where there is no surface."""
        return self.layer("normal")

    @property
    @known
    def motion(self) -> NDArray[Any]:
        """(rows, columns, y, x, 2), float32: motion in the view since the previous frame, in pixels to the right and down."""
        return self.layer("motion")

    def layer(self, name: str) -> NDArray[Any]:
        """Returns (rows, columns, y, x, channels), float32: a layer that was requested in lippmann.frames or lippmann.render. Light fields
        that were not rendered have only the layer depth, if their depth is known.
        """
        name = choice(name, "name", _core.layer_names)
        if self._film is None:
            if name == "depth":
                return self.depth[..., None]
            raise Error("layer", f"{name!r} {_OF_OTHER}", _RENDERED_WITH)
        if name not in self._layers:
            rows, columns = self.shape[:2]
            flat = self._film.layer_of_views(name, rows * columns)
            self._layers[name] = flat.reshape(rows, columns, *flat.shape[1:])
        return self._layers[name]

    @property
    @known
    def picture(self) -> NDArray[Any]:
        """(y, x, 3), float32, linear: the picture of the panel. Depending on the optics: a quilt, an integral image or native pixels."""
        return self._panel().picture if self._film is None else self._film.picture

    @property
    @known
    def codes(self) -> NDArray[Any]:
        """(y, x, 3), uint8: `picture` as sRGB codes, as `lippmann render` writes it. (y, x, 4) for transparent frames."""
        return to_codes(self.picture) if self._film is None else self._film.codes

    @property
    @known
    def alpha(self) -> NDArray[Any]:
        """(rows, columns, y, x), float32, 0 to 1: the covered share of each pixel of a transparent frame.

        The views of a transparent frame hold only the light of the covered share. The views over a background of linear light are
        views + (1 - alpha[..., None]) * background.
        """
        self._require_alpha()
        return self.layer("alpha")[..., 0]

    @property
    @known
    def rgba(self) -> NDArray[Any]:
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

    def panel_layer(self, name: str) -> NDArray[Any]:
        """Returns (y, x, channels), float32: a layer in the layout of `picture`."""
        name = choice(name, "name", _core.layer_names)
        if self._film is None:
            raise Error("layer", f"{name!r} {_OF_OTHER}", _RENDERED_WITH)
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
    def eyes_mm(self) -> NDArray[Any]:
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
    def world_from_camera(self) -> NDArray[Any]:
        """(rows, columns, 4, 4), float64: matrix from the frame of each camera to the world, in mm.

        The camera's x axis points right, y up and z backwards, as in Blender and NeRF. The last column is the camera's position.
        For parallel cameras in one plane that share a window, the world is the display's frame. For other cameras of nerf, colmap
        and llff, it is the world of the files. For frames with `cameras`, it is the world of the scene, whose unit counts as 1 m.
        """
        return self._poses()[0]

    @property
    @known
    def intrinsics_px(self) -> NDArray[Any]:
        """(rows, columns, 4), float64: focal lengths and principal point (fx, fy, cx, cy) of each camera, in pixels from the top left
        corner. Pixel centres are at + 0.5. The point (x, y, z) in the camera's frame appears at (cx - fx x / z, cy + fy y / z).
        """
        return self._poses()[1]

    @property
    @known
    def split(self) -> NDArray[Any]:
        """(rows, columns), str: the part of a data set that each view belongs to: "train", "validation" or "test".

        The formats nerf, colmap and llff store it. colmap and llff do not distinguish "validation" from "test".
        """
        names = self._views.splits
        if names is None:
            raise Error("split", "is not known", "a data set with a split, or LightField(views, split=)")
        return np.array(names).reshape(self.shape[:2])

    @property
    @known
    def units_per_mm(self) -> float:
        """Scene units per mm of the display."""
        if self._placement is None:
            raise Error("scene", _OF_OTHER, "lippmann.render")
        return self._placement.units_per_mm

    @property
    @known
    def world_from_display(self) -> NDArray[Any]:
        """(4, 4), float64: transform from mm of the display to world space, at this frame."""
        if self._film is None:
            raise Error("scene", _OF_OTHER, "lippmann.render")
        return self._film.world_from_display

    def _cameras(self) -> Tuple[float, Tuple[float, float], NDArray[np.float64]]:
        cameras = self._views.cameras
        if cameras is None:
            if self._views.poses is not None:
                raise Error("cameras", "do not share a plane and a window", "world_from_camera and intrinsics_px")
            raise Error("cameras", "are not known", _CAMERAS_GIVEN_BY)
        return cameras

    def _poses(self) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
        poses = self._views.poses
        if poses is None:
            raise Error("cameras", "are not known", _CAMERAS_GIVEN_BY)
        return poses

    # ---- What eyes see -------------------------------------------------------------------------------------------------

    def _panel(self) -> _core.Panel:
        if self._shown is None:
            self._shown = self._views.panel(self._optics, None) if self._film is None else self._film.panel()
        return self._shown

    def _panel_of_eyes(self) -> _core.Panel:
        """Returns the panel for a picture that depends on the positions of the cameras. Warns if other cameras are assumed."""
        if self._film is None and self._optics is None:
            text = self._views.assumption_about_poses(self.path or "this light field")
            if text:
                warn(text)
        return self._panel()

    def refocus(
        self, z_mm: float = 0.0, size: Optional[Tuple[int, int]] = None, *, disparity: Optional[float] = None
    ) -> NDArray[Any]:
        """Returns (y, x, 3), float32, linear: the light field focused at the depth z_mm, positive in front of the display.

        size: (height, width) in pixels. None: one pixel per sample of the display.
        disparity: focuses on points with this disparity in pixels, as in the attribute `disparity`, instead of z_mm.

        If the positions of the cameras are unknown, they are assumed as in `lippmann replay`. The picture for a disparity is the same for
        any such positions. For cameras that do not share a plane and a window, a LippmannWarning states the assumption; so it does in
        `eye` and `epi`.
        """
        depth, shape, panel = number(z_mm, "z_mm"), self._size(size), self._panel_of_eyes()
        with Naming():
            if disparity is not None:
                if depth != 0.0:
                    raise Error("disparity", "cannot be combined with z_mm", "one of the two")
                depth = panel.depth_of_disparity(number(disparity, "disparity"))
            return panel.refocus(depth, shape)

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
    ) -> NDArray[Any]:
        """Returns (y, x, 3), float32, linear: the picture that an eye at (x, y, z) mm sees through the display.

        x, y, z: None is the coordinate of the intended viewing position.
        pupil_mm: diameter of the eye's pupil. 0 is a pinhole, which ignores focus_mm with a LippmannWarning.
        focus_mm: depth at which the eye is focused, in front of the display.
        nearest: True does not interpolate between the pixels below a lens.
        crosstalk: blur of each lens, as in `lippmann replay --crosstalk`. Either a standard deviation from 0 to 8 in pixels of the
            panel, or in views for quilts, such as display.crosstalk_px of a native frame; or the share of light of each neighbour,
            such as "10%".
        """
        panel = self._panel_of_eyes()
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

    def epi(self, row: Optional[int] = None, column: Optional[int] = None) -> NDArray[Any]:
        """Returns an epipolar-plane image, float32, linear. Give either `row` or `column`.

        row: a row of pixels, counted from the top. The image is (eyes, x, 3), with the leftmost eye first.
        column: a column of pixels. The image is (y, eyes, 3), with the lowest eye first.
        """
        if (row is None) == (column is None):
            raise Error("row", "and column are both given, or neither", "one of the two")
        panel = self._panel_of_eyes()
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
        binary: bool = False,
        png: bool = False,
        exposure: float = 0.0,
        tone: Tone = "none",
        precompensate: bool = False,
        crosstalk: Union[float, str, None] = None,
    ) -> List[str]:
        """Writes the light field and returns the paths of the written files. Creates a missing folder.

        format: one of lippmann.formats(), as in `lippmann convert`. None writes the panel's picture as .png or .exr. Transparent frames
            can only be written with None, as a .png with alpha.
        bits: bits per sample of float views: 8, 16, or 32 (linear floats, .exr). None: 32 for .exr, else 8.
        tiles: (rows, columns) of a quilt. The file beside the quilt keeps the grid of the views.
        display: a name or a file, for the format "native".
        binary: True writes binary files in place of text, for the format "colmap".
        png: True writes PNG in place of PPM files, for the format "jpeg-pleno".
        exposure: multiplies linear light by 2 ** exposure before it becomes codes. .exr files stay linear.
        tone: curve for light brighter than white: "none" (clipped), "neutral" (keeps hues) or "agx" (as film does).
        precompensate: True sharpens the panel's picture (format=None) in advance, to cancel the crosstalk of the display's lenses.
        crosstalk: the blur that `precompensate` cancels, as in `eye`, from 0 to 0.75 pixels. None: that of the display.

        Arguments that the format does not use are ignored with a LippmannWarning. Data that it cannot store are named in another one.
        """
        where = _path(path, "path")
        if self._is_transparent and (format is not None or not where.endswith(".png")):
            raise Error("path" if format is None else "format", "cannot store alpha", "a .png without `format`, or arrays")
        tiling = None if tiles is None else pair(tiles, "tiles", 1, 256)
        panel = None if display is None else display_of(display, "display")
        toned = _tone(exposure, tone)
        if format is None:
            if bits is not None:
                warn_of_ignored("bits", "without `format` the file extension decides")
            _warn_of_strays(tiling, panel, "", binary, png)
            if where.endswith(".exr"):
                toned = _tone_of_linear(exposure, tone)
            sigma = self._crosstalk_to_undo(precompensate, crosstalk)
            with _folder_of(where), Naming(where):
                shown: Union[_core.Film, _core.Panel] = self._panel() if self._film is None else self._film
                shown.write(where, toned, sigma)
            return [where]
        for argument, is_given in (("precompensate", precompensate), ("crosstalk", crosstalk is not None)):
            if is_given:
                warn_of_ignored(argument, "it applies to the picture of the panel, which has no `format`")
        views = self._views
        if views.views.dtype == np.float32:
            wanted = (32 if where.endswith(".exr") else 8) if bits is None else integer(bits, "bits", 8, 32)
            if wanted not in (8, 16, 32):
                raise Error("bits", f"is {wanted}", "8, 16 or 32")
            if wanted == 32:
                _tone_of_linear(exposure, tone)
            else:
                views = views.with_codes(wanted, toned)
        elif bits is not None:
            raise Error("bits", "cannot be chosen for sRGB codes", "no bits")
        elif not toned.is_identity:
            raise Error(_given_tone(exposure), "cannot be chosen for sRGB codes", "light fields of linear light")
        name = choice(format, "format", list(formats()))
        _warn_of_strays(tiling, panel, name, binary, png)
        options = _core.FormatOptions(None, tiling, panel)
        options.binary, options.png = bool(binary), bool(png)
        with _folder_of(where), Naming(where, views="format"):
            files = [os.fspath(file) for file in views.save(where, name, options)]
        lost = views.lost(name)
        if lost:
            warn(f"{where}: not written, because {name} cannot store them: {'; '.join(lost)}")
        return files

    def _crosstalk_to_undo(self, precompensate: bool, crosstalk: Union[float, str, None]) -> Optional[float]:
        if not precompensate:
            if crosstalk is not None:
                warn_of_ignored("crosstalk", "`precompensate` is not True")
            return None
        if crosstalk is not None:
            return _crosstalk(crosstalk)
        known = None
        if self._display is not None and self._optics is not None:
            known = _core.crosstalk_of_picture(self._display, self._optics)
        if known is None:
            raise Error("precompensate", "the crosstalk of the display is unknown", "crosstalk=, or a display whose file states it")
        return known

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


def _warn_of_strays(tiles: Any, display: Any, format: str, binary: bool = False, png: bool = False) -> None:
    for argument, is_given, of in (
        ("tiles", tiles is not None, "quilt"),
        ("display", display is not None, "native"),
        ("binary", binary, "colmap"),
        ("png", png, "jpeg-pleno"),
    ):
        if is_given and format != of:
            warn_of_ignored(argument, f"only the format {of!r} uses it")


def _tone(exposure: float, tone: str) -> _core.Tone:
    return _core.Tone(number(exposure, "exposure", -100.0, 100.0), choice(tone, "tone", _core.tone_names))


def _given_tone(exposure: float) -> str:
    return "exposure" if exposure else "tone"


def _tone_of_linear(exposure: float, tone: str) -> _core.Tone:
    """Returns the tone that changes nothing, because files with linear light are not tone-mapped. Warns about another tone."""
    if not _tone(exposure, tone).is_identity:
        warn_of_ignored(_given_tone(exposure), "files with linear light stay linear")
    return _tone(0.0, "none")


def _set_poses(views: _core.Views, world_from_camera: Any, intrinsics_px: Any, grid: Tuple[int, int]) -> None:
    matrices = array(world_from_camera, "world_from_camera", (*grid, 4, 4), dtype=np.float64)
    lengths = array(intrinsics_px, "intrinsics_px", (*grid, 4), dtype=np.float64)
    if not (lengths[..., :2] > 0).all():
        raise Error("intrinsics_px", "has a focal length that is not above 0", "fx, fy, cx, cy of each camera")
    if not np.allclose(matrices[..., 3, :], (0, 0, 0, 1), rtol=0, atol=1e-6):
        raise Error("world_from_camera", "has a last row other than (0, 0, 0, 1)", "a rotation and a position for each camera")
    views.set_poses(matrices.reshape(-1, 4, 4), lengths.reshape(-1, 4))


def _check_depth_of_poses(z: NDArray[Any]) -> None:
    behind = z >= 0
    if behind.any():
        place = tuple(int(i) for i in np.argwhere(behind)[0])
        raise Error(
            "depth",
            f"is {z[place]:g} at {place}",
            "with world_from_camera, z in the frame of each camera in mm, below 0; -inf where there is no surface",
        )


def _set_splits(views: _core.Views, split: Any, grid: Tuple[int, int]) -> None:
    names = np.asarray(split)
    if names.shape != grid or names.dtype.kind != "U":
        raise Error("split", f"has the type {names.dtype} and the shape {names.shape}", f"names of the shape {grid}")
    for name in np.unique(names):
        choice(str(name), "split", _core.split_names)
    views.set_splits([str(name) for name in names.flat])


def _all_or_none(arguments: Dict[str, Any]) -> bool:
    """Returns whether all arguments are given. Raises Error if only some are."""
    missing = [name for name, value in arguments.items() if value is None]
    if missing and len(missing) < len(arguments):
        raise Error(missing[0], "is missing", " and ".join(arguments) + ", or none of them")
    return not missing


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
    baseline_mm: Optional[float] = None,
    focal_length_mm: Optional[float] = None,
    focus_distance_mm: Optional[float] = None,
    sensor_width_mm: Optional[float] = None,
    white: Union[str, "os.PathLike[str]", None] = None,
    lens_pitch_px: Optional[float] = None,
    lens_row_pitch_px: Optional[float] = None,
    lens_rotation_deg: Optional[float] = None,
    lens_offset_px: Optional[Tuple[float, float]] = None,
    lens_arrangement: Optional[LensArrangement] = None,
    sampling: Sampling = "linear",
    inverted: bool = False,
) -> LightField:
    """Opens a light field from a file or folder of any format in lippmann.formats(), with depth and cameras if the files state them.

    format: a name in lippmann.formats(). None: determined by the file name and by a report.json beside the file.
    frame: index of the frame in a folder of frames.
    views: (rows, columns) of the grid, if the files do not state it.
    tiles: (rows, columns) of a quilt. Ignored for other formats, with a LippmannWarning.
    display: a name or a file, for the format "native". Ignored for other formats, with a LippmannWarning.

    Cameras, for files that do not state them, such as stanford and eslf. Give the first three, or none:
    baseline_mm: distance between neighbouring cameras; for stanford the mean distance.
    focal_length_mm, sensor_width_mm: of each camera. sensor_width_mm is the width of a view on the sensor. None: 35.
    focus_distance_mm: distance from the cameras to the plane where disparity is 0.

    Lenses, for raw pictures of plenoptic cameras (format="plenoptic"). Other formats ignore them with a LippmannWarning:
    white: a picture of uniform white light by the same camera. It removes the vignetting of the lenses, and gives the lens grid unless
        lens_pitch_px is set.
    lens_pitch_px, lens_row_pitch_px: distances between the lenses of a row, and between rows. lens_row_pitch_px=None: equally spaced.
    lens_rotation_deg: clockwise rotation of the rows. None: 0.
    lens_offset_px: (x, y) of the centre of any lens, from the top left corner. None: half a pitch from both edges.
    lens_arrangement: None is "square".
    sampling: interpolation between pixels.
    inverted: True for lenses without a main lens, as of a display.
    """
    name = "" if format is None else choice(format, "format", list(formats()))
    where = _path(path, "path")
    with Reading(where):
        files = _core.light_fields_in(where, name)
    file = files[integer(frame, "frame", 0, len(files) - 1)]
    grid = None if views is None else pair(views, "views", 1, 1 << 16)
    tiling = None if tiles is None else pair(tiles, "tiles", 1, 256)
    panel = None if display is None else display_of(display, "display")
    options = _core.FormatOptions(grid, tiling, panel)
    _state_cameras(options, baseline_mm, focal_length_mm, focus_distance_mm, sensor_width_mm)
    lenses: Dict[str, Any] = {
        "white": white,
        "lens_pitch_px": lens_pitch_px,
        "lens_row_pitch_px": lens_row_pitch_px,
        "lens_rotation_deg": lens_rotation_deg,
        "lens_offset_px": lens_offset_px,
        "lens_arrangement": lens_arrangement,
        "sampling": None if choice(sampling, "sampling", ("linear", "lanczos")) == "linear" else sampling,
        "inverted": True if inverted else None,
    }
    lenses = {argument: value for argument, value in lenses.items() if value is not None}
    if lenses:
        with Naming():
            options.set_plenoptic(_plenoptic_settings(**lenses))
    with Naming(os.fspath(file), stereo="path"):
        core, optics, found = _core.open_light_field(file, name, options)
    _warn_of_strays(tiling, panel, found)
    if found != "plenoptic":
        for argument in lenses:
            warn_of_ignored(argument, "only the format 'plenoptic' uses it")
    return LightField._of_file(core, optics, os.fspath(file))


def _state_cameras(options: _core.FormatOptions, baseline: Any, focal_length: Any, focus_distance: Any, sensor_width: Any) -> None:
    cameras = {"baseline_mm": baseline, "focal_length_mm": focal_length, "focus_distance_mm": focus_distance}
    if not _all_or_none(cameras):
        if sensor_width is not None:
            raise Error("baseline_mm", "is missing", "baseline_mm, focal_length_mm and focus_distance_mm with sensor_width_mm")
        return
    lengths = [positive(value, name) for name, value in cameras.items()]
    width = 35.0 if sensor_width is None else positive(sensor_width, "sensor_width_mm")
    options.set_cameras(lengths[0], lengths[1], width, lengths[2])


def _plenoptic_settings(
    white: Any = None,
    lens_pitch_px: Any = None,
    lens_row_pitch_px: Any = None,
    lens_rotation_deg: Any = None,
    lens_offset_px: Any = None,
    lens_arrangement: str = "",
    sampling: str = "linear",
    inverted: bool = False,
) -> _core.PlenopticSettings:
    settings = _core.PlenopticSettings()
    if white is not None:
        settings.white = os.fsdecode(file_path(white, "white"))
    if lens_pitch_px is not None:
        settings.pitch_px = number(lens_pitch_px, "lens_pitch_px")
    if lens_row_pitch_px is not None:
        settings.row_pitch_px = number(lens_row_pitch_px, "lens_row_pitch_px")
    if lens_rotation_deg is not None:
        settings.rotation_deg = number(lens_rotation_deg, "lens_rotation_deg", -180.0, 180.0)
    if lens_offset_px is not None:
        settings.set_offset_px(*vector(lens_offset_px, "lens_offset_px", 2))
    settings.arrangement, settings.lanczos, settings.inverted = lens_arrangement, sampling == "lanczos", inverted
    return settings
