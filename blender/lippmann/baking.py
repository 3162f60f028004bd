"""Bakes inputs that shader nodes compute (colour, roughness, bumps) to images, because glTF supports only image textures.

Cycles bakes each mesh of the exported scene once, into a new UV layer without overlaps. Copies of its materials then use the
baked images.
"""

import hashlib
from dataclasses import dataclass

import bpy
import numpy as np

from . import losses, nodes, versions
from . import materials as of_nodes

LAYER = "lippmann"
MOST_FACES = 300_000     # larger meshes take longer to unwrap than to render
MOST_LAYERS = 8          # Blender's limit of UV layers per mesh
MANY, MOST = 24, 256     # above MANY pictures, each is a quarter as wide; above MOST, none is baked
SAMPLES = 4


@dataclass
class Job:
    """The material inputs to bake for one mesh."""

    thing: object
    slots: dict  # index of a material slot -> {name of an input: descriptions of the nodes that compute it}

    def inputs(self):
        return sorted({name for inputs in self.slots.values() for name in inputs})


def kinds():
    """Returns {name of an input of the Principled BSDF: whether it is a colour} for all inputs that can be baked."""
    return {"Base Color": True, "Emission": True, "Roughness": False, "Metallic": False, "Normal": False}


def lost_by_input(material):
    """Returns {input of the Principled BSDF: descriptions of nodes} for inputs that depend on nodes that the glTF exporter
    does not support."""
    output = material.node_tree.get_output_node("ALL") if material and material.use_nodes and material.node_tree else None
    shader = nodes.source(output.inputs["Surface"]) if output else None
    if shader is None or shader.type != "BSDF_PRINCIPLED":
        return {}
    found = {}
    for name in kinds():
        socket = versions.input_of(shader, name)
        source = nodes.source(socket) if socket else None
        words = [losses.lost_of_node(node) for node in ([source, *nodes.upstream(source)] if source else [])]
        if any(words):
            found[name] = list(dict.fromkeys(word for word in words if word))
    return found


def jobs_of(stage):
    jobs, seen = [], set()
    for thing in stage.objects:
        if thing.type != "MESH" or thing.data in seen or not thing.data.polygons:
            continue
        seen.add(thing.data)
        used = {polygon.material_index for polygon in thing.data.polygons}
        slots = {index: lost_by_input(slot.material) for index, slot in enumerate(thing.material_slots) if index in used}
        slots = {index: inputs for index, inputs in slots.items() if inputs}
        if slots:
            jobs.append(Job(thing, slots))
    return jobs


def is_small_enough(job):
    return len(job.thing.data.polygons) <= MOST_FACES and len(job.thing.data.uv_layers) < MOST_LAYERS


def unwrap(thing):
    layers = thing.data.uv_layers
    active = layers.active.name if layers.active else ""
    shown = next((layer.name for layer in layers if layer.active_render), "")
    name = layers.new(name=LAYER, do_init=False).name
    layers.active = layers[name]
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(island_margin=0.01)
    bpy.ops.object.mode_set(mode="OBJECT")
    return name, active, shown


def target(tree, image):
    """Adds an image texture node and makes it active. Cycles bakes into the image of the active node."""
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    for other in tree.nodes:
        other.select = False
    node.select, tree.nodes.active = True, node


def shining(material, name, image):
    """Returns a copy of the material that emits the value of an input, so that baking the emission bakes the input. Cycles
    bakes normals without this trick."""
    copy = material.copy()
    tree = copy.node_tree
    if name != "Normal":
        output = tree.get_output_node("ALL")
        socket = versions.input_of(nodes.source(output.inputs["Surface"]), name)
        light = tree.nodes.new("ShaderNodeEmission")
        of_nodes.put(of_nodes.value_of(socket), light.inputs["Color"], tree)
        tree.links.new(light.outputs[0], output.inputs["Surface"])
    target(tree, image)
    return copy


def blank(image):
    material = bpy.data.materials.new("blank")
    material.use_nodes = True
    target(material.node_tree, image)
    return material


def arrays_of(mesh):
    """Yields (collection, attribute, numbers per element, type) for each array that defines a mesh."""
    yield from ((mesh.vertices, "co", 3, np.float32), (mesh.loops, "vertex_index", 1, np.int32), (mesh.polygons, "loop_total", 1, np.int32),
                (mesh.polygons, "material_index", 1, np.int32))
    yield versions.corner_normals(mesh)
    yield from ((layer.data, "uv", 2, np.float32) for layer in mesh.uv_layers)
    yield from ((layer.data, "color", 4, np.float32) for layer in mesh.color_attributes)


class Kept:
    """Baked pictures of earlier exports. File names are hashes of all that a picture depends on. materials: {name: hash}."""

    def __init__(self, folder, materials):
        self._folder, self._materials, self._used = folder, materials, set()

    def _key(self, job, name, size):
        """Returns the hash of everything the picture depends on, or None if a material has no hash."""
        own = [slot.material.name if slot.material else "" for slot in job.thing.material_slots]
        if any(material and material not in self._materials for material in own):
            return None
        made_of = [name, size, SAMPLES, sorted((index, name in inputs) for index, inputs in job.slots.items()), [self._materials.get(material) for material in own],
                   [tuple(row) for row in job.thing.matrix_world], [(layer.name, layer.active_render) for layer in job.thing.data.uv_layers]]
        found = hashlib.blake2b(repr(made_of).encode(), digest_size=16)
        for values, member, width, kind in arrays_of(job.thing.data):
            numbers = np.empty(width * len(values), kind)
            values.foreach_get(member, numbers)
            found.update(numbers.tobytes())
        return found.hexdigest()

    def picture(self, job, name, size):
        """Returns the picture of one input: from the file of an earlier export, or newly baked."""
        image = bpy.data.images.new(f"{job.thing.data.name} {name}", size, size, alpha=False, is_data=not kinds()[name])
        key = self._key(job, name, size)
        file = self._folder / f"{key}.png"
        self._used.add(file.name)
        if key and file.is_file():
            image.filepath_raw, image.source = str(file), "FILE"
            image.reload()
            image.pack()
        else:
            fill(image, job, name)
            self._pack(image, file if key else None)
        image.filepath_raw = ""  # otherwise the glTF file would contain the path
        return image

    def _pack(self, image, file):
        if file is None:
            image.pack()
            return
        self._folder.mkdir(exist_ok=True)
        unfinished = file.with_suffix(".part")
        image.filepath_raw, image.file_format = str(unfinished), "PNG"
        image.save()
        image.pack()
        unfinished.replace(file)

    def remove_others(self):
        for file in self._folder.glob("*.png"):
            if file.name not in self._used:
                file.unlink()


def fill(image, job, name):
    own = [slot.material for slot in job.thing.material_slots]
    for index, slot in enumerate(job.thing.material_slots):
        slot.material = shining(own[index], name, image) if name in job.slots.get(index, {}) else blank(image)
    bpy.ops.object.bake(type="NORMAL" if name == "Normal" else "EMIT", normal_space="TANGENT", margin=4, use_clear=True, target="IMAGE_TEXTURES")
    for slot, material in zip(job.thing.material_slots, own):
        bpy.data.materials.remove(slot.material)
        slot.material = material


def show_picture(tree, shader, name, image, layer):
    picture, place = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeUVMap")
    picture.image, place.uv_map = image, layer
    tree.links.new(place.outputs[0], picture.inputs["Vector"])
    socket = versions.input_of(shader, name)
    if name == "Normal":
        turned = tree.nodes.new("ShaderNodeNormalMap")
        turned.uv_map = layer
        tree.links.new(picture.outputs["Color"], turned.inputs["Color"])
        tree.links.new(turned.outputs[0], socket)
    elif kinds()[name]:
        tree.links.new(picture.outputs["Color"], socket)
    else:
        parts = tree.nodes.new("ShaderNodeSeparateColor")
        tree.links.new(picture.outputs["Color"], parts.inputs[0])
        tree.links.new(parts.outputs[{"Roughness": 1, "Metallic": 2}[name]], socket)


def bake_job(job, stage, size, kept):
    for thing in stage.objects:
        thing.select_set(thing == job.thing)
    bpy.context.view_layer.objects.active = job.thing
    layer, active, shown = unwrap(job.thing)
    pictures = {name: kept.picture(job, name, size) for name in job.inputs()}
    for index, inputs in job.slots.items():
        material = job.thing.material_slots[index].material.copy()
        tree = material.node_tree
        shader = nodes.source(tree.get_output_node("ALL").inputs["Surface"])
        for name in inputs:
            show_picture(tree, shader, name, pictures[name], layer)
        job.thing.material_slots[index].material = material
    layers = job.thing.data.uv_layers
    if active:
        layers.active, layers[shown or active].active_render = layers[active], True


def bake(stage, size, report, kept, begin):
    """Replaces unsupported nodes of the scene's materials by baked pictures of size x size pixels. kept: pictures of earlier
    exports. begin(text, share): reports progress. Returns {material: descriptions of the replaced nodes}."""
    jobs = jobs_of(stage)
    for job in jobs:
        if not is_small_enough(job):
            report.warn(f"What nodes compute on {job.thing.name} is lost: it has too many faces or layouts to be baked.")
    jobs = [job for job in jobs if is_small_enough(job)]
    count, arrived = 0, {}
    total = sum(len(job.inputs()) for job in jobs)
    if not jobs:
        return arrived
    if total > MANY:
        size //= 4
    scene_before = bpy.context.window.scene
    room = bpy.data.scenes.new("baking")
    room.render.engine, room.cycles.samples, room.cycles.use_denoising, room.cycles.device = "CYCLES", SAMPLES, False, "CPU"
    bpy.context.window.scene = room
    for job in jobs:
        if count + len(job.inputs()) > MOST:
            report.warn(f"Only the first {count} pictures of what nodes compute were baked.")
            break
        begin(f"baking {job.thing.name}", count / total)
        count += len(job.inputs())
        materials = {index: job.thing.material_slots[index].material for index in job.slots}
        room.collection.objects.link(job.thing)
        bake_job(job, room, size, kept)
        room.collection.objects.unlink(job.thing)
        for index, inputs in job.slots.items():
            arrived.setdefault(materials[index], []).extend(word for words in inputs.values() for word in words)
    bpy.context.window.scene = scene_before
    for material, words in arrived.items():
        report.warn(f"The material {material.name} arrives with pictures of {size} x {size} pixels in place of: {', '.join(dict.fromkeys(words))}.")
    return arrived
