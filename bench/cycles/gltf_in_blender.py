"""For scripts that Blender runs: a glTF file as a scene of Cycles, surfaces as glTF 2.0's appendix B has them.

Materials are built anew from the file: Blender's own Principled surface of 3.4 has Disney's diffuse part, which is not glTF's.
"""

import json
import math
import resource

import bpy
import numpy as np

np.bool = bool  # the importer of Blender 3.4 asks for a name that newer numpy has dropped


def image_of(name, color):
    image = bpy.data.images[name]
    image.colorspace_settings.name = "sRGB" if color else "Non-Color"
    return image


def below_gloss(roughness, f0, stops=24):
    """What a white GGX gloss does not reflect, at 1 - cosine of the view: [(place, share)]."""
    alpha2 = max(roughness, 0.03)**4
    u = (np.arange(4096) + 0.5) / 4096
    turn = 2 * np.pi * ((np.arange(4096) * 0.6180339887) % 1.0)
    cosine_h = np.sqrt((1 - u) / (1 + (alpha2 - 1) * u))  # facets by their distribution
    sine_h = np.sqrt(1 - cosine_h**2)
    shares = []
    for place in np.linspace(0, 1, stops):
        cosine = max(1 - place, 0.01)
        sine = math.sqrt(1 - cosine**2)
        view_h = sine * sine_h * np.cos(turn) + cosine * cosine_h
        light = 2 * view_h * cosine_h - cosine
        lit = (view_h > 0) & (light > 0)
        lambdas = [0.5 * (np.sqrt(1 + alpha2 * (1 / np.maximum(c, 1e-4)**2 - 1)) - 1) for c in (cosine, light)]
        weight = np.where(lit, view_h / (cosine * cosine_h * (1 + lambdas[0] + lambdas[1])), 0.0)
        reflected = (weight * (f0 + (1 - f0) * np.clip(1 - view_h, 0, 1)**5)).mean()
        shares.append((float(place), float(1 - reflected * (1 + f0 * (1 - weight.mean()) / weight.mean()))))
    return shares


class Surface:
    """One glTF material as nodes of Cycles."""

    def __init__(self, material, source, images):
        self.tree = material.node_tree
        self.tree.nodes.clear()
        self.images = images
        pbr = source.get("pbrMetallicRoughness", {})
        extensions = source.get("extensions", {})
        factor = pbr.get("baseColorFactor", [1, 1, 1, 1])
        color, alpha = self.mapped(pbr.get("baseColorTexture"), factor[:3], True)
        metallic, roughness = pbr.get("metallicFactor", 1.0), pbr.get("roughnessFactor", 1.0)
        normal = self.normal(source.get("normalTexture"))
        ior = extensions.get("KHR_materials_ior", {}).get("ior", 1.5)
        specular = extensions.get("KHR_materials_specular", {}).get("specularFactor", 1.0)
        transmission = extensions.get("KHR_materials_transmission", {}).get("transmissionFactor", 0.0)
        if transmission > 0:
            shader = self.node("ShaderNodeBsdfGlass", {"Color": color, "Roughness": roughness, "IOR": ior}, distribution="MULTI_GGX")
        elif metallic > 0:
            shader = self.metal(color, roughness, normal)
        else:
            shader = self.plastic(color, roughness, ior, normal) if specular > 0 else self.diffuse(color, normal)
        strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)
        glow = source.get("emissiveFactor", [0, 0, 0])
        if any(glow):
            shader = self.node("ShaderNodeAddShader", {0: shader, 1: self.node("ShaderNodeEmission", {"Color": glow, "Strength": strength})})
        shader = self.covered(shader, source, factor[3], alpha)
        self.node("ShaderNodeOutputMaterial", {"Surface": shader})

    def node(self, kind, inputs, output=0, **fields):
        node = self.tree.nodes.new(kind)
        for name, value in fields.items():
            setattr(node, name, value)
        for key, value in inputs.items():
            if value is None:
                continue
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[key])
            else:
                node.inputs[key].default_value = (*value, 1.0) if isinstance(value, (list, tuple)) and len(value) == 3 else value
        return node.outputs[output] if node.outputs else None

    def mapped(self, texture, factor, color):
        """Colour and alpha of a map times its factor."""
        if texture is None:
            return factor, 1.0
        picture = self.tree.nodes.new("ShaderNodeTexImage")
        picture.image = image_of(self.images[texture["index"]], color)
        picture.image.alpha_mode = "CHANNEL_PACKED"
        picture.interpolation = "Linear"
        return (self.node("ShaderNodeMixRGB", {0: 1.0, 1: picture.outputs["Color"], 2: factor}, blend_type="MULTIPLY"),
                picture.outputs["Alpha"])

    def normal(self, texture):
        if texture is None:
            return None
        color, _ = self.mapped(texture, [1, 1, 1], False)
        return self.node("ShaderNodeNormalMap", {"Color": color})

    def diffuse(self, color, normal):
        return self.node("ShaderNodeBsdfDiffuse", {"Color": color, "Roughness": 0.0, "Normal": normal})

    def plastic(self, color, roughness, ior, normal):
        """Fresnel's share is of facets: the gloss of a black Principled surface, and below it what that leaves."""
        f0 = ((ior - 1) / (ior + 1))**2
        gloss = self.node("ShaderNodeBsdfPrincipled", {"Base Color": [0, 0, 0], "Specular": f0 / 0.08, "Roughness": roughness, "Normal": normal},
                          distribution="MULTI_GGX")
        facing = self.node("ShaderNodeLayerWeight", {"Blend": 0.5, "Normal": normal}, output=1)  # 1 - cosine
        left = self.node("ShaderNodeValToRGB", {0: facing})
        ramp = left.node.color_ramp
        for i, (place, value) in enumerate(below_gloss(roughness, f0)):
            stop = ramp.elements[i] if i < 2 else ramp.elements.new(place)
            stop.position, stop.color = place, (value, value, value, 1.0)
        return self.node("ShaderNodeAddShader", {
            0: gloss, 1: self.diffuse(self.node("ShaderNodeMixRGB", {0: 1.0, 1: color, 2: left}, blend_type="MULTIPLY"), normal)})

    def metal(self, color, roughness, normal):
        return self.node("ShaderNodeBsdfPrincipled", {"Base Color": color, "Metallic": 1.0, "Roughness": roughness, "Normal": normal},
                         distribution="MULTI_GGX")

    def covered(self, shader, source, factor, alpha):
        mode = source.get("alphaMode", "OPAQUE")
        if mode == "OPAQUE":
            return shader
        coverage = self.node("ShaderNodeMath", {0: alpha, 1: factor}, operation="MULTIPLY")
        if mode == "MASK":
            coverage = self.node("ShaderNodeMath", {0: coverage, 1: source.get("alphaCutoff", 0.5)}, operation="GREATER_THAN")
        clear = self.node("ShaderNodeBsdfTransparent", {})
        return self.node("ShaderNodeMixShader", {0: coverage, 1: clear, 2: shader})


def document(path):
    data = open(path, "rb").read()
    if data[:4] == b"glTF":
        return json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])
    return json.loads(data)


def load(file):
    """An empty Blender with the file in it."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    source = document(file)
    # The importer names what has no name; ours are told apart by their place in the file.
    bpy.ops.import_scene.gltf(filepath=file, import_pack_images=True)
    images = [bpy.data.images[t["source"]].name for t in source.get("textures", [])]
    names = [m.get("name", f"Material_{i}") for i, m in enumerate(source.get("materials", []))]
    for name, material in zip(names, source.get("materials", [])):
        if name in bpy.data.materials:
            Surface(bpy.data.materials[name], material, images)
    lights = source.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    for lamp, light in zip(sorted((o for o in bpy.data.objects if o.type == "LIGHT"), key=lambda o: o.name), lights):
        lamp.data.energy = light.get("intensity", 1.0) * (1.0 if light["type"] == "directional" else 4.0 * math.pi)
        lamp.data.color = light.get("color", [1, 1, 1])
        sizes = light.get("extras", {})
        if light["type"] == "directional":
            lamp.data.angle = sizes.get("angle", 0.0)
        else:
            lamp.data.shadow_soft_size = sizes.get("radius", 0.0)
        if "blend" in sizes:
            lamp.data.spot_blend = sizes["blend"]


def surround(scene, panorama):
    """Black, or a panorama's light. panorama: a file, or nothing."""
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    background = nodes["Background"]
    background.inputs[0].default_value = (0, 0, 0, 1)
    if panorama:
        picture = nodes.new("ShaderNodeTexEnvironment")
        picture.image = bpy.data.images.load(panorama)
        links.new(picture.outputs[0], background.inputs[0])


def set_up(scene, width, height, vertices, threads):
    """Plain path tracing of as many surfaces as ours, light kept linear."""
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.light_sampling_threshold = 0.0
    scene.cycles.blur_glossy = 0.0
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
    scene.cycles.pixel_filter_type = "BOX"
    bounces = vertices - 1
    scene.cycles.max_bounces = bounces
    for kind in ("diffuse", "glossy", "transmission"):
        setattr(scene.cycles, f"{kind}_bounces", bounces)
    scene.cycles.transparent_max_bounces = 64
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    scene.view_settings.view_transform = "Raw"


def render(scene, samples, seed, out):
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.filepath = out
    bpy.ops.render.render(write_still=True)


def cpu_seconds():
    """Of all threads of this process."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def camera():
    return next(o for o in bpy.data.objects if o.type == "CAMERA")
