"""Point lamps whose IES texture has a file: Blender's exporter drops it, and glTF's EXT_lights_ies carries it (docs/reference/gltf.md).

Taken are lamps as Blender's users make them: an IES Texture, with no rotation of its own, as the strength of the lamp's Emission. Cycles makes
4 pi / 177.83 of a candela and spreads a lamp's power over 4 pi, so that a lamp of P watts has P / 177.83 of the file's candelas. Its azimuths run from
-Y clockwise, seen from above; those of EXT_lights_ies from +X the other way: a quarter turn makes them the same for profiles whose halves mirror each
other, which have no angles above 180 degrees. Others arrive mirrored.
"""

import base64
import math
import pathlib

import bpy

from .nodes import source

LUMENS_PER_WATT = 177.83  # as Cycles has it, of white light
MISSING = object()        # a lamp whose file is not there
QUARTER_TURN = [0.0, 0.0, -math.sqrt(0.5), math.sqrt(0.5)]  # about the lamp's axis


def text_of(node, light):
    """What the node's file says; MISSING where there is none."""
    if node.mode == "INTERNAL":
        return node.ies.as_string() if node.ies else MISSING
    path = pathlib.Path(bpy.path.abspath(node.filepath, library=light.library))
    return path.read_text(errors="replace") if path.is_file() else MISSING


def profile_of(light):
    """(text or MISSING, multiplier, colour) of a point lamp with an IES texture and nothing else; None for others."""
    if light.type != "POINT" or not light.use_nodes or not light.node_tree:
        return None
    output = light.node_tree.get_output_node("ALL")
    shader = source(output.inputs["Surface"]) if output else None
    if shader is None or shader.type != "EMISSION" or shader.inputs["Color"].is_linked:
        return None
    node = source(shader.inputs["Strength"])
    if node is None or node.type != "TEX_IES" or any(socket.is_linked for socket in node.inputs):
        return None
    colour = [mine * its for mine, its in zip(light.color, shader.inputs["Color"].default_value)]
    return text_of(node, light), light.energy * node.inputs["Strength"].default_value / LUMENS_PER_WATT, colour


def mark(light):
    """Writes the profile into custom properties, which the exporter passes on, for `move_profiles` to find them."""
    profile = profile_of(light)
    if profile and profile[0] is not MISSING:
        light["ies"], light["ies_multiplier"], light["ies_color"] = profile


def move_profiles(document):
    """Whether any profiles were moved from the extras of a document's lights to their nodes, in place of the lights."""
    lights = document.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    profiles, turned = [], []
    nodes = document.get("nodes", [])
    for node in nodes:
        index = node.get("extensions", {}).get("KHR_lights_punctual", {}).get("light")
        extras = lights[index].get("extras", {}) if index is not None else {}
        if "ies" in extras:
            del node["extensions"]["KHR_lights_punctual"]
            node.setdefault("children", []).append(len(nodes) + len(turned))
            lamp = {"light": len(profiles), "multiplier": extras["ies_multiplier"], "color": list(extras["ies_color"])}
            turned.append({"rotation": QUARTER_TURN, "extensions": {"EXT_lights_ies": lamp}})
            uri = "data:application/octet-stream;base64," + base64.b64encode(extras["ies"].encode()).decode()
            profiles.append({"name": lights[index].get("name", ""), "uri": uri})
    nodes += turned
    if profiles:
        for light in lights:
            light["extras"] = {name: value for name, value in light.get("extras", {}).items() if not name.startswith("ies")}
        document["extensions"]["EXT_lights_ies"] = {"lights": profiles}
        document.setdefault("extensionsUsed", []).append("EXT_lights_ies")
    return bool(profiles)
