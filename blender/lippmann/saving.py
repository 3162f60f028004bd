"""Overwrites the picture files that Blender saves with the tool's own pictures.

Blender would apply its view transform a second time, and would omit the number of tiles, which players of quilts read from the
file name.
"""

import pathlib
import re
import shutil

import bpy

from . import versions

QUILT = re.compile(r"_qs\d+x\d+a[0-9.]+(?=\.[a-z]+$)")  # end of a quilt's file name (docs/reference/formats.md)

_shown = None  # (path, is_animation): the picture that Blender showed last, and whether it is a frame of an animation


def remember(picture, is_animation):
    global _shown
    _shown = pathlib.Path(picture), is_animation


def quilt_suffix(picture):
    """Returns the end of a quilt's file name that states its tiles, such as _qs8x6a0.75, or an empty string."""
    found = QUILT.search(pathlib.Path(picture).name)
    return found.group() if found else ""


def shown_picture():
    """Returns the path of the picture that Blender showed last, or None if it does not exist."""
    return _shown[0] if _shown and _shown[0].is_file() else None


def save_as(path):
    """Copies the shown picture. Adds the quilt's tiles to the name, and returns the path."""
    picture, path = shown_picture(), pathlib.Path(path)
    suffix = quilt_suffix(picture)
    if suffix and not path.stem.endswith(suffix):
        path = path.with_name(path.stem + suffix + path.suffix)
    shutil.copyfile(picture, path)
    return path


def written_path(scene, is_animation):
    render = scene.render
    if is_animation:
        return pathlib.Path(render.frame_path(frame=scene.frame_current))
    path = bpy.path.abspath(render.filepath)
    ending = render.file_extension
    return pathlib.Path(path if not render.use_file_extension or path.lower().endswith(ending) else path + ending)


def is_ours(scene):
    """Returns whether to overwrite the file that Blender saves. It must be a PNG of this engine without compositing or strips."""
    render = scene.render
    if render.engine != "LIPPMANN" or render.image_settings.file_format != "PNG" or not _shown or _shown[0].suffix != ".png":
        return False
    return not (render.use_compositing and versions.composites(scene)) and not (render.use_sequencer and versions.has_strips(scene))


@bpy.app.handlers.persistent
def replace(scene, *_):
    if not is_ours(scene):
        return
    picture, is_animation = _shown
    written = written_path(scene, is_animation)
    if not written.is_file() or not picture.is_file():
        return
    shutil.copyfile(picture, written)
    keeps_name = is_animation and (not scene.render.use_overwrite or scene.render.use_placeholder)  # Blender detects finished frames by their names
    suffix = quilt_suffix(picture)
    if suffix and not keeps_name and not written.stem.endswith(suffix):
        written.replace(written.with_name(written.stem + suffix + written.suffix))


def register():
    bpy.app.handlers.render_write.append(replace)


def unregister():
    bpy.app.handlers.render_write.remove(replace)
