"""Finds the parts of a Blender scene that the glTF export loses. Each becomes a warning in the panel.

Blender's exporter supports only a Principled BSDF or an Emission at the material's output, with image textures. It does not
evaluate nodes that compute colours.
"""

from . import exposure, film, frame, ies, versions
from .nodes import source, upstream

SHADERS = {"BSDF_PRINCIPLED", "EMISSION", "BACKGROUND"}
CARRIED = {"TEX_IMAGE", "NORMAL_MAP", "MAPPING", "UVMAP", "TEX_COORD", "SEPARATE_COLOR", "SEPRGB", "RGB", "VALUE", "REROUTE", "VERTEX_COLOR", "MATH"}
STRANDS = {"PATH", "HALO", "LINE"}
MOVING = {"MOVIE", "SEQUENCE", "TILED"}


def multiplies(node):
    """The exporter supports multiplied colours, as a factor of a texture."""
    return node.type in ("MIX", "MIX_RGB") and node.blend_type == "MULTIPLY"


def lost_of_node(node):
    """Returns a description of what the export loses of a shader node, or None."""
    if node.type == "TEX_COORD":
        others = [output.name for output in node.outputs if output.is_linked and output.name != "UV"]
        return f"coordinates {', '.join(others)}" if others else None
    if node.type == "TEX_IMAGE" and node.image and node.image.source in MOVING:
        return f"{node.image.name}, which is no single picture"
    return None if node.type in CARRIED or multiplies(node) else node.bl_label


def lost_of_material(material):
    output = material.node_tree.get_output_node("ALL") if material.use_nodes and material.node_tree else None
    if output is None:
        return []
    shader = source(output.inputs["Surface"])
    lost = [name.lower() for name in ("Volume", "Displacement") if output.inputs[name].is_linked]
    if shader is None:
        return lost
    if shader.type not in SHADERS:
        return [shader.bl_label, *lost]
    return list(dict.fromkeys([words for words in map(lost_of_node, upstream(shader)) if words] + lost))


def is_animated(thing):
    motions = [getattr(owner, "animation_data", None) for owner in (thing, getattr(thing, "node_tree", None)) if owner]
    return any(motion and (motion.action or len(motion.drivers)) for motion in motions)


def say_of_materials(materials, still, baked, report):
    for material in materials:
        lost = [words for words in lost_of_material(material) if words not in baked.get(material, ())]
        if lost:
            report.warn(f"The material {material.name} loses what glTF cannot carry: {', '.join(lost)}.")
        if not still and is_animated(material):
            report.warn(f"The material {material.name} is animated; it stays as in the first frame.")


def has_nodes_of_its_own(light):
    """Returns whether the nodes of a light define more than its colour and its power."""
    if not light.use_nodes or not light.node_tree:
        return False
    output = light.node_tree.get_output_node("ALL")
    shader = source(output.inputs["Surface"]) if output else None
    plain = shader and shader.type == "EMISSION" and not upstream(shader) and tuple(shader.inputs["Color"].default_value)[:3] == (1.0, 1.0, 1.0)
    return not plain or shader.inputs["Strength"].default_value != 1.0


def say_of_lights(lights, still, report):
    for light in lights:
        profile = ies.profile_of(light)
        if profile and profile[0] is ies.MISSING:
            report.warn(f"The light profile of {light.name} is missing; it shines evenly.")
        elif not profile and has_nodes_of_its_own(light):
            report.warn(f"The light {light.name} loses its nodes; its colour and power are kept.")
        if not still and is_animated(light):
            report.warn(f"The light {light.name} is animated; it stays as in the first frame.")


def say_of_objects(things, report):
    for thing in things:
        for modifier in thing.modifiers:
            if modifier.type == "PARTICLE_SYSTEM" and modifier.particle_system.settings.render_type in STRANDS:
                report.warn(f"Particles of {thing.name} that are strands or halos are left out.")
        if thing.type != "LIGHT" and (thing.is_holdout or thing.is_shadow_catcher):
            report.warn(f"{thing.name} is a holdout or a shadow catcher; it is shown like any other object.")
        if not (thing.visible_diffuse and thing.visible_glossy and thing.visible_transmission):
            report.warn(f"{thing.name} is hidden from some of the rays that surfaces scatter; they meet it all the same.")


def is_panoramic(scene):
    camera = scene.camera
    is_shown = scene.lippmann.output == "camera" or not frame.placed(scene)
    return bool(camera and camera.type == "CAMERA" and camera.data.type == "PANO" and is_shown)


def say_of_scene(scene, still, report):
    for lost in (exposure.lost_of_lens(scene), exposure.lost_of_shutter(scene, still), film.lost_of_transparency(scene, still)):
        if lost:
            report.warn(lost)
    if is_panoramic(scene):
        report.warn("The camera is panoramic, which no display is; it is taken as an orthographic one. A light-field frame says what is shown.")
    if scene.render.use_multiview:
        report.warn("Stereoscopy is left out: Blender's other views stay empty. The tool's pictures have the display's views.")
    if getattr(scene.render, "use_freestyle", False):
        report.warn("Freestyle's lines are left out.")
    if scene.render.use_compositing and versions.composites(scene):
        report.warn("Compositing changes what Blender shows, not the tool's pictures.")


def say(scene, still, baked, report):
    """Warns about everything that the export loses. Call after removing missing textures. baked: {material: nodes that
    baking.bake() has replaced}, which are not lost."""
    things = [thing for thing in scene.objects if not thing.hide_render]
    shown = {thing.instance_collection for thing in things if thing.instance_collection}
    things += [thing for collection in sorted(shown, key=lambda c: c.name) for thing in collection.all_objects]
    materials = {slot.material: None for thing in things for slot in thing.material_slots if slot.material}
    say_of_materials(materials, still, baked, report)
    say_of_lights({thing.data: None for thing in things if thing.type == "LIGHT"}, still, report)
    say_of_objects(things, report)
    say_of_scene(scene, still, report)
    if not still and scene.world and is_animated(scene.world):
        report.warn("The world is animated; it stays as in the first frame.")
