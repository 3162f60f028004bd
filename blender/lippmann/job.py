"""Renders in two child processes: a second Blender exports the scene, then `lippmann render` renders it.

The output folder contains scene.glb and world.exr (the exported scene), scene.json (hashes of the Blender scene), still/ or
animation/ (the pictures) and lippmann.log.
"""

import hashlib
import json
import os
import pathlib
import shlex
import struct
import sys
import tempfile

import bpy
import numpy as np

from . import contents, displays, film, frame as frames_of_displays, look, tool

HERE = pathlib.Path(__file__).resolve().parent


NOT_EXPORTED = ("samples", "denoise", "full_depth", "resume", "bake", "bake_size", "keep_scene", "folder", "show_overlay", "extra", "tone", "exposure")  # settings that do not affect the exported scene

_of_session = None  # temporary output folder of unsaved .blend files


class Cancelled(Exception):
    """Raised when the user has pressed Esc. Finished pictures are kept."""


def output_folder(scene):
    """Returns the output folder. Unsaved files share a temporary folder until Blender is closed."""
    global _of_session
    folder = scene.lippmann.folder
    if folder.startswith("//") and not bpy.data.filepath:
        if _of_session is None or not _of_session.is_dir():
            _of_session = pathlib.Path(tempfile.mkdtemp(prefix="lippmann-session-"))
        return _of_session / folder.strip("/")
    return pathlib.Path(bpy.path.abspath(folder))


def resolution(scene):
    share = scene.render.resolution_percentage / 100.0
    return max(1, int(scene.render.resolution_x * share)), max(1, int(scene.render.resolution_y * share))


def check(scene, still):
    try:
        _ = scene.name
    except UnicodeDecodeError:
        raise tool.ToolError("The scene's name is no UTF-8. Rename it.") from None
    if scene.lippmann.output == "camera":
        frames_of_displays.camera_zone(scene, 1.0, 1.0)
    else:
        frames_of_displays.zone(scene, distance=1.0)
    if scene.frame_start < 0 or (still and scene.frame_current < 0):
        raise tool.ToolError("Frames below 0 cannot be rendered. Move the animation to start at frame 0 or later.")
    refusal = displays.refused_size(scene, resolution(scene))
    if refusal:
        raise tool.ToolError(refusal)


def scripts_are_allowed():
    """Returns whether the user allows Python in .blend files (drivers). The exporting Blender gets the same permission."""
    return bpy.context.preferences.filepaths.use_scripts_auto_execute or bool({"-y", "--enable-autoexec"} & set(sys.argv))


def render_flags(scene, still):
    """Returns the flags of `lippmann render` that depend only on the settings, not on the exported scene."""
    settings = scene.lippmann
    width, height = resolution(scene)
    size = ["--size", f"{width}x{height}"]
    if settings.output == "camera":
        return [*flags_of_sampling(scene), "--optics", "single", *size, *more_flags(scene, still)]
    display = displays.chosen(scene)
    optics = {"quilt": ["--layout", "quilt", *(size if display.get("quilt") else [])], "native": ["--layout", "native"], "views": ["--layout", "views"],
              "single": ["--optics", "single", *size]}[settings.output]
    if settings.output == "native" and display["kind"] != "slanted-panel":
        optics = []  # for lens arrays, the tool's default optics already render the native frame
    depth = ["--full-depth"] if settings.full_depth and settings.output != "single" else []
    return ["--display", displays.argument(scene), *optics, *flags_of_sampling(scene), *depth, *more_flags(scene, still)]


def flags_of_sampling(scene):
    return ["--spp", scene.lippmann.samples, *([] if scene.lippmann.denoise else ["--denoise", "none"])]


def more_flags(scene, still):
    settings = scene.lippmann
    try:
        more = shlex.split(settings.extra)
    except ValueError as error:
        raise tool.ToolError(f"More Flags: {error}.") from error
    return (["--transparent"] if film.is_transparent(scene, still) and "--transparent" not in more else []) + look.flags(settings, more) + more


def stamp(path):
    try:
        state = os.stat(path)
    except OSError:
        return None
    return [state.st_size, state.st_mtime_ns]


def pictures_outside_scenes():
    """Returns the paths of images that only image editors use, or nothing. Rendered pictures are among them."""
    outside = {False: set(), True: set()}
    for image, users in bpy.data.user_map(subset=bpy.data.images).items():
        is_outside = all(isinstance(user, (bpy.types.Screen, bpy.types.WindowManager)) for user in users)
        outside[is_outside].add(bpy.path.abspath(image.filepath, library=image.library))
    return outside[True] - outside[False]


def files_beside():
    """Returns {path: stamp()} of each file to which the scenes refer, and of each file in their simulation caches."""
    caches = []
    if bpy.data.filepath:
        blend = pathlib.Path(bpy.data.filepath)
        caches = sorted(blend.parent.glob(f"blendcache_{blend.stem}/*"))
    paths = {*bpy.utils.blend_paths(absolute=True)} - pictures_outside_scenes()
    return {str(path): stamp(path) for path in [*paths, *caches]}


def save_painted(folder):
    """Saves the pixels of images that are painted and not saved, because .blend files do not contain them. Returns {name of the
    image: path of an array (height, width, channels)}."""
    painted = {}
    for image in bpy.data.images:
        if not image.is_dirty or image.source not in ("FILE", "GENERATED") or not image.has_data:
            continue
        values = np.empty(len(image.pixels), np.float32)
        image.pixels.foreach_get(values)
        painted[image.name_full] = str(folder / f"painted_{len(painted)}.npy")
        np.save(painted[image.name_full], values.reshape(image.size[1], image.size[0], image.channels))
    return painted


def digest(values):
    return hashlib.blake2b(json.dumps(values, sort_keys=True, default=str).encode(), digest_size=16).hexdigest()


def hashes(library, ignored=NOT_EXPORTED):
    """Returns the hash of the .blend file `library`, and {name: hash} of its materials. ignored: custom properties that the
    hashes leave out. An unknown format gives a random hash, so that the scene is exported again."""
    try:
        held = contents.Contents(library, ignored)
    except (ValueError, LookupError, StopIteration, struct.error) as error:  # a later Blender may write another format
        print(f"lippmann: the scene is exported anew each time: {error!r}", file=sys.stderr)
        return os.urandom(16).hex(), {}
    return held.all, {name[2:]: held.with_references(name) for name in held.by_name if name.startswith("MA")}


def hash_of(scene):
    """Returns a hash of the scene, its settings, and the files to which it refers. Picture sizes and the view transform do not
    affect it."""
    with tempfile.TemporaryDirectory(prefix="lippmann-") as folder:
        library = os.path.join(folder, "scene.blend")
        bpy.data.libraries.write(library, {scene}, path_remap="ABSOLUTE")
        return digest([hashes(library, ())[0], files_beside(), bpy.app.version_string])


class Export:
    """The exported scene in the output folder. Later renders use it again until the Blender scene changes."""

    def __init__(self, folder):
        self.glb, self.world, self._record = folder / "scene.glb", folder / "world.exr", folder / "scene.json"

    def _stamps(self):
        return {path.name: stamp(path) for path in (self.glb, self.world)}

    def kept(self, key):
        """Returns the report of the earlier export, or None if `key` or the exported files have changed. key: hash of the
        scene and its settings."""
        try:
            record = json.loads(self._record.read_text())
        except (OSError, ValueError):
            return None
        return record["told"] if record["key"] == key and record["files"] == self._stamps() and self.glb.is_file() else None

    def forget(self):
        self._record.unlink(missing_ok=True)

    def keep(self, key, told):
        self._record.write_text(json.dumps({"key": key, "told": told, "files": self._stamps()}))


class Job:
    """A render of a still or an animation. Each frame of an animation is available as soon as it is finished."""

    def __init__(self, scene, still):
        check(scene, still)
        self.tool = displays.preferred_tool()
        self.still = still
        self.first, self.last = (scene.frame_current,) * 2 if still else (scene.frame_start, scene.frame_end)
        self.folder = output_folder(scene)
        self.pictures_folder = self.folder / ("still" if still else "animation")
        self.warnings = []
        self._child = None
        self._started = False
        self._prepare(scene)

    def _prepare(self, scene):
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise tool.ToolError(f"The output folder {self.folder} cannot be made: {error.strerror}.") from error
        self._log = self.folder / "lippmann.log"
        self._log.write_bytes(b"")
        self._work = tempfile.TemporaryDirectory(prefix="lippmann-")
        work = pathlib.Path(self._work.name)
        self._request = work / "request.json"
        self._told = work / "report.json"
        library = work / "scene.blend"
        bpy.data.libraries.write(str(library), {scene}, path_remap="ABSOLUTE")
        painted = save_painted(work)
        settings = scene.lippmann
        width, height = resolution(scene)
        self._export = Export(self.folder)
        request = {"scene": scene.name, "display": settings.display, "calibration": bpy.path.abspath(settings.calibration) if settings.calibration else "",
                   "aspect": width / height if settings.output == "camera" else 0.0, "frames": [self.first, self.last], "still": self.still,
                   "bake_size": settings.bake_size if settings.bake else 0}
        whole, of_materials = hashes(library)
        around = [files_beside(), scripts_are_allowed(), bpy.app.version_string, {path.name: stamp(path) for path in sorted(HERE.glob("*.py"))},
                  {name: hashlib.blake2b(pathlib.Path(file).read_bytes()).hexdigest() for name, file in painted.items()}]
        self._key = digest([request, whole, displays.chosen(scene), settings.samples > 1, around])
        materials = {name: digest([hashed, around]) for name, hashed in of_materials.items()}
        self._request.write_text(json.dumps({**request, "library": str(library), "glb": str(self._export.glb), "world": str(self._export.world), "report": str(self._told),
                                             "materials": materials, "baked": str(self.folder / "baked"), "painted": painted}))
        self._flags = render_flags(scene, self.still)
        self._fps = scene.render.fps / scene.render.fps_base
        self._resume = settings.resume and not self.still
        self._video = settings.video and not self.still

    def _export_words(self):
        scripts = "--enable-autoexec" if scripts_are_allowed() else "--disable-autoexec"
        return [bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", scripts, "--python-exit-code", "1", "-P", HERE / "scene_export.py", "--",
                self._request]

    def _render_words(self):
        told = self._exported
        self.warnings = list(told["warnings"])
        frames = ["--frames", "0" if self.still else f"{self.first}-{self.last}"]
        blur = [word for name, value in zip(told["blur"][::2], told["blur"][1::2]) if name not in self._flags for word in (name, value)]
        words = [self.tool, "render", self._export.glb, *blur, *self._flags, "--camera", told["eye"], "--focus", f"{told['distance']:.9g}", "--environment",
                 told["environment"], *frames, "--fps", f"{self._fps:.9g}", "--progress", "json", "-o", self.pictures_folder]
        words += ["--viewing-distance", f"{told['parallel_mm']:.9g}"] if told["parallel_mm"] else []
        words += ["--video", self.pictures_folder / "video.mp4"] if self._video else []
        resumes = self._resume and (self.pictures_folder / "job.toml").is_file()
        return [str(word) for word in words + (["--resume"] if resumes else ["--force"])]

    def _run(self, step, until, tell, stopped):
        """Waits until the child process has ended, or until() returns True. Raises Cancelled if stopped() returns True."""
        while self._child.running() and not until():
            if stopped():
                self.stop()
                raise Cancelled
            tell(self._child.step or step, self._child.share, self._child.seconds_left)
            self._child.wait(0.1)
        if not self._child.running():
            self._child.check()

    def _export_now(self, tell, stopped):
        self._export.forget()
        environment = {**os.environ, "LIPPMANN_TOOL": self.tool}
        self._child = tool.Child(self._export_words(), self._log, environment)
        self._run("exporting the scene", lambda: False, tell, stopped)
        told = json.loads(self._told.read_text())
        self._export.keep(self._key, told)
        return told

    def frame(self, number, tell=lambda *_: None, stopped=lambda: False):
        """Waits for a frame and returns the paths of its pictures. Raises ToolError or Cancelled.

        tell(step, share, seconds): receives a text, the share of the step that is done, and the remaining seconds or None.
        stopped(): returns whether the user has pressed Esc.
        """
        if not self._started:
            self._exported = self._export.kept(self._key) or self._export_now(tell, stopped)
            self._child = tool.Child(self._render_words(), self._log)
            self._started = True
        index = 0 if self.still else number
        last = number == self.last  # for the last frame, wait until the tool has also written the video and the report
        self._run(f"rendering frame {number}", lambda: not last and index in self._child.finished_frames, tell, stopped)
        found = tool.pictures(self.pictures_folder, index)
        if not found:
            raise tool.ToolError(f"The tool has written no picture of frame {number}; see {self._log}.")
        self._warn_of_cut()
        return found

    def _warn_of_cut(self):
        cut = json.loads((self.pictures_folder / "report.json").read_text()).get("cut")
        if cut and cut not in self.warnings:
            self.warnings.append(cut)

    def stop(self):
        if self._child:
            self._child.stop()
        self._work.cleanup()
