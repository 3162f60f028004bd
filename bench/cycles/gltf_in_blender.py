"""Loads a glTF file as a scene for Cycles, with surfaces as in appendix B of glTF 2.0. Runs inside
Blender.

Blender's own importer makes the textures and the vertex colours. The Principled surface that the
importer makes is replaced, because the diffuse part of this surface follows Disney's model in
Blender 3.4, and not glTF's. Materials that use a feature in LAYERS or GLOSS keep the Principled
surface.
"""

import math
import pathlib
import resource
import sys
import tempfile

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import lamps  # noqa: E402
import one_file  # noqa: E402
import reads  # noqa: E402

if not hasattr(np, "bool"):
    np.bool = bool  # the importer of Blender 3.4 uses this name, which some versions of numpy do not have

LAYERS = {"KHR_materials_sheen", "KHR_materials_anisotropy", "KHR_materials_iridescence", "KHR_materials_diffuse_transmission",
          "KHR_materials_dispersion", "KHR_materials_pbrSpecularGlossiness", "KHR_materials_unlit"}
GLOSS = {"specularTexture", "specularColorFactor", "specularColorTexture"}  # features of KHR_materials_specular
ROUGHNESSES = (0.0, 0.25, 0.5, 0.75, 1.0)  # for textured roughness: the roughnesses at which below_gloss() is tabulated
COAT_IOR = 1.5
LATER = {"Specular": "Specular IOR Level", "Transmission": "Transmission Weight", "Clearcoat": "Coat Weight", "Clearcoat Roughness": "Coat Roughness",
         "Clearcoat Normal": "Coat Normal"}  # names of inputs of the Principled surface since Blender 4.0


def socket(node, key):
    """Returns an input of a node. key: number of the input, or its name in Blender 3."""
    later = LATER.get(key)
    return node.inputs[later if later and later in node.inputs else key]


def below_gloss(roughness, f0, stops=24):
    """Returns the share of light that a white GGX gloss does not reflect, as a list of (1 - cosine of the view angle,
    share)."""
    alpha2 = max(roughness, 0.03)**4
    u = (np.arange(4096) + 0.5) / 4096
    turn = 2 * np.pi * ((np.arange(4096) * 0.6180339887) % 1.0)
    cosine_h = np.sqrt((1 - u) / (1 + (alpha2 - 1) * u))
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
    def __init__(self, material, source):
        self.tree = material.node_tree
        self.principled = next((n for n in self.tree.nodes if n.type == "BSDF_PRINCIPLED"), None)
        extensions = source.get("extensions", {})
        gloss = extensions.get("KHR_materials_specular", {})
        if self.principled is None or LAYERS & set(extensions) or GLOSS & set(gloss):
            return
        self.ior = extensions.get("KHR_materials_ior", {}).get("ior", 1.5)
        self.specular = gloss.get("specularFactor", 1.0)
        shader = self.mixed(self.dielectric(), self.metal, self.input("Metallic"))
        shader = self.coated(shader)
        shader = self.glowing(shader, source)
        self.replace(self.covered(shader, source))
        self.absorb(extensions.get("KHR_materials_volume", {}))

    def input(self, name):
        given = socket(self.principled, name)
        if given.is_linked:
            return given.links[0].from_socket
        value = given.default_value
        return value if isinstance(value, float) else tuple(value)[:3]

    def normal(self, name="Normal"):
        given = socket(self.principled, name)
        return given.links[0].from_socket if given.is_linked else None

    def node(self, kind, inputs, output=0, **fields):
        node = self.tree.nodes.new(kind)
        for name, value in fields.items():
            setattr(node, name, value)
        for key, value in inputs.items():
            if value is None:
                continue
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket(node, key))
            else:
                socket(node, key).default_value = (*value, 1.0) if isinstance(value, (list, tuple)) and len(value) == 3 else value
        return node.outputs[output] if node.outputs else None

    def math(self, operation, a, b):
        return self.node("ShaderNodeMath", {0: a, 1: b}, operation=operation)

    def times(self, color, factor):
        return self.node("ShaderNodeMixRGB", {0: 1.0, 1: color, 2: factor}, blend_type="MULTIPLY")

    def mixed(self, shader, make_other, share):
        """share: weight of the shader that make_other() returns. make_other() is not called if the weight is 0."""
        if share == 0.0:
            return shader
        other = make_other()
        return other if share == 1.0 else self.node("ShaderNodeMixShader", {0: share, 1: shader, 2: other})

    def dielectric(self):
        opaque = self.plastic() if self.specular > 0 else self.diffuse(self.input("Base Color"))
        return self.mixed(opaque, self.glass, self.input("Transmission"))

    def diffuse(self, color):
        return self.node("ShaderNodeBsdfDiffuse", {"Color": color, "Roughness": 0.0, "Normal": self.normal()})

    def gloss(self, **inputs):
        named = {"Roughness": self.input("Roughness"), "Normal": self.normal(), "IOR": self.ior}
        return self.node("ShaderNodeBsdfPrincipled", {**named, **{name.replace("_", " "): value for name, value in inputs.items()}},
                         distribution="MULTI_GGX")

    def plastic(self):
        """Returns the shader for plastic: the gloss of a black Principled surface plus the diffuse light below it."""
        f0 = self.specular * ((self.ior - 1) / (self.ior + 1))**2
        # The input "Specular" sets the reflectance f0. Before Blender 4.0, an input of 1 gives f0 = 0.08. Since then,
        # an input of 0.5 gives the f0 of the index of refraction.
        of_ior = LATER["Specular"] in self.principled.inputs
        gloss = self.gloss(Base_Color=[0, 0, 0], Specular=0.5 * self.specular if of_ior else f0 / 0.08)
        return self.node("ShaderNodeAddShader", {0: gloss, 1: self.diffuse(self.times(self.input("Base Color"), self.left(f0)))})

    def left(self, f0):
        facing = self.node("ShaderNodeLayerWeight", {"Blend": 0.5, "Normal": self.normal()}, output=1)
        roughness = self.input("Roughness")
        if isinstance(roughness, float):
            return self.ramp(facing, below_gloss(roughness, f0))
        total = 0.0
        for level in ROUGHNESSES:  # the weights are hat functions whose sum is 1
            away = self.math("MULTIPLY", self.math("ABSOLUTE", self.math("SUBTRACT", roughness, level), 0.0), len(ROUGHNESSES) - 1.0)
            weight = self.math("MAXIMUM", self.math("SUBTRACT", 1.0, away), 0.0)
            total = self.math("ADD", total, self.math("MULTIPLY", weight, self.ramp(facing, below_gloss(level, f0))))
        return total

    def ramp(self, at, stops):
        out = self.node("ShaderNodeValToRGB", {0: at})
        elements = out.node.color_ramp.elements
        for i, (place, value) in enumerate(stops):
            stop = elements[i] if i < 2 else elements.new(place)
            stop.position, stop.color = place, (value, value, value, 1.0)
        return out

    def glass(self):
        return self.gloss(Base_Color=self.input("Base Color"), Transmission=1.0)

    def metal(self):
        return self.gloss(Base_Color=self.input("Base Color"), Metallic=1.0)

    def coated(self, shader):
        """Adds a white gloss, weighted by Fresnel's term for the normal of the coat (KHR_materials_clearcoat)."""
        amount = self.input("Clearcoat")
        if amount == 0.0:
            return shader
        normal = self.normal("Clearcoat Normal")
        share = self.math("MULTIPLY", self.node("ShaderNodeFresnel", {"IOR": COAT_IOR, "Normal": normal}), amount)
        coat = self.node("ShaderNodeBsdfGlossy", {"Color": [1, 1, 1], "Roughness": self.input("Clearcoat Roughness"), "Normal": normal},
                         distribution="MULTI_GGX")
        return self.node("ShaderNodeMixShader", {0: share, 1: shader, 2: coat})

    def glowing(self, shader, source):
        """Adds the emission. Blender's importer drops the emission's texture if the factor is not grey."""
        factor = source.get("emissiveFactor", [0.0, 0.0, 0.0])
        if not any(factor):
            return shader
        strength = source.get("extensions", {}).get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)
        picture = next((n for n in self.tree.nodes if n.type == "TEX_IMAGE" and n.label == "EMISSIVE"), None)
        color = self.times(picture.outputs["Color"], factor) if picture else factor
        lit = self.node("ShaderNodeEmission", {"Color": color, "Strength": strength})
        return self.node("ShaderNodeAddShader", {0: shader, 1: lit})

    def covered(self, shader, source):
        mode, coverage = source.get("alphaMode", "OPAQUE"), self.input("Alpha")
        if mode == "OPAQUE" or coverage == 1.0:
            return shader
        if mode == "MASK":
            coverage = self.math("SUBTRACT", 1.0, self.math("LESS_THAN", coverage, source.get("alphaCutoff", 0.5)))
        return self.node("ShaderNodeMixShader", {0: coverage, 1: self.node("ShaderNodeBsdfTransparent", {}), 2: shader})

    def absorb(self, volume):
        """Sets the absorption coefficient to -ln(attenuation colour) / distance (KHR_materials_volume). In Cycles, the
        coefficient is density (1 - colour)."""
        node = next((n for n in self.tree.nodes if n.type == "VOLUME_ABSORPTION"), None)
        distance = volume.get("attenuationDistance", math.inf)
        if node is None:
            return
        per_length = [-math.log(max(c, 1e-4)) / distance for c in volume.get("attenuationColor", [1, 1, 1])]
        density = max(*per_length, 1e-9)
        node.inputs["Density"].default_value = density
        node.inputs["Color"].default_value = (*(1 - p / density for p in per_length), 1.0)

    def replace(self, shader):
        for link in list(self.principled.outputs[0].links):
            self.tree.links.new(shader, link.to_socket)


def numbered(file, folder):
    copy = one_file.OneFile(pathlib.Path(file))
    doc = copy.doc
    bare = [p for mesh in doc.get("meshes", []) for p in mesh["primitives"] if "material" not in p]
    for primitive in bare:
        primitive["material"] = len(doc.get("materials", []))
    if bare:
        doc.setdefault("materials", []).append({})
    lights = doc.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])
    for kind, things in (("material", doc.get("materials", [])), ("light", lights)):
        for i, thing in enumerate(things):
            thing["name"] = f"{kind}-{i}"
    copy.write(folder / "numbered.glb")
    return doc, lights


def number_of(thing):
    """Returns N for "material-N" and for copies with vertex colours, "material-N.001"."""
    return int(thing.name.split("-")[1].split(".")[0])


def load(file, own_surfaces=False):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with tempfile.TemporaryDirectory() as folder:
        source, lights = numbered(file, pathlib.Path(folder))
        bpy.ops.import_scene.gltf(filepath=f"{folder}/numbered.glb", import_pack_images=True)
    for material in [] if own_surfaces else bpy.data.materials:
        if material.name.startswith("material-"):
            Surface(material, source["materials"][number_of(material)])
    for lamp in bpy.data.lights:
        light_up(lamp, lights[number_of(lamp)], source["asset"].get("generator", ""))
    bpy.context.scene.frame_set(0)


def importers_extensions():
    """Returns the glTF extensions that Blender's importer reads. The importer of Blender 3.4 reads
    KHR_materials_volume, too, although its list does not contain it."""
    from io_scene_gltf2.io.imp.gltf2_io_gltf import glTFImporter
    return set(glTFImporter("", {"import_user_extensions": []}).extensions_managed) | {"KHR_materials_volume"}


def unread(file):
    """Returns the features of a file that this Blender does not show."""
    names = reads.extensions_of(one_file.OneFile(pathlib.Path(file)).doc)
    return reads.unread(names, importers_extensions(), bpy.app.version)


def light_up(lamp, light, generator):
    """Sets the size of a lamp as the file states it, and the brightness that Lippmann uses (lamps.py)."""
    point = light["type"] != "directional"
    lamp.energy = light.get("intensity", 1.0) * lamps.scale(generator, light["type"]) * (4.0 * math.pi if point else 1.0)
    lamp.color = light.get("color", [1, 1, 1])
    sizes = light.get("extras", {})
    if point:
        lamp.shadow_soft_size = sizes.get("radius", 0.0)
    else:
        lamp.angle = sizes.get("angle", 0.0)
    if "blend" in sizes:
        lamp.spot_blend = sizes["blend"]


def surround(scene, panorama):
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
    """Selects path tracing without denoising, with as many vertices per path as in our renders, and linear output."""
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
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def camera():
    return next(o for o in bpy.data.objects if o.type == "CAMERA")
