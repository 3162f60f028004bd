"""The settings of the add-on, which Blender stores in the scene and in the light-field frame. Lengths are in scene units
unless a name ends in mm."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from . import displays

OUTPUTS = [
    ("quilt", "Quilt", "All views side by side in one picture, as the display's player takes it"),
    ("native", "Native frame", "Every sub-pixel of the calibrated panel"),
    ("views", "Views", "A folder with one picture for each view"),
    ("single", "Preview: viewer", "What the display's viewer sees, with one eye, from the middle of the viewing zone"),
    ("camera", "Preview: camera", "The camera's own picture: its place, perspective and frame, in Blender's resolution"),
]

TONES = [
    ("none", "Standard", "Light that is brighter than white is white"),
    ("neutral", "Neutral", "Colours up to 80 % are kept, brighter ones are compressed: for products"),
    ("agx", "AgX", "Bright colours fade to white, as on film"),
]


def is_frame(_, candidate):
    return candidate.type == "EMPTY" and candidate.lippmann.is_frame


def show_other_display(self, context):
    displays.fit_resolution(context.scene)


class SceneSettings(bpy.types.PropertyGroup):
    frame: PointerProperty(type=bpy.types.Object, name="Frame", poll=is_frame,
                           description="The light-field frame: where the display's plane stands. Without one, it stands at the camera's focus")
    display: EnumProperty(items=displays.choices, name="Display", update=show_other_display,
                          description="The display that is rendered for")
    calibration: StringProperty(name="Calibration", subtype="FILE_PATH", update=show_other_display,
                                description="A device's calibration (visual.json), or a display of your own (.toml); used in place of the preset")
    output: EnumProperty(items=OUTPUTS, name="Output", default="quilt", update=show_other_display, description="What F12 and Ctrl-F12 render")
    samples: IntProperty(name="Samples", default=16, min=1, max=1 << 16, description="Paths for each pixel")
    denoise: BoolProperty(name="Denoise", default=True, description="Remove the noise of pictures with 2 samples or more")
    tone: EnumProperty(items=TONES, name="Tone", description="How light that is brighter than white is shown, in all files")
    exposure: FloatProperty(name="Exposure", soft_min=-10.0, soft_max=10.0, description="Stops by which pictures are brighter, in all files")
    full_depth: BoolProperty(name="All of the Depth", description="Show all of the scene's depth, blurred where the display cannot resolve it; "
                             "otherwise a scene that is too deep is shown less deep")
    resume: BoolProperty(name="Resume", default=True, description="Ctrl-F12 keeps the frames that an earlier, interrupted render of the same scene has finished")
    bake: BoolProperty(name="Bake", default=True, description="Make pictures of what nodes compute: procedural textures, bumps, colours. Takes a second or two for each mesh")
    bake_size: IntProperty(name="Baked Size", default=1024, min=64, max=8192, subtype="PIXEL", description="Width and height of these pictures; a quarter of it where there are more than 24")
    keep_scene: BoolProperty(name="Persistent Data", default=True, description="Keep the evaluated scene in memory, so that the next render of a slightly changed scene starts sooner")
    video: BoolProperty(name="Video", description="Ctrl-F12 also writes a video of the frames")
    folder: StringProperty(name="Folder", subtype="DIR_PATH", default="//lippmann/", description="Where the pictures, the video and the exported scene are written")
    show_overlay: BoolProperty(name="Show in Viewport", default=True, description="Draw the frame, its sharp depth and its viewing zone")
    extra: StringProperty(name="More Flags", description="Flags of lippmann render, such as: --tone agx --exposure 0.5")


class ObjectSettings(bpy.types.PropertyGroup):
    is_frame: BoolProperty(options={"HIDDEN"})
    height: FloatProperty(name="Height", default=1.0, min=1e-6, soft_max=100.0, unit="LENGTH",
                          description="Height of the display in the scene")


CLASSES = (SceneSettings, ObjectSettings)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.lippmann = PointerProperty(type=SceneSettings)
    bpy.types.Object.lippmann = PointerProperty(type=ObjectSettings)


def unregister():
    del bpy.types.Object.lippmann
    del bpy.types.Scene.lippmann
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
