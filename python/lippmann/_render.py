"""Renders frames of a scene through a display or optics as light fields in memory."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterable, Iterator, List, Optional, Sequence, Set, Tuple, Union, overload

from . import _core
from ._arguments import choice, integer, number, path, text
from ._errors import Error, Naming, warn_of_ignored
from ._light_field import LightField
from ._optics import Display, Optics, camera_grid, display_of, single_view
from ._options import AngularFilter, Denoise, Environment, FitTo, Integrator, Layer, Layout, Light, Progress, Reuse
from ._scene import Scene, choose_camera, load, strength_and_turn, surround


class Animation:
    """A sequence of frames of a scene, each of which is rendered when it is accessed.

    Use `for field in animation`, `animation[3]` or `len(animation)`. `animation[2:5]` is an Animation of these frames. With `reuse`,
    access frames in ascending order, which is the fastest. A pickle or a copy holds the scene and the settings, not the frames.
    """

    def __init__(
        self,
        core: Any,
        settings: Any,
        frames: Sequence[int],
        display: Optional[Display],
        progress: Optional[Progress],
        tests: Optional[Tuple[int, ...]],
    ) -> None:
        """core: the _core.Frames that renders. settings: the sampling, the reuse and the number of threads of `core`.
        tests: the numbers of the frames for testing, or None without `cameras`.
        """
        self._core, self._settings, self._frames, self._display, self._progress = core, settings, frames, display, progress
        self._tests = tests

    def __len__(self) -> int:
        return len(self._frames)

    def __repr__(self) -> str:
        count = len(self)
        return f"<lippmann.Animation: {count} frame{'' if count == 1 else 's'}>"

    def __reduce__(self) -> Any:
        made_of = (self._core.scene, self._core.placement, *self._settings)
        return _remade, (made_of, self._settings, self._frames, self._display, self._progress, self._tests)

    @overload
    def __getitem__(self, index: int) -> LightField: ...

    @overload
    def __getitem__(self, index: slice) -> "Animation": ...

    def __getitem__(self, index: Union[int, slice]) -> Union[LightField, "Animation"]:
        if isinstance(index, slice):
            return Animation(self._core, self._settings, self._frames[index], self._display, self._progress, self._tests)
        if not -len(self) <= index < len(self):
            raise IndexError(f"{index} is outside {len(self)} frames")
        return self._frame(self._frames[index])

    def __iter__(self) -> Iterator[LightField]:
        for frame in self._frames:
            yield self._frame(frame)

    def _frame(self, frame: int) -> LightField:
        report = self._progress
        progress = None if report is None else lambda share: report(frame, share)
        with Naming(optics="display"):
            film = self._core.frame(frame, progress)
        return LightField._of_film(film, self._core.placement, self._display, in_world=self._tests is not None)

    @property
    def test_frames(self) -> Tuple[int, ...]:
        """Numbers of the frames for testing, if the frames have `cameras`: one in eight, chosen by `seed` as in the tool.
        The other frames are for training. Empty without `cameras`.
        """
        return () if self._tests is None else tuple(frame for frame in self._frames if frame in self._tests)


def _remade(made_of: Any, *rest: Any) -> Animation:
    """Restores an Animation from a pickle. made_of: arguments of _core.Frames. rest: the other arguments of Animation."""
    return Animation(_core.Frames(*made_of), *rest)


def frames(
    scene: Union[Scene, str, "os.PathLike[str]"],
    display: Union[Display, Optics, str, "os.PathLike[str]", None] = None,
    *,
    frames: Optional[Iterable[int]] = None,
    layout: Layout = "views",
    layers: Union[Layer, Iterable[Layer]] = (),
    integrator: Optional[Integrator] = None,
    spp: Optional[int] = None,
    max_depth: int = 0,
    seed: int = 0,
    clamp_indirect: float = 0.0,
    denoise: Union[Denoise, bool] = "auto",
    angular_filter: Optional[AngularFilter] = None,
    aperture_mm: float = 0.0,
    f_number: float = 0.0,
    focal_plane_mm: float = 0.0,
    shutter: float = 0.0,
    reuse: Reuse = "auto",
    keyframes: Optional[int] = None,
    min_psnr: Optional[float] = None,
    fit_depth: Optional[bool] = None,
    focus: str = "",
    fit_to: FitTo = "",
    zoom: float = 1.0,
    orbit: Tuple[float, float] = (0.0, 0.0),
    light: Light = "auto",
    environment: Optional[Environment] = None,
    environment_strength: float = 1.0,
    environment_rotation_deg: float = 0.0,
    camera: Union[str, int, None] = None,
    cameras: Optional[str] = None,
    transparent: bool = False,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> Animation:
    """Renders frames of a scene as light fields. Each frame is rendered when it is accessed. Ctrl-C stops (KeyboardInterrupt).

    scene: a lippmann.Scene, the name of a built-in scene, or a file.
    display: the name of a preset, a file (.toml, or a .json calibration), a lippmann.Display, or optics such as lippmann.camera_grid().
        None: lippmann.camera_grid().
    frames: frame numbers, counted from 0. None: all frames.
    layout: "views" renders views, which a slanted panel shows as a quilt. "native" renders the pixels of a slanted panel.
    layers: data of every pixel beside its colour. depth (mm in front of the display), ray-depth, normal and position (in world space),
        id, albedo, motion (pixels since the previous frame), provenance (codes of docs/guide/reuse.md), direct, indirect. "disparity"
        is accepted as another name of depth.
    integrator: "path" traces random paths and includes all light. "whitted" is fast: direct light, sharp shadows and mirrors. None is
        whitted for built-in scenes, for other scenes of formats that describe Whitted's shading, and for files that contain only
        splats; it is path for all other scenes.
    spp: samples per pixel. None is 16 for path, 4 for files that contain only splats, and 1 otherwise.
    max_depth: largest number of vertices of a path. 0: the limit in the scene.
    seed: seed of the random paths.
    clamp_indirect: upper bound of the indirect light of a path. It removes fireflies but loses light. 0: no bound.
    denoise: "auto" or True removes the noise of path-traced frames of 2 or more spp. "none" or False does not.
    angular_filter: "none" renders each view from one eye. "box" averages each view over the range between its neighbours, which blurs
        depth beyond the depth budget. None: "box" for quilts of a display, otherwise "none".
    aperture_mm: diameter of the lens of each view, for depth of field. Needs 2 or more spp.
    f_number: defines the aperture instead, as that of a camera with a sensor 36 mm wide, for scenes in metres.
    focal_plane_mm: depth in focus, in front of the display's plane.
    shutter: share of the time between frames, from 0 to 1, over which motion is blurred. Needs 2 or more spp.
    reuse: "auto", "none", "copy" or "interpolate" (docs/guide/reuse.md). copy and interpolate need integrator="whitted".
    keyframes: for copy and interpolate, the largest distance between key frames. "auto" ignores a value that it cannot use, with a
        LippmannWarning. "none" raises Error.
    min_psnr: for interpolate, the lowest PSNR of a frame in dB.
    fit_depth: True reduces the depth of scenes that exceed the display's depth budget. None decides as `lippmann render` does, and is
        False for custom optics.
    focus: places the display's plane at a node (by name), at a point ("x,y,z") or at a distance from the viewer, in scene units.
    fit_to: the node, by name, that fills the picture with its children. "all": the whole scene fills the picture.
    zoom: factor that enlarges the middle of the view.
    orbit: (right, up): angles in degrees by which the viewer moves around the subject.
    light: "auto" adds light to scenes without any, as `lippmann render` does. "none" adds nothing.
    environment: surrounds and lights the scene, in place of the scene's environment. "studio" is built in. A panorama is equirectangular
        with the zenith on top: a file (.hdr, .exr, .pfm, .tif) or an array (y, x, 3) of linear light. A colour has 3 numbers. "none"
        keeps the scene's own light, as light="none" does.
    environment_strength: factor of the environment's light. Without `environment` it is ignored, with a LippmannWarning.
    environment_rotation_deg: rotation about +y. Without `environment` it is ignored, with a LippmannWarning.
    camera: the camera that sets the view, by name or index in Scene.cameras. None: the first camera.
    cameras: "sphere:N", "hemisphere:N" or "circle:N" shows the still scene from N cameras around it, one per frame, as
        `lippmann render --cameras` does. Then `display` is a single view; None: lippmann.single_view(). Its field of view is that of the
        scene's camera, or 45 degrees. LightField.world_from_camera is the pose in the scene. Animation.test_frames is the split.
    transparent: True hides the environment, which still lights the scene. LightField.alpha is the coverage.
    threads: number of threads. 0: one per processor. The number does not affect the result.
    progress: called as progress(frame, share) about every 50 ms, in the calling thread. An exception stops the render. The share starts
        again at 0 for every frame on which the requested frame depends.

    These flags of `lippmann render` are not arguments of lippmann.frames:
    --up, --variant, --animation, --texture-memory, --light-scale, --points and others that read a file: see lippmann.load.
    --exposure, --tone, --precompensate, --crosstalk: see LightField.save, because arrays hold linear light.
    --optics and its parameters: see lippmann.camera_grid, lippmann.optics and the other functions that make optics.
    --order: it changes only the speed.
    --splat, --fill, --halving, --no-z-buffer, --debug: they are variants of reuse="interpolate" for experiments.
    """
    if isinstance(scene, Scene):
        core = scene._core.copy()
    else:
        core = load(path(scene, "scene"))._core
    if str(reuse) == "light":
        accepted = "denoise='auto' (the default), reuse='auto' or 'none'"
        raise Error("reuse", "'light' was removed: path-traced frames are denoised instead", accepted)
    sharing = choice(reuse, "reuse", ("auto", "none", "copy", "interpolate"))
    named = "" if integrator is None else choice(integrator, "integrator", tuple(_core.integrator_names()))
    sampling = _core.Sampling(core, named, sharing == "interpolate")
    wanted = _layers(layers)
    if progress is not None and not callable(progress):
        raise Error("progress", f"is {progress!r}", "a function of frame and share")
    denoised = denoise if isinstance(denoise, bool) else choice(denoise, "denoise", ("auto", "none")) == "auto"
    if denoise is True and not sampling.is_stochastic:
        raise Error("denoise", "needs path tracing", "denoise='auto' or integrator='path'")
    samples = sampling.spp if spp is None else integer(spp, "spp", 1, 1 << 20)
    depth_limit = integer(max_depth, "max_depth", 0, 1 << 16)
    key = integer(seed, "seed", 0, (1 << 32) - 1)
    every = None if keyframes is None else integer(keyframes, "keyframes", 1, 1 << 20)
    floor = None if min_psnr is None else number(min_psnr, "min_psnr", 1.0, 100.0)
    opening = number(aperture_mm, "aperture_mm", 0.0, 1e6), number(f_number, "f_number", 0.0, 1e6)
    focal_plane = number(focal_plane_mm, "focal_plane_mm", -1e6, 1e6)
    limit = number(clamp_indirect, "clamp_indirect", 0.0, 1e6)
    angular = None if angular_filter is None else choice(angular_filter, "angular_filter", ("none", "box"))
    open_share = number(shutter, "shutter", 0.0, 1.0)
    workers = integer(threads, "threads", 0, 4096)
    choice(light, "light", ("auto", "none"))
    core.move_near_origin()  # raises Error for an invalid scene
    choose_camera(core, camera)
    tests = None
    if cameras is not None:
        tests = tuple(core.surround_with_cameras(text(cameras, "cameras"), key))
        display = _one_view(display)
    which = _which(frames, core.frame_count)
    if isinstance(environment, str) and environment == "none":
        environment, light = None, "none"
    factor, turn = strength_and_turn(environment_strength, environment_rotation_deg, "environment_")
    if environment is not None:
        surround(core, environment, factor, turn, "environment")
    else:
        for argument, is_given in (("environment_strength", factor != 1.0), ("environment_rotation_deg", turn != 0.0)):
            if is_given:
                warn_of_ignored(argument, "`environment` is not given")
    if environment is None and light == "auto" and not (sampling.is_stochastic and core.kind == "whitted"):
        core.add_missing_light(sampling)
    native = choice(layout, "layout", ("views", "native")) == "native"
    if native and transparent:
        raise Error("transparent", "cannot be combined with layout='native'", "layout='views'")
    placement, shown = _place(core, display, native, fit_depth, focus, fit_to, zoom, orbit, tests is not None)
    sampling.spp, sampling.max_depth, sampling.seed = samples, depth_limit, key
    sampling.denoise, sampling.transparent = denoised, bool(transparent)
    sampling.set_lens(*opening, focal_plane)
    sampling.shutter, sampling.clamp_indirect = open_share, limit
    if angular is not None:
        sampling.set_angular_filter(angular == "box")
    sampling.want_layers(wanted)
    chosen = _reuse(sharing, every, floor, set(wanted), sampling)
    settings = sampling, chosen, workers
    with Naming(optics="display"):
        made = _core.Frames(core, placement, *settings)
    return Animation(made, settings, which, shown, progress, tests)


def _one_view(display: Any) -> Optics:
    """Returns the optics of frames with `cameras`."""
    if display is None:
        return single_view()
    if not isinstance(display, Optics) or not display.is_single_view:
        raise Error("display", "is not a single view, but `cameras` renders one view per frame", "lippmann.single_view(size)")
    return display


def render(
    scene: Union[Scene, str, "os.PathLike[str]"],
    display: Union[Display, Optics, str, "os.PathLike[str]", None] = None,
    *,
    frame: int = 0,
    layout: Layout = "views",
    layers: Union[Layer, Iterable[Layer]] = (),
    integrator: Optional[Integrator] = None,
    spp: Optional[int] = None,
    max_depth: int = 0,
    seed: int = 0,
    clamp_indirect: float = 0.0,
    denoise: Union[Denoise, bool] = "auto",
    angular_filter: Optional[AngularFilter] = None,
    aperture_mm: float = 0.0,
    f_number: float = 0.0,
    focal_plane_mm: float = 0.0,
    shutter: float = 0.0,
    reuse: Reuse = "auto",
    keyframes: Optional[int] = None,
    min_psnr: Optional[float] = None,
    fit_depth: Optional[bool] = None,
    focus: str = "",
    fit_to: FitTo = "",
    zoom: float = 1.0,
    orbit: Tuple[float, float] = (0.0, 0.0),
    light: Light = "auto",
    environment: Optional[Environment] = None,
    environment_strength: float = 1.0,
    environment_rotation_deg: float = 0.0,
    camera: Union[str, int, None] = None,
    cameras: Optional[str] = None,
    transparent: bool = False,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> LightField:
    """Renders one frame as a light field. Arguments are those of lippmann.frames, except `frame`."""
    options: Dict[str, Any] = dict(locals())
    options["frames"] = _Frame([options.pop("frame")])
    return frames(**options)[0]


class _Frame(List[int]):
    """A list with the single frame of lippmann.render. Its type makes errors name the argument `frame` instead of `frames`."""


def _which(frames: Optional[Iterable[int]], count: int) -> Sequence[int]:
    if frames is None:
        return range(count)
    try:
        listed = list(frames)
    except TypeError:
        raise Error("frames", f"is {frames!r}", "frame numbers: range(10), [0, 5]") from None
    argument = "frame" if isinstance(frames, _Frame) else "frames"
    return [integer(frame, argument, 0, count - 1) for frame in listed]


def _reuse(
    name: str, keyframes: Optional[int], min_psnr: Optional[float], layers: Set[str], sampling: Any
) -> Any:
    """Returns a _core.Reuse. Raises Error if the arguments exclude each other. min_psnr limits only "interpolate", because
    traced and copied frames of Whitted's shading have no error."""
    if min_psnr is not None and sampling.is_stochastic:
        accepted = "spp for path tracing; min_psnr with reuse='interpolate'"
        raise Error("min_psnr", "was removed for path tracing", accepted)
    if name == "auto":
        is_blurred = sampling.shutter > 0.0
        if sampling.can_share_pixels and keyframes is not None and not (is_blurred or sampling.transparent or layers - {"provenance"}):
            name = "copy"
        if keyframes is not None and name != "copy":
            warn_of_ignored("keyframes", "reuse='auto' needs no key frames here")
            keyframes = None
    if keyframes is not None and name == "none":
        raise Error("keyframes", "has no effect where every frame is traced", "reuse='copy' or 'interpolate'")
    if min_psnr is not None and name == "none":
        raise Error("min_psnr", "has no effect where every frame is traced", "reuse='interpolate'")
    return _core.Reuse(name, keyframes, min_psnr)


def _layers(layers: Iterable[str]) -> Sequence[str]:
    if isinstance(layers, str):
        layers = [layers]
    if not isinstance(layers, Iterable):
        raise Error("layers", f"is {layers!r}", "names of layers: [\"depth\", \"normal\"]")
    accepted = tuple(name for name in _core.layer_names if name != "alpha") + ("disparity",)
    names = [choice(name, "layers", accepted) for name in layers]
    return list(dict.fromkeys("depth" if name == "disparity" else name for name in names))


def _place(
    core: Any,
    display: Any,
    native: bool,
    fit_depth: Optional[bool],
    focus: str,
    fit_to: str,
    zoom: float,
    orbit: Tuple[float, float],
    at_camera: bool,
) -> Tuple[Any, Optional[Display]]:
    """Returns the placement in the scene, and the Display. The Display is None if `display` is optics. at_camera: a single view gets the
    distance of the scene's camera.
    """
    try:
        yaw, pitch = orbit
    except (TypeError, ValueError):
        raise Error("orbit", f"is {orbit!r}", "two angles in degrees: to the right, up") from None
    wish = _core.ViewWish(
        text(focus, "focus"),
        text(fit_to, "fit_to"),
        number(zoom, "zoom", 1e-3, 1e3),
        (number(yaw, "orbit", -360, 360), number(pitch, "orbit", -90, 90)),
    )
    optics = camera_grid() if display is None else display
    fit = None if fit_depth is None else bool(fit_depth)
    if isinstance(optics, Optics):
        if native:
            raise Error("layout", "'native' needs a display, but optics are given", "layout='views', or a display")
        with Naming(optics="display"):
            return _core.place(core, optics, fit, wish, at_camera), None
    if not isinstance(optics, (Display, str, os.PathLike)):
        raise Error("display", f"is {optics!r}", "a name, a file, a lippmann.Display or optics")
    shown = display_of(optics, "display")
    own = native or shown.kind != "slanted-panel"
    with Naming():
        return _core.place_display(core, shown, own, fit, wish), shown
