"""Exports IES profiles of point lamps by the glTF extension EXT_lights_ies (docs/reference/gltf.md), because Blender's exporter
drops them.

A profile is exported if an IES Texture node without a rotation is linked to the strength of the lamp's Emission node.

Power: Cycles multiplies the candelas of the file by 4 pi / 177.83 and divides a lamp's power by 4 pi. A lamp of P watts therefore
emits P / 177.83 times the candelas of the file.

Azimuth: Cycles measures azimuths from -Y, clockwise seen from above. EXT_lights_ies measures them from +X, counterclockwise. A
quarter turn aligns profiles with mirror symmetry, whose azimuths end at 180 degrees. Other profiles are exported mirrored.
"""

import base64
import math
import pathlib

import bpy

from .nodes import source

LUMENS_PER_WATT = 177.83  # of white light, as in Cycles
MISSING = object()        # returned in place of the text of a missing file
QUARTER_TURN = [0.0, 0.0, -math.sqrt(0.5), math.sqrt(0.5)]  # quaternion x, y, z, w: -90 degrees about the lamp's axis


def text_of(node, light):
    if node.mode == "INTERNAL":
        return node.ies.as_string() if node.ies else MISSING
    path = pathlib.Path(bpy.path.abspath(node.filepath, library=light.library))
    return path.read_text(errors="replace") if path.is_file() else MISSING


def profile_of(light):
    """Returns (text or MISSING, multiplier, colour) of a point lamp with an IES texture. Returns None for other lamps."""
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
    """Stores a lamp's profile in custom properties. The exporter writes these as glTF extras, which move_profiles() reads."""
    profile = profile_of(light)
    if profile and profile[0] is not MISSING:
        light["ies"], light["ies_multiplier"], light["ies_color"] = profile


def move_profiles(document):
    """Replaces lights whose extras hold a profile by lights of EXT_lights_ies. Returns whether there were any."""
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
