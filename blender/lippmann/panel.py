import subprocess
import textwrap

import bpy
from bpy_extras.io_utils import ExportHelper

from . import displays, engine, frame, job, look, render_views, saving, tool


class Operator(bpy.types.Operator):
    """An operator that shows ToolErrors to the user."""

    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            self.act(context)
        except tool.ToolError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def selected(context):
    return [thing for thing in context.selected_objects if not thing.lippmann.is_frame]


def is_possible(operator, condition, reason):
    """Returns the condition. If it is false, Blender disables the button and shows the reason as its tooltip."""
    if not condition:
        operator.poll_message_set(reason)
    return bool(condition)


class PlaceAtSelected(Operator):
    bl_idname = "lippmann.place_at_selected"
    bl_label = "At Selected Objects"
    bl_description = "Put the light-field frame through the middle of the selected objects, facing the camera"

    @classmethod
    def poll(cls, context):
        return is_possible(cls, selected(context), "Select an object other than the frame")

    def act(self, context):
        frame.place_at_objects(context.scene.lippmann.frame or frame.add(context), selected(context), context.scene.camera)


class PlaceAtFocus(Operator):
    bl_idname = "lippmann.place_at_focus"
    bl_label = "At Camera's Focus"
    bl_description = "Put the light-field frame where the camera is focused, as large as what it frames there"

    @classmethod
    def poll(cls, context):
        return is_possible(cls, context.scene.camera, "The scene has no camera")

    def act(self, context):
        camera = context.scene.camera
        matrix, height = frame.framed(camera, displays.aspect(displays.chosen(context.scene)), frame.focus_distance(camera))
        frame.place(context.scene.lippmann.frame or frame.add(context), matrix, height)


class MatchResolution(Operator):
    bl_idname = "lippmann.match_resolution"
    bl_label = "Match Resolution"
    bl_description = "Set Blender's resolution to that of the display's pictures"

    def act(self, context):
        displays.chosen(context.scene)
        displays.fit_resolution(context.scene)


class TakeOverViewTransform(Operator):
    bl_idname = "lippmann.take_over_view_transform"
    bl_label = "Take Over View Transform"
    bl_description = "Make Blender's view transform and exposure the settings Tone and Exposure here, so that files and Blender's window show the same"

    def act(self, context):
        look.take_over(context.scene.lippmann, context.scene.view_settings)


class SaveAs(Operator, ExportHelper):
    bl_idname = "lippmann.save_as"
    bl_label = "Save Light Field As"
    bl_description = "Save the last picture as the tool has rendered it, without Blender's view transform, and with the quilt's tiles in its name"
    bl_options = {"REGISTER"}

    filename_ext = ".png"
    filter_glob: bpy.props.StringProperty(default="*.png", options={"HIDDEN"})

    @classmethod
    def poll(cls, _context):
        return is_possible(cls, saving.shown_picture(), "Nothing has been rendered yet")

    def invoke(self, context, event):
        self.filepath = saving.shown_picture().name
        return super().invoke(context, event)

    def act(self, _context):
        try:
            self.report({"INFO"}, f"Saved {saving.save_as(self.filepath)}.")
        except OSError as error:
            raise tool.ToolError(f"{self.filepath} cannot be written: {error.strerror}.") from error


def draw_menu(menu, context):
    if context.engine == "LIPPMANN":
        menu.layout.operator("lippmann.save_as", text="Save Light Field As...")


class ViewInPage(Operator):
    bl_idname = "lippmann.view"
    bl_label = "View in Browser"
    bl_description = "Show the last rendered light field in the browser, where the mouse moves the eye"
    bl_options = {"REGISTER"}

    @classmethod
    def poll(cls, _context):
        return is_possible(cls, engine.last_folder, "Nothing has been rendered yet")

    def act(self, _context):
        stop_viewing()
        ViewInPage.child = subprocess.Popen([displays.preferred_tool(), "view", engine.last_folder, "--open"], stdin=subprocess.DEVNULL)


def stop_viewing():
    child = getattr(ViewInPage, "child", None)
    if child:
        child.terminate()
        child.wait()
        ViewInPage.child = None


def panel_width(context):
    return context.region.width / context.preferences.system.ui_scale


def show_sentence(layout, text, width, icon="ERROR"):
    """Shows a text in several lines, because Blender does not wrap labels. width: of the panel, in pixels. A letter is about 7
    pixels wide."""
    column = layout.column(align=True)
    for index, line in enumerate(textwrap.wrap(text, max(20, int((width - 60) / 7)))):
        column.label(text=line, icon="BLANK1" if index and icon != "NONE" else icon)


class LIPPMANN_PT_light_field(bpy.types.Panel):
    bl_label = "Light Field"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"

    @classmethod
    def poll(cls, context):
        return context.engine == "LIPPMANN" or render_views.is_running()  # Render Views sets another engine while it runs

    def draw(self, context):
        scene, layout = context.scene, self.layout
        settings = scene.lippmann
        layout.use_property_split = True
        layout.use_property_decorate = False
        try:
            displays.known()
        except tool.ToolError as error:
            show_sentence(layout, str(error), panel_width(context))
            layout.operator("preferences.addon_show", text="Open the Add-on's Preferences").module = __package__
            return
        column = layout.column()
        row = column.row()
        row.active = not settings.calibration
        row.prop(settings, "display")
        column.prop(settings, "calibration")
        column.prop(settings, "output")
        column.operator("lippmann.match_resolution")
        self._refusal(context, layout)
        self._frame(context, layout)
        self._settings(context, layout.column())
        self._results(context, layout)

    def _settings(self, context, column):
        settings = context.scene.lippmann
        for name in ("samples", "denoise", "tone", "exposure", "full_depth", "bake", "bake_size", "folder", "resume", "keep_scene", "video", "extra"):
            row = column.row()
            row.active = name != "bake_size" or settings.bake
            row.prop(settings, name)
            if name == "folder" and settings.folder.startswith("//") and not bpy.data.filepath:
                show_sentence(column, "This file is not saved yet: pictures go to a temporary folder.", panel_width(context), "INFO")

    def _results(self, context, layout):
        view = context.scene.view_settings
        layout.operator("lippmann.view", icon="URL")
        layout.operator("lippmann.save_as", text="Save Light Field As...", icon="FILE_TICK")
        layout.operator("lippmann.render_views", text="Render Views with Cycles or Eevee", icon="RENDER_STILL")
        if render_views.is_running():
            show_sentence(layout, render_views.status(), panel_width(context), "INFO")
        seen = look.lost(view)
        for warning in engine.last_warnings:
            if warning != seen:
                show_sentence(layout, warning, panel_width(context))
        if seen:
            show_sentence(layout, seen, panel_width(context), "INFO")
            layout.operator("lippmann.take_over_view_transform")

    def _refusal(self, context, layout):
        try:
            refusal = displays.refused_size(context.scene, job.resolution(context.scene))
        except tool.ToolError:
            return  # _frame() shows the error
        if refusal:
            show_sentence(layout, refusal, panel_width(context))

    def _frame(self, context, layout):
        scene = context.scene
        settings = scene.lippmann
        column = layout.column()
        column.prop(settings, "frame")
        if settings.frame:
            column.prop(settings.frame.lippmann, "height")
        buttons = layout.column(align=True)
        buttons.operator("lippmann.place_at_selected")
        buttons.operator("lippmann.place_at_focus")
        layout.prop(settings, "show_overlay")
        try:
            zone, display = frame.zone(scene), displays.chosen(scene)
        except tool.ToolError as error:
            show_sentence(layout, str(error), panel_width(context))
            return
        box = layout.box()
        for line in figures(scene, display, zone):
            show_sentence(box, line, panel_width(context), "NONE")


def length(scene, value):
    units = scene.unit_settings
    return bpy.utils.units.to_string(units.system, "LENGTH", value * units.scale_length, precision=3).strip()


def figures(scene, display, zone):
    return [f"{display['views']} views within {display['view_cone_deg']:.0f}\u00b0",
            f"Viewer at {display['viewing_distance_mm']:.0f} mm; in the scene at {length(scene, zone.distance)}",
            f"Sharp \u00b1 {display['depth_budget_mm']:.1f} mm; in the scene \u00b1 {length(scene, zone.budget)}"]


CLASSES = (PlaceAtSelected, PlaceAtFocus, MatchResolution, TakeOverViewTransform, SaveAs, ViewInPage, LIPPMANN_PT_light_field)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.IMAGE_MT_image.append(draw_menu)


def unregister():
    bpy.types.IMAGE_MT_image.remove(draw_menu)
    stop_viewing()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
