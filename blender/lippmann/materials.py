"""Replaces shaders by one Principled BSDF with constants and image textures, because Blender's glTF exporter supports nothing
else.

A material is replaced in the exported copy of the file if it equals or resembles a Principled BSDF. losses.py warns about all
other materials.
"""

import math
from dataclasses import dataclass, field

import bpy

from .versions import input_of

PLAIN_F0 = 0.08  # reflectance at normal incidence if the input Specular is 1
BLACK, WHITE = (0.0, 0.0, 0.0, 1.0), (1.0, 1.0, 1.0, 1.0)
NOT_COPIED = {"rna_type", "type", "location", "location_absolute", "width", "height", "name", "label", "parent", "select", "inputs", "outputs", "dimensions", "internal_links", "show_options",
              "show_preview", "show_texture", "hide", "bl_idname"}
PARTS_OF_NODES = ("image_user", "texture_mapping", "color_mapping")


def luminance(colour):
    return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]


def link_of(socket):
    """Returns the output to which an input socket is linked, or None. Skips reroute nodes."""
    while socket.is_linked and socket.links:
        output = socket.links[0].from_socket
        if output.node.type != "REROUTE":
            return output
        socket = output.node.inputs[0]
    return None


def plain(value):
    return tuple(value) if hasattr(value, "__len__") else value


def mixed(kind, a, b, share):
    by_kind = {"MIX": lambda x, y: y, "MULTIPLY": lambda x, y: x * y, "ADD": lambda x, y: x + y, "SUBTRACT": lambda x, y: x - y, "SCREEN": lambda x, y: 1 - (1 - x) * (1 - y),
               "DARKEN": min, "LIGHTEN": max}
    if kind not in by_kind:
        return None
    return tuple(x + share * (by_kind[kind](x, y) - x) for x, y in zip(a, b))


def as_colour(value):
    return tuple(value) if isinstance(value, tuple) else (value, value, value, 1.0)


def mix_inputs(node):
    """Returns the input sockets (factor, first colour, second colour) of a node that mixes colours, else None."""
    if node.type == "MIX_RGB":
        return node.inputs[0], node.inputs[1], node.inputs[2]
    if node.data_type != "RGBA":
        return None
    sides = [socket for socket in node.inputs if socket.type == "RGBA"]
    return node.inputs[0], sides[0], sides[1]


def constant_mix(node):
    sockets = mix_inputs(node)
    if sockets is None:
        return None
    share, a, b = (constant(socket) for socket in sockets)
    if share is None or a is None or b is None:
        return None
    return mixed(node.blend_type, as_colour(a), as_colour(b), min(max(share, 0.0), 1.0))


def constant_math(node):
    by_kind = {"ADD": lambda x, y: x + y, "SUBTRACT": lambda x, y: x - y, "MULTIPLY": lambda x, y: x * y, "DIVIDE": lambda x, y: x / y if y else 0.0,
               "POWER": lambda x, y: x**y if x > 0.0 else 0.0, "MINIMUM": min, "MAXIMUM": max}
    a, b = constant(node.inputs[0]), constant(node.inputs[1])
    if node.operation not in by_kind or a is None or b is None:
        return None
    value = by_kind[node.operation](a, b)
    return min(max(value, 0.0), 1.0) if node.use_clamp else value


def constant_invert(node):
    share, colour = constant(node.inputs["Fac"]), constant(node.inputs["Color"])
    return None if share is None or colour is None else (*(c + share * (1.0 - 2.0 * c) for c in colour[:3]), 1.0)


def constant_gamma(node):
    colour, gamma = constant(node.inputs["Color"]), constant(node.inputs["Gamma"])
    return None if colour is None or gamma is None else (*(max(c, 0.0)**gamma for c in colour[:3]), 1.0)


CONSTANTS = {"RGB": lambda node: tuple(node.outputs[0].default_value), "VALUE": lambda node: node.outputs[0].default_value, "MIX_RGB": constant_mix, "MIX": constant_mix,
             "MATH": constant_math, "INVERT": constant_invert, "GAMMA": constant_gamma}


def constant(socket):
    """Returns the value of an input socket if it is the same on the whole surface, else None."""
    output = link_of(socket)
    if output is None:
        return plain(socket.default_value) if hasattr(socket, "default_value") else None
    value = CONSTANTS[output.node.type](output.node) if output.node.type in CONSTANTS else None
    if value is None or isinstance(value, tuple) == (socket.type in ("RGBA", "VECTOR")):
        return value
    if socket.type == "RGBA":
        return as_colour(value)
    return luminance(value) if isinstance(value, tuple) else None


def is_white(socket):
    value = constant(socket)
    return isinstance(value, tuple) and value[:3] == (1.0, 1.0, 1.0)


def kept_side(node):
    """Returns the one colour socket of a mix node that determines its output (for example, the first if the factor is 0), else
    None."""
    share, a, b = mix_inputs(node)
    weight, multiplies = constant(share), node.blend_type == "MULTIPLY"
    if weight == 0.0 or (multiplies and is_white(b)):
        return a
    return b if weight == 1.0 and (node.blend_type == "MIX" or (multiplies and is_white(a))) else None


def value_of(socket):
    """Returns the constant value of an input socket, or else the output to which it is linked. Skips mix nodes that pass one
    colour through."""
    found = constant(socket)
    if found is not None:
        return found
    output = link_of(socket)
    kept = kept_side(output.node) if output.node.type in ("MIX_RGB", "MIX") and mix_inputs(output.node) else None
    return value_of(kept) if kept else output


def is_constant(value):
    return isinstance(value, (tuple, float, int))


@dataclass
class Surface:
    values: dict = field(default_factory=dict)  # name of an input -> constant, or output socket to link
    own: object = None  # existing Principled BSDF, whose other inputs are kept; None: a new node
    near: list = field(default_factory=list)  # descriptions of properties that are only approximated

    def get(self, name, default):
        if name in self.values:
            return self.values[name]
        socket = input_of(self.own, name) if self.own else None
        return value_of(socket) if socket else default

    def is_transparent(self):
        return self.own is None and self.values.get("Alpha") == 0.0


def of_values(node, near=(), **values):
    surface = Surface({name.replace("_", " "): value for name, value in values.items()}, near=list(near))
    if "Normal" in node.inputs and node.inputs["Normal"].is_linked:
        surface.values["Normal"] = link_of(node.inputs["Normal"])
    return surface


def scaled(colour, by):
    if is_constant(colour):
        return (*(by * channel for channel in colour[:3]), 1.0)
    product = colour.id_data.nodes.new("ShaderNodeMixRGB")
    product.blend_type = "MULTIPLY"
    product.inputs[0].default_value, product.inputs[2].default_value = 1.0, (by, by, by, 1.0)
    colour.id_data.links.new(colour, product.inputs[1])
    return product.outputs[0]


def diffuse(node, near=()):
    """Returns the surface of a diffuse shader. With roughness, Cycles uses the Oren-Nayar model. Its mean brightness, by
    integration, is 1 / (1 + 0.2 roughness) times that of Lambert's model, so the colour is multiplied by this factor."""
    roughness = constant(node.inputs["Roughness"]) if "Roughness" in node.inputs else 0.0
    colour = value_of(node.inputs["Color"])
    if roughness:
        colour = scaled(colour, 1.0 / (1.0 + 0.2 * min(max(roughness, 0.0), 1.0)))
    return of_values(node, near, Base_Color=colour, Roughness=1.0, Specular=0.0, Metallic=0.0)


def glossy(node):
    return of_values(node, [], Base_Color=value_of(node.inputs["Color"]), Roughness=value_of(node.inputs["Roughness"]), Metallic=1.0)


def glass(node, near=()):
    return of_values(node, near, Base_Color=value_of(node.inputs["Color"]), Roughness=value_of(node.inputs["Roughness"]), Transmission=1.0, IOR=value_of(node.inputs["IOR"]),
                     Specular=0.5, Metallic=0.0)


def emission(node):
    return of_values(node, Base_Color=BLACK, Specular=0.0, Roughness=1.0, Emission=value_of(node.inputs["Color"]), Emission_Strength=value_of(node.inputs["Strength"]))


def transparent(node):
    colour = constant(node.inputs["Color"])
    return of_values(node, [] if colour and luminance(colour) > 0.99 else ["coloured transparency"], Base_Color=BLACK, Specular=0.0, Alpha=0.0)


BY_KIND = {
    "BSDF_PRINCIPLED": lambda node: Surface(own=node), "BSDF_DIFFUSE": diffuse, "BSDF_GLOSSY": glossy, "BSDF_ANISOTROPIC": glossy, "BSDF_GLASS": glass,
    "BSDF_REFRACTION": lambda node: glass(node, ["refraction without reflection"]), "EMISSION": emission, "BSDF_TRANSPARENT": transparent,
    "SUBSURFACE_SCATTERING": lambda node: diffuse(node, ["light below the surface"]), "BSDF_TRANSLUCENT": lambda node: diffuse(node, ["translucency"]),
    "BSDF_VELVET": lambda node: diffuse(node, ["velvet"]), "BSDF_SHEEN": lambda node: diffuse(node, ["velvet"]), "BSDF_TOON": lambda node: diffuse(node, ["toon"]),
}


def normal_reflectance(socket):
    """Returns the reflectance at normal incidence if a Fresnel or Layer Weight node is linked to the socket, else None."""
    output = link_of(socket)
    if output is None or output.node.type not in ("FRESNEL", "LAYER_WEIGHT") or (output.node.type == "LAYER_WEIGHT" and output.name != "Fresnel"):
        return None
    given = constant(output.node.inputs[0])
    if given is None:
        return None
    ior = given if output.node.type == "FRESNEL" else 1.0 / max(1.0 - given, 1e-3)
    return ((ior - 1.0) / (ior + 1.0))**2


def is_new(surface, **wanted):
    return surface.own is None and all(surface.values.get(name) == value for name, value in wanted.items())


def coated(base, coat, reflectance):
    values = {**base.values, "Specular": min(reflectance / PLAIN_F0, 1.0), "Roughness": coat.values["Roughness"]}
    return Surface(values, near=[*base.near, *coat.near])


def blended_value(a, b, share):
    if not is_constant(a) or not is_constant(b):
        return None
    if isinstance(a, tuple) != isinstance(b, tuple):
        return None
    return tuple(x + share * (y - x) for x, y in zip(a, b)) if isinstance(a, tuple) else a + share * (b - a)


def with_alpha(surface, alpha):
    before = surface.get("Alpha", 1.0)
    if is_constant(alpha) and is_constant(before):
        alpha = alpha * before
    elif before != 1.0:
        return Surface({**surface.values}, surface.own, [*surface.near, "one of two kinds of transparency"])
    return Surface({**surface.values, "Alpha": alpha}, surface.own, surface.near)


def lit(surface, light, share=1.0):
    strength = light.values["Emission Strength"]
    strength = strength * share if is_constant(strength) else strength
    return Surface({**surface.values, "Emission": light.values["Emission"], "Emission Strength": strength}, surface.own, [*surface.near, *light.near])


def is_light(surface):
    return surface.own is None and "Emission" in surface.values and surface.values.get("Base Color") == BLACK


def of_mixture(node):
    first, second = (surface_of(socket) for socket in node.inputs[1:3])
    share = constant(node.inputs[0])
    if share is not None and share in (0.0, 1.0):
        return second if share else first
    if first is None or second is None:
        return first or second
    if first.is_transparent() and not second.is_transparent():
        return with_alpha(second, share if share is not None else link_of(node.inputs[0]))
    if second.is_transparent() and not first.is_transparent():
        return with_alpha(first, 1.0 - share) if share is not None else Surface({**first.values}, first.own, [*first.near, "its transparency"])
    reflectance = normal_reflectance(node.inputs[0])
    if reflectance is not None and is_new(first, Metallic=0.0, Specular=0.0) and is_new(second, Metallic=1.0):
        return coated(first, second, reflectance)
    if share is None:
        return Surface({**first.values}, first.own, [*first.near, "a mixture that varies"])
    return constant_mixture(first, second, share)


def constant_mixture(first, second, share):
    if is_light(second) and not is_light(first):
        return darkened(lit(first, second, share), 1.0 - share)
    if is_light(first) and not is_light(second):
        return darkened(lit(second, first, 1.0 - share), share)
    larger = second if share > 0.5 else first
    values, near = {**larger.values}, [*first.near, *second.near]
    if first.own or second.own:
        return Surface(values, larger.own, [*near, "a mixture of shaders"])
    for name in set(first.values) | set(second.values):
        defaults = {"Metallic": 0.0, "Specular": 0.5, "Transmission": 0.0, "Alpha": 1.0, "Emission": BLACK, "Emission Strength": 1.0, "IOR": 1.45}
        blended = blended_value(first.values.get(name, defaults.get(name)), second.values.get(name, defaults.get(name)), share)
        if blended is not None:
            values[name] = blended
    if is_new(first, Metallic=0.0, Specular=0.0) and is_new(second, Metallic=1.0):
        values["Roughness"] = second.values["Roughness"]  # `first` has no reflection, so its roughness is invisible
    return Surface(values, None, [*near, "a mixture of shaders"])


def darkened(surface, share):
    colour = surface.get("Base Color", WHITE)
    return Surface({**surface.values, "Base Color": scaled(colour, share)}, surface.own, surface.near)


def of_sum(node):
    first, second = (surface_of(socket) for socket in node.inputs[0:2])
    if first is None or second is None:
        return first or second
    if is_light(second):
        return lit(first, second)
    if is_light(first):
        return lit(second, first)
    if first.is_transparent() or second.is_transparent():
        return first if second.is_transparent() else second
    return Surface(first.values, first.own, [*first.near, "a sum of shaders"])


def surface_of(socket):
    output = link_of(socket)
    if output is None:
        return None
    if output.node.type == "MIX_SHADER":
        return of_mixture(output.node)
    if output.node.type == "ADD_SHADER":
        return of_sum(output.node)
    return BY_KIND[output.node.type](output.node) if output.node.type in BY_KIND else None


def copy_properties(of, to):
    for name, kind in of.bl_rna.properties.items():
        if name in NOT_COPIED:
            continue
        value = getattr(of, name)
        if name == "color_ramp":
            copy_ramp(value, to.color_ramp)
        elif hasattr(value, "curves"):
            copy_curves(value, to.mapping)
        elif not kind.is_readonly:
            setattr(to, name, value)
        elif name in PARTS_OF_NODES:
            copy_properties(value, getattr(to, name))


def copy_ramp(of, to):
    to.color_mode, to.interpolation = of.color_mode, of.interpolation
    while len(to.elements) < len(of.elements):
        to.elements.new(1.0)
    for element, other in zip(to.elements, of.elements):
        element.position, element.color = other.position, other.color


def copy_curves(of, to):
    for curve, other in zip(to.curves, of.curves):
        while len(curve.points) < len(other.points):
            curve.points.new(0.0, 0.0)
        for point, another in zip(curve.points, other.points):
            point.location, point.handle_type = another.location, another.handle_type
    to.update()


def copy_node(node, tree):
    copy = tree.nodes.new(node.bl_idname)
    copy_properties(node, copy)
    for kind in ("inputs", "outputs"):
        for socket, other in zip(getattr(copy, kind), getattr(node, kind)):
            if hasattr(socket, "default_value") and other.type == socket.type and socket.type not in ("SHADER", "CUSTOM"):
                socket.default_value = other.default_value
    return copy


def take_apart(group, tree):
    inner = group.node_tree
    copies = {node.name: copy_node(node, tree) for node in inner.nodes if node.type not in ("GROUP_INPUT", "GROUP_OUTPUT", "FRAME")}
    ends = [node for node in inner.nodes if node.type == "GROUP_OUTPUT" and node.is_active_output]

    def feed(source, target):
        """Links `source`, an output socket in the group, to `target`. If `source` is an input of the group, uses the link or
        the constant at that input."""
        if source.node.type == "GROUP_INPUT":
            index = list(source.node.outputs).index(source)
            given = group.inputs[index]
            if given.is_linked:
                tree.links.new(given.links[0].from_socket, target)
            elif hasattr(given, "default_value") and hasattr(target, "default_value"):
                set_value(target, plain(given.default_value))
        else:
            outputs = list(source.node.outputs)
            tree.links.new(copies[source.node.name].outputs[outputs.index(source)], target)

    for link in inner.links:
        if link.to_node.name in copies:
            feed(link.from_socket, copies[link.to_node.name].inputs[list(link.to_node.inputs).index(link.to_socket)])
    for index, output in enumerate(group.outputs):
        for target in [link.to_socket for link in output.links]:
            end = ends[0].inputs[index] if ends else None
            if end is not None and end.is_linked:
                feed(end.links[0].from_socket, target)
            elif end is not None and hasattr(end, "default_value") and hasattr(target, "default_value"):
                set_value(target, plain(end.default_value))
    tree.nodes.remove(group)


def take_groups_apart(tree):
    """Replaces up to 64 group nodes by their nodes, including groups in groups."""
    for _ in range(64):
        group = next((node for node in tree.nodes if node.type == "GROUP" and node.node_tree), None)
        if group is None:
            return
        take_apart(group, tree)


def set_value(socket, value):
    if socket.type in ("RGBA", "VECTOR"):
        colour = as_colour(value)
        socket.default_value = colour[:len(socket.default_value)] if len(colour) >= len(socket.default_value) else (*colour, 1.0)
    elif socket.type in ("VALUE", "INT"):
        number = luminance(value) if isinstance(value, tuple) else value
        socket.default_value = int(number) if socket.type == "INT" else number


def put(value, socket, tree):
    if not is_constant(value):
        tree.links.new(value, socket)
        return
    while socket.is_linked:
        tree.links.remove(socket.links[0])
    set_value(socket, value)


def fold(shader, tree):
    for socket in shader.inputs:
        if socket.is_linked and socket.type in ("RGBA", "VALUE"):
            put(value_of(socket), socket, tree)


def settle(material, tree, output, surface):
    shader = surface.own
    if shader is None:
        shader = tree.nodes.new("ShaderNodeBsdfPrincipled")
        set_value(input_of(shader, "Emission"), BLACK)
    for name, value in surface.values.items():
        socket = input_of(shader, name)
        if socket is not None and value is not None:
            put(value, socket, tree)
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    fold(shader, tree)
    alpha = input_of(shader, "Alpha")
    if (alpha.is_linked or alpha.default_value < 1.0) and material.blend_method == "OPAQUE":
        material.blend_method = "BLEND"  # the exporter reads this setting; Cycles ignores it


def is_ready(shader):
    return shader is not None and shader.type in ("EMISSION", "BACKGROUND")


def simplify(material, report):
    tree = material.node_tree if material.use_nodes else None
    output = tree.get_output_node("ALL") if tree else None
    if output is None:
        return
    take_groups_apart(tree)
    source = link_of(output.inputs["Surface"])
    if source is None or is_ready(source.node):
        return
    surface = surface_of(output.inputs["Surface"])
    if surface is None:
        return
    settle(material, tree, output, surface)
    if surface.near:
        report.warn(f"The material {material.name} arrives without {', '.join(dict.fromkeys(surface.near))}.")


def simplify_all(materials, report):
    for material in materials:
        try:
            simplify(material, report)
        except (AttributeError, RuntimeError, TypeError) as error:  # nodes of missing add-ons or later versions of Blender
            report.warn(f"The material {material.name} could not be read: {error}.")


def fill_empty_slots(things, report):
    """Gives faces without a material the surface that Cycles renders there, diffuse with colour 0.8. In glTF they would be white."""
    grey = bpy.data.materials.new("no material")
    grey.use_nodes = True
    shader = grey.node_tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (0.8, 0.8, 0.8, 1.0)
    grey.node_tree.links.new(shader.outputs[0], grey.node_tree.get_output_node("ALL").inputs["Surface"])
    simplify(grey, report)
    for thing in things:
        if thing.type != "MESH" or not thing.data.polygons:
            continue
        if not thing.material_slots:
            thing.data.materials.append(grey)
        for slot in thing.material_slots:
            if slot.material is None:
                slot.material = grey


def take_gloss_away(document):
    """Removes the reflection at grazing angles that the exporter adds to materials with Specular 0. Returns whether a material
    was changed."""
    changed = False
    for material in document.get("materials", []):
        gloss = material.get("extensions", {}).get("KHR_materials_specular", {})
        if gloss.get("specularColorFactor") == [0.0, 0.0, 0.0] and gloss.get("specularFactor") != 0.0:
            gloss["specularFactor"], changed = 0.0, True
    return changed
