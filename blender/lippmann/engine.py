"""The render engine. F12 renders one frame. Ctrl-F12 renders an animation by one run of the tool, and shows each frame when it
is finished."""

import sys

import bpy
import imbuf

from . import job as jobs
from . import look, progress, saving, tool

_animation = None        # the job of the current animation, kept because Blender requests one frame per call
_animated = set()        # names of the scenes whose last render was an animation
_terminal = progress.Terminal()
last_warnings = []       # of the last render, shown in the panel
last_folder = ""


@bpy.app.handlers.persistent  # keeps the handler when another file is opened
def end_animation(*_):
    global _animation
    if _animation:
        _animation.stop()
        _animation = None


@bpy.app.handlers.persistent
def keep_scene(scene, *_):
    """Sets Blender's own option, without which Blender evaluates all modifiers again at each still and each frame."""
    render = scene.render
    if render.engine != Engine.bl_idname:
        return
    if scene.name in _animated:
        _animated.remove(scene.name)
        render.use_persistent_data = False  # frees the engine object, whose is_animation would stay true in the next still
    render.use_persistent_data = scene.lippmann.keep_scene


def size_of(picture):
    """Returns (width, height) of a picture file. Does not use bpy.data: Blender 5 crashes at the next frame if a render
    changes it."""
    image = imbuf.load(str(picture))
    size = tuple(image.size)
    image.free()
    return size


class Engine(bpy.types.RenderEngine):
    bl_idname = "LIPPMANN"
    bl_label = "Lippmann"
    bl_use_preview = False
    bl_use_gpu_context = False

    def render(self, depsgraph):
        scene = depsgraph.scene.original
        try:
            pictures = self._pictures(scene)
            self._show(scene, pictures)
        except jobs.Cancelled:
            end_animation()
        except tool.ToolError as error:
            end_animation()
            self._fail(str(error))

    def _fail(self, message):
        if bpy.app.background:
            print(f"lippmann: error: {message}", file=sys.stderr, flush=True)
        self.report({"ERROR"}, message)
        self.error_set(message)

    def _tell(self, step, share, seconds_left):
        self.update_stats("Lippmann", progress.sentence(step, share, seconds_left))
        self.update_progress(share)
        if bpy.app.background:
            _terminal.say(step, share, seconds_left)

    def _pictures(self, scene):
        global _animation, last_warnings, last_folder
        still = not self.is_animation
        if still:
            job = jobs.Job(scene, True)
        else:
            _animated.add(scene.name)
            if _animation is None:
                _animation = jobs.Job(scene, False)
            job = _animation
        try:
            found = job.frame(scene.frame_current, self._tell, self.test_break)
        finally:
            if still:
                job.stop()
            last_folder = str(job.pictures_folder)
        seen = look.lost(scene.view_settings)
        warnings = [*job.warnings, *([seen] if seen else [])]
        if last_warnings != warnings:
            last_warnings = warnings
            for warning in last_warnings:
                self.report({"WARNING"}, warning)
        if not still and scene.frame_current == job.last:
            end_animation()
        return found

    def _show(self, scene, pictures):
        """Shows a picture as Blender's render result. Of several views, shows the middle one."""
        picture = pictures[len(pictures) // 2]
        saving.remember(picture, self.is_animation)
        width, height = jobs.resolution(scene)
        size = size_of(picture)
        if size != (width, height):
            self.report({"WARNING"}, f"The picture has {size[0]} x {size[1]} pixels, not Blender's resolution; see {picture}.")
            return
        result = self.begin_result(0, 0, width, height)
        result.layers[0].load_from_file(str(picture))
        self.end_result(result)


def panels():
    left_out = {"VIEWLAYER_PT_filter", "VIEWLAYER_PT_layer_passes", "RENDER_PT_simplify", "RENDER_PT_freestyle"}
    for panel in bpy.types.Panel.__subclasses__():
        if "BLENDER_RENDER" in getattr(panel, "COMPAT_ENGINES", ()) and panel.__name__ not in left_out:
            yield panel
    for name in ("EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface", "EEVEE_WORLD_PT_surface", "DATA_PT_EEVEE_light"):
        panel = getattr(bpy.types, name, None)
        if panel:
            yield panel


def register():
    bpy.utils.register_class(Engine)
    for panel in panels():
        panel.COMPAT_ENGINES.add("LIPPMANN")
    bpy.app.handlers.render_init.append(keep_scene)
    bpy.app.handlers.render_cancel.append(end_animation)
    bpy.app.handlers.render_complete.append(end_animation)


def unregister():
    end_animation()
    bpy.app.handlers.render_complete.remove(end_animation)
    bpy.app.handlers.render_cancel.remove(end_animation)
    bpy.app.handlers.render_init.remove(keep_scene)
    for panel in panels():
        panel.COMPAT_ENGINES.discard("LIPPMANN")
    bpy.utils.unregister_class(Engine)
