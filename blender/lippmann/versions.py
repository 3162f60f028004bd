"""Parts of Blender's API that differ between versions. No other module of the add-on checks the version."""

import bpy
import gpu
import numpy as np

NAMES = {  # inputs of the Principled BSDF: name in Blender 3 -> all names
    "Specular": ("Specular", "Specular IOR Level"), "Transmission": ("Transmission", "Transmission Weight"), "Emission": ("Emission", "Emission Color"),
}


def name_among(inputs, name):
    return next((one for one in NAMES.get(name, (name,)) if one in inputs), None)


def input_of(shader, name):
    """Returns an input of a Principled BSDF, or None if this version of Blender does not have it. name: as in Blender 3."""
    found = name_among(shader.inputs, name)
    return shader.inputs[found] if found else None


def eevee():
    return "BLENDER_EEVEE_NEXT" if (4, 2) <= bpy.app.version < (5, 0) else "BLENDER_EEVEE"


def still_format(image_settings):
    """Returns the attributes that select PNG files. Since Blender 5.0, settings of videos refuse formats of pictures."""
    kind = {"media_type": "IMAGE"} if hasattr(image_settings, "media_type") else {}
    return {**kind, "file_format": "PNG"}


def plain_shader():
    """Returns Blender's shader for a uniform colour. Its name began with "3D_" before Blender 4.0."""
    try:
        return gpu.shader.from_builtin("UNIFORM_COLOR")
    except ValueError:
        return gpu.shader.from_builtin("3D_UNIFORM_COLOR")


def corner_normals(mesh):
    """Returns (collection, attribute, numbers per element, type) of the normals at the corners of a mesh's faces."""
    if hasattr(mesh, "corner_normals"):  # Blender 4.1 and later
        return mesh.corner_normals, "vector", 3, np.float32
    mesh.calc_normals_split()
    return mesh.loops, "normal", 3, np.float32


def curves_of(motion):
    """Returns the animation curves of an object. Since Blender 5.0, the curves belong to layers of an action."""
    if hasattr(motion.action, "fcurves"):
        return list(motion.action.fcurves)
    bags = [strip.channelbag(motion.action_slot) for layer in motion.action.layers for strip in layer.strips]
    return [curve for bag in bags if bag for curve in bag.fcurves]


def make_panorama(camera):
    """Makes a camera equirectangular. Before Blender 5.0, this is a property of Cycles."""
    camera.type = "PANO"
    holder = camera if hasattr(camera, "panorama_type") else camera.cycles
    holder.panorama_type = "EQUIRECTANGULAR"


def composites(scene):
    """Since Blender 5.0, the compositor's nodes are a node group of the scene."""
    if hasattr(scene, "compositing_node_group"):
        return scene.compositing_node_group is not None
    return scene.use_nodes


def has_strips(scene):
    """Returns whether Blender's video sequencer has strips. Blender 4.3 and older use another name for their list."""
    editor = scene.sequence_editor
    return bool(editor and len(editor.strips_all if hasattr(editor, "strips_all") else editor.sequences_all))
