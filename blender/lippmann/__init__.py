"""Add-on for Blender: a render engine for light-field displays, which runs the tool lippmann as a child process
(docs/guide/blender.md)."""

bl_info = {
    "name": "Lippmann",
    "author": "The authors of Lippmann",
    "version": (0, 3, 0),
    "blender": (3, 4, 0),
    "location": "Render properties, with the render engine Lippmann",
    "description": "Renders for light-field displays: quilts, native frames, views and videos",
    "category": "Render",
}

import bpy  # noqa: E402

from . import displays, engine, frame, overlay, panel, render_views, saving, settings  # noqa: E402


def forget_displays(_self, _context):
    displays.forget()


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    tool: bpy.props.StringProperty(name="Tool", subtype="FILE_PATH", update=forget_displays,
                                   description="The program lippmann; empty: as PATH finds it")

    def draw(self, _context):
        self.layout.prop(self, "tool")


PARTS = (settings, engine, render_views, panel, frame, overlay, saving)


def register():
    bpy.utils.register_class(Preferences)
    for part in PARTS:
        part.register()


def unregister():
    for part in reversed(PARTS):
        part.unregister()
    bpy.utils.unregister_class(Preferences)
