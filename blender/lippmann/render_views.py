"""The operator that renders light fields with Blender's other engines (views.py).

From a window, the operator runs step by step, so that Blender stays responsive and Esc stops it. From a script, it returns when
everything is rendered.
"""

import bpy

from . import displays, engine, progress, saving, tool, views

TICK = 0.1  # seconds between two steps
CANCELLED = "Stopped. Finished views stay in {}; Render Views continues with them while the scene stays the same."

_running = None  # the current Run of a window


def run_in_window():
    return _running


def is_running():
    return _running is not None


def status():
    return _running.status if _running else ""


def image_editors():
    return [area.spaces.active for window in bpy.context.window_manager.windows for area in window.screen.areas if area.type == "IMAGE_EDITOR"]


def show_pictures(pictures):
    """Shows the first picture in all image editors. Without one, opens one where Blender shows its renders."""
    engine.last_folder = str(pictures[0].parent)
    saving.remember(pictures[0], False)
    image = bpy.data.images.load(str(pictures[0]), check_existing=True)
    image.reload()
    if not bpy.app.background and not image_editors():
        bpy.ops.render.view_show("INVOKE_DEFAULT")
    for editor in image_editors():
        editor.image = image


def render_picture(scene, how="EXEC_DEFAULT"):
    try:
        bpy.ops.render.render(how, write_still=True, scene=scene.name)
    except RuntimeError as error:
        raise tool.ToolError(str(error).removeprefix("Error: ").strip()) from error


class Run:
    def __init__(self, made, numbers):
        self.made, self.status = made, ""
        self._steps = made.steps(numbers)
        self._waits = self._is_cancelled = False
        bpy.app.handlers.render_complete.append(self._complete)
        bpy.app.handlers.render_cancel.append(self.cancel)

    def _complete(self, *_):
        self._waits = False

    def cancel(self, *_):
        self._is_cancelled = True

    def advance(self):
        """Takes the next step, unless Blender still renders a picture. Returns whether there are more steps. Raises ToolError."""
        if bpy.app.is_job_running("RENDER") or (self._waits and not self._is_cancelled):
            return True
        step = None if self._is_cancelled else next(self._steps, None)
        if step is None:
            return False
        self.status = f"Lippmann: {progress.sentence(step.words, step.share, step.seconds_left)} (Esc stops)"
        if step.renders:
            self._waits = True
            with views.lent((bpy.context.preferences.view, {"render_display_type": "NONE"})):  # otherwise Blender opens a window for each view
                render_picture(self.made.scene, "INVOKE_DEFAULT")
        return True

    def end(self):
        bpy.app.handlers.render_complete.remove(self._complete)
        bpy.app.handlers.render_cancel.remove(self.cancel)
        self._steps.close()

    @property
    def is_cancelled(self):
        return self._is_cancelled


def frames_of(scene, animation):
    return range(scene.frame_start, scene.frame_end + 1) if animation else [scene.frame_current]


def refusal(scene):
    try:
        return views.refused(scene, displays.chosen(scene))
    except tool.ToolError as error:
        return str(error)


class RenderViews(bpy.types.Operator):
    bl_idname = "lippmann.render_views"
    bl_label = "Render Views"
    bl_description = "Render a picture for each of the display's views with another engine of Blender's, and lay them out as a quilt; as native frames, too, if that is the output"
    bl_options = {"REGISTER"}

    engine: bpy.props.EnumProperty(items=views.engines, name="Engine", description="What renders the views")
    animation: bpy.props.BoolProperty(name="Animation", description="All frames of the scene, not only the current one")

    @classmethod
    def poll(cls, context):
        reason = "Views are being rendered. Esc stops." if is_running() else refusal(context.scene)
        if reason:
            cls.poll_message_set(reason.rstrip("."))  # Blender adds the full stop
        return not reason

    def invoke(self, context, _event):
        self.is_interactive = True
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        if getattr(self, "is_interactive", False):
            bpy.ops.lippmann.run_views("INVOKE_DEFAULT", engine=self.engine, animation=self.animation)
            return {"FINISHED"}
        try:
            self._render(context.scene)
        except tool.ToolError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _render(self, scene):
        made, terminal = views.Views(scene, self.engine), progress.Terminal()
        for step in made.steps(frames_of(scene, self.animation)):
            terminal.say(step.words, step.share, step.seconds_left)
            if step.renders:
                render_picture(scene)
        show_pictures(made.pictures)
        self.report({"INFO"}, made.result())


class RunViews(bpy.types.Operator):
    """Renders views while Blender's window stays responsive"""

    bl_idname = "lippmann.run_views"
    bl_label = "Render Views"
    bl_options = {"INTERNAL"}

    engine: bpy.props.StringProperty()
    animation: bpy.props.BoolProperty()

    def invoke(self, context, _event):
        global _running
        try:
            made = views.Views(context.scene, self.engine)
        except tool.ToolError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        _running = Run(made, frames_of(context.scene, self.animation))
        self._timer = context.window_manager.event_timer_add(TICK, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            _running.cancel()
            return {"PASS_THROUGH"}  # Esc must also stop Blender's render of the current view
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type.startswith("TIMER") or event.type == "MOUSEMOVE" else {"RUNNING_MODAL"}
        try:
            has_more = _running.advance()
        except tool.ToolError as error:
            self._end(context)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if has_more:
            context.workspace.status_text_set(_running.status)
            self._redraw_panel(context)
            return {"PASS_THROUGH"}
        return self._finish(context)

    def _finish(self, context):
        run = _running
        self._end(context)
        if run.is_cancelled:
            self.report({"WARNING"}, CANCELLED.format(run.made.folder))
            return {"CANCELLED"}
        show_pictures(run.made.pictures)
        self.report({"INFO"}, run.made.result())
        return {"FINISHED"}

    def cancel(self, context):
        """Blender calls this when it opens another file or ends."""
        self._end(context)

    def _end(self, context):
        global _running
        _running.end()
        _running = None
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        self._redraw_panel(context)

    @staticmethod
    def _redraw_panel(context):
        for window in context.window_manager.windows:
            for area in window.screen.areas:
                if area.type == "PROPERTIES":
                    area.tag_redraw()


CLASSES = (RenderViews, RunViews)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
