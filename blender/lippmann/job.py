"""One render through the tool: the scene exported by a Blender of its own, then `lippmann render` on it, both child processes.

Below the output folder: scene.glb and world.exr (what is rendered), still/ or animation/ (the tool's folders, docs/reference/formats.md), lippmann.log.
"""

import json
import os
import pathlib
import shlex
import sys
import tempfile

import bpy

from . import displays, film, frame as frames_of_displays, tool

HERE = pathlib.Path(__file__).resolve().parent


class Cancelled(Exception):
    """The user pressed Esc. What was finished stays."""


def output_folder(scene):
    folder = scene.lippmann.folder
    if folder.startswith("//") and not bpy.data.filepath:
        return pathlib.Path(tempfile.gettempdir()) / "lippmann" / folder.strip("/")
    return pathlib.Path(bpy.path.abspath(folder))


def resolution(scene):
    share = scene.render.resolution_percentage / 100.0
    return max(1, int(scene.render.resolution_x * share)), max(1, int(scene.render.resolution_y * share))


def check(scene, still):
    """All that can be said before anything is started. Raises ToolError."""
    try:
        _ = scene.name
    except UnicodeDecodeError:
        raise tool.ToolError("The scene's name is no UTF-8. Rename it.") from None
    frames_of_displays.zone(scene, distance=1.0)
    if scene.frame_start < 0 or (still and scene.frame_current < 0):
        raise tool.ToolError("Frames below 0 cannot be rendered. Move the animation to start at frame 0 or later.")
    if scene.lippmann.output == "native":
        panel = tuple(displays.chosen(scene)["pixels"])
        if resolution(scene) != panel:
            raise tool.ToolError(f"A native frame has the panel's {panel[0]} x {panel[1]} pixels. Press Match Resolution, and set 100 %.")


def scripts_are_allowed():
    """Whether the user lets files run Python, which drivers may have: the exporting Blender must show what this one shows, and trust no more."""
    return bpy.context.preferences.filepaths.use_scripts_auto_execute or bool({"-y", "--enable-autoexec"} & set(sys.argv))


def render_flags(scene, still):
    """Flags of lippmann render that follow from the settings alone."""
    settings = scene.lippmann
    width, height = resolution(scene)
    size = ["--size", f"{width}x{height}"]
    display = displays.chosen(scene)
    optics = {"quilt": ["--layout", "quilt", *(size if display.get("quilt") else [])], "native": ["--layout", "native"], "views": ["--layout", "views"],
              "single": ["--optics", "single", *size]}[settings.output]
    if settings.output == "native" and display["kind"] != "slanted-panel":
        optics = []  # a lens array's own frame is its integral image
    flags = ["--display", displays.argument(scene), *optics, "--spp", settings.samples]
    flags += [] if settings.denoise else ["--denoise", "none"]
    flags += ["--full-depth"] if settings.full_depth else []
    try:
        more = shlex.split(settings.extra)
    except ValueError as error:
        raise tool.ToolError(f"More flags: {error}.") from error
    flags += ["--transparent"] if film.is_transparent(scene, still) and "--transparent" not in more else []
    return flags + more


class Job:
    """A still, or an animation whose frames are handed out as they are finished."""

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
        """Writes what the exporting Blender reads, while the scene is at hand."""
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
        settings = scene.lippmann
        self._glb = self.folder / "scene.glb"
        self._request.write_text(json.dumps({
            "library": str(library), "scene": scene.name, "display": settings.display, "calibration": bpy.path.abspath(settings.calibration) if settings.calibration else "",
            "frames": [self.first, self.last], "still": self.still, "bake_size": settings.bake_size if settings.bake else 0, "glb": str(self._glb), "world": str(self.folder / "world.exr"), "report": str(self._told)}))
        self._flags = render_flags(scene, self.still)
        self._fps = scene.render.fps / scene.render.fps_base
        self._resume = settings.resume and not self.still
        self._video = settings.video and not self.still

    def _export_words(self):
        scripts = "--enable-autoexec" if scripts_are_allowed() else "--disable-autoexec"
        return [bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", scripts, "--python-exit-code", "1", "-P", HERE / "scene_export.py", "--",
                self._request]

    def _render_words(self):
        told = json.loads(self._told.read_text())
        self.warnings = told["warnings"]
        frames = ["--frames", "0" if self.still else f"{self.first}-{self.last}"]
        blur = [word for name, value in zip(told["blur"][::2], told["blur"][1::2]) if name not in self._flags for word in (name, value)]
        words = [self.tool, "render", self._glb, *blur, *self._flags, "--camera", told["eye"], "--focus", f"{told['distance']:.9g}", "--environment",
                 told["environment"], *frames, "--fps", f"{self._fps:.9g}", "--progress", "json", "-o", self.pictures_folder]
        words += ["--video", self.pictures_folder / "video.mp4"] if self._video else []
        resumes = self._resume and (self.pictures_folder / "job.toml").is_file()
        return [str(word) for word in words + (["--resume"] if resumes else ["--force"])]

    def _run(self, words, until, tell, stopped):
        """Waits until the child is done, or `until` holds."""
        while self._child.running() and not until():
            if stopped():
                self.stop()
                raise Cancelled
            tell(self._child.share)
            self._child.wait(0.1)
        if not self._child.running():
            self._child.check()

    def frame(self, number, tell=lambda _: None, stopped=lambda: False):
        """The pictures of a finished frame, for which it waits. Raises ToolError, Cancelled."""
        if not self._started:
            environment = {**os.environ, "LIPPMANN_TOOL": self.tool}
            self._child = tool.Child(self._export_words(), self._log, environment)
            self._run(None, lambda: False, tell, stopped)
            self._child = tool.Child(self._render_words(), self._log)
            self._started = True
        index = 0 if self.still else number
        last = number == self.last  # the last frame is done when the video and the report are, too
        self._run(None, lambda: not last and index in self._child.finished_frames, tell, stopped)
        found = tool.pictures(self.pictures_folder, index)
        if not found:
            raise tool.ToolError(f"The tool has written no picture of frame {number}; see {self._log}.")
        return found

    def stop(self):
        if self._child:
            self._child.stop()
        self._work.cleanup()
