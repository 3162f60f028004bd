"""The displays that `lippmann displays` lists, and properties of the chosen display."""

import os
import zlib

import bpy

from . import tool

DEFAULT = "looking-glass-portrait"
_known = None      # presets from `lippmann displays --json`; None: not read yet
_files = {}        # (path of a calibration, modification time) -> display
_choices = []      # kept, because Blender does not keep the strings of dynamic lists alive


def preferred_tool():
    addon = bpy.context.preferences.addons.get(__package__)
    return tool.find(addon.preferences.tool if addon else "")


def forget():
    global _known
    _known = None
    _choices.clear()


def known():
    global _known
    if _known is None:
        _known = tool.ask(preferred_tool(), "displays")
    return _known


def number(name):
    """Returns the number that .blend files store for a display. It depends only on the name, so new presets do not change it. The
    default display is 0, Blender's initial value."""
    return 0 if name == DEFAULT else zlib.crc32(name.encode()) & 0x7FFFFFFF


def choices(_self, _context):
    if not _choices:
        try:
            names = [(display["name"], display["description"]) for display in known()]
        except tool.ToolError:
            return [("none", "Tool not found", "Set the path of lippmann in the add-on's preferences")]
        names.sort(key=lambda name: name[0] != DEFAULT)
        _choices.extend((name, description, name, number(name)) for name, description in names)
    return _choices


def argument(scene):
    settings = scene.lippmann
    return bpy.path.abspath(settings.calibration) if settings.calibration else settings.display


def chosen(scene):
    """Returns the JSON of the chosen display, as `lippmann displays` prints it. Raises ToolError."""
    path = argument(scene)
    if not scene.lippmann.calibration:
        known()
        for display in known():
            if display["name"] == path:
                return display
        raise tool.ToolError(f"The tool knows no display {path}.")
    if not os.path.isfile(path):
        raise tool.ToolError(f"There is no calibration file {path}.")
    key = (path, os.stat(path).st_mtime_ns)
    if key not in _files:
        _files[key] = tool.ask(preferred_tool(), "displays", path)
    return _files[key]


def aspect(display):
    width, height = display["size_mm"]
    return display.get("quilt", {}).get("aspect") or width / height


def picture_size(display, output):
    """Returns the (width, height) in pixels of a frame's picture, or of one view if the output is a folder of views."""
    quilt = display.get("quilt")
    if output == "quilt" and quilt:
        return tuple(quilt["size"])
    if output in ("views", "single", "camera"):
        height = 1024
        return round(height * aspect(display)), height
    return tuple(display["pixels"])


def refused_size(scene, size):
    """Returns a message if pictures cannot have this size, else None. Does not check quilts if extra flags set the size or the
    views."""
    output, display = scene.lippmann.output, chosen(scene)
    if output == "native" and size != tuple(display["pixels"]):
        return f"A native frame has the panel's {display['pixels'][0]} x {display['pixels'][1]} pixels. Press Match Resolution, and set 100 %."
    if output != "quilt" or "quilt" not in display or {"--views", "--size"} & set(scene.lippmann.extra.split()):
        return None
    tiles, usual = display["quilt"]["tiles"], display["quilt"]["size"]
    # Some Looking Glasses expect quilts with padding, such as 4096 x 4096 pixels for 5 x 9 tiles.
    fitting = [pixels if pixels >= count and full % count else count * max(1, round(pixels / count)) for pixels, count, full in zip(size, tiles, usual)]
    if fitting == list(size):
        return None
    return (f"A quilt of {tiles[0]} x {tiles[1]} views cannot have {size[0]} x {size[1]} pixels, because views have whole pixels. "
            f"Press Match Resolution, or set {fitting[0]} x {fitting[1]}, at 100 %.")


def fit_resolution(scene):
    try:
        size = picture_size(chosen(scene), scene.lippmann.output)
    except tool.ToolError:
        return
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.pixel_aspect_x = scene.render.pixel_aspect_y = 1.0
