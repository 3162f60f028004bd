"""Exports a scene as glTF, with a camera at the position of the display's viewer. Runs in a second Blender:

  blender -b --factory-startup -P scene_export.py -- REQUEST.json

REQUEST.json contains: library (a .blend file with the scene), scene (its name), display, calibration, frames (first and last),
still (whether to export one picture), painted (pixels of images, as .npy files), and the files to write: glb, world (a
panorama) and report (JSON).

Every object becomes a mesh with a key at each frame, because Blender's glTF exporter ignores motion by constraints, drivers,
parents and simulations. In animations, meshes that armatures or shape keys deform are exported with skins and morph targets.
"""

import importlib
import json
import math
import pathlib
import sys

import bmesh
import bpy
import numpy as np
from mathutils import Matrix

HERE = pathlib.Path(__file__).resolve().parent
SOLID = {"MESH", "CURVE", "SURFACE", "META", "FONT"}
LOST = {"VOLUME": "volumes", "CURVES": "hair curves", "POINTCLOUD": "point clouds", "GPENCIL": "grease pencil", "GREASEPENCIL": "grease pencil", "LIGHT_PROBE": None, "SPEAKER": None}
EYE = "lippmann-eye"
PARALLEL = 1e4  # viewing distance / picture height for an orthographic camera; rays diverge by less than a pixel


class Report:
    def __init__(self):
        self.warnings = []

    def warn(self, text):
        if text not in self.warnings:
            self.warnings.append(text)


def part(name):
    """Returns a module of the add-on, which main() adds to Python's path."""
    return importlib.import_module(f"{HERE.name}.{name}")


def begin(step, share=0.0):
    print(json.dumps({"step": step, "share": share}), file=sys.stderr, flush=True)


def load(request):
    """Opens the .blend file and returns the scene. Linking the scene as a library would fail if a name in it is not UTF-8."""
    bpy.ops.wm.open_mainfile(filepath=request["library"], load_ui=False)
    scene = bpy.data.scenes[request["scene"]]
    bpy.context.window.scene = scene
    scene.lippmann.display = request["display"]
    scene.lippmann.calibration = request["calibration"]
    return scene


def take_over_painted(painted):
    """Replaces images by painted pixels that are not saved. painted: {name of the image: path of an array}."""
    for name, file in painted.items():
        old = bpy.data.images.get(name)
        if old is None:
            continue
        values = np.load(file)
        height, width, channels = values.shape
        pixels = np.ones((height, width, 4), np.float32)
        pixels[:, :, :max(channels, 3)] = values
        new = bpy.data.images.new(name, width, height, alpha=True, float_buffer=old.is_float)
        new.colorspace_settings.name, new.alpha_mode = old.colorspace_settings.name, old.alpha_mode
        new.pixels.foreach_set(pixels.ravel())
        new.pack()
        old.user_remap(new)


def readable(thing):
    try:
        return isinstance(thing.name, str)
    except UnicodeDecodeError:
        return False


def named_lists():
    """Yields all lists of things that have names. Bones come before vertex groups, because renaming a bone renames its vertex
    groups."""
    yield from (armature.bones for armature in bpy.data.armatures)
    yield from (thing.vertex_groups for thing in bpy.data.objects)
    yield from (layers for mesh in bpy.data.meshes for layers in (mesh.uv_layers, mesh.color_attributes))
    yield from (keys.key_blocks for keys in bpy.data.shape_keys)
    yield from (tree.nodes for tree in [*bpy.data.node_groups, *(material.node_tree for material in bpy.data.materials if material.node_tree)])
    yield from (getattr(bpy.data, kind.identifier) for kind in bpy.data.bl_rna.properties if kind.type == "COLLECTION")


def name_everything(report):
    """Replaces names that are not UTF-8, because Python cannot read them."""
    for things in named_lists():
        for index, thing in enumerate(things):
            if not readable(thing):
                thing.name = f"unnamed {index}"
                report.warn("Names that are no UTF-8 were replaced.")


def leave_out_missing_files(report):
    for library in bpy.data.libraries:
        if not pathlib.Path(bpy.path.abspath(library.filepath)).is_file():
            report.warn(f"The linked library {library.filepath} is missing; its objects are left out.")
    for image in bpy.data.images:
        if image.source != "FILE" or image.packed_file or not image.users or image.type != "IMAGE":
            continue
        if not pathlib.Path(bpy.path.abspath(image.filepath, library=image.library)).is_file():
            report.warn(f"The texture {image.name} ({image.filepath}) is missing; the material's own colour is shown.")
            for material in bpy.data.materials:
                for node in list(material.node_tree.nodes) if material.node_tree else []:
                    if node.type == "TEX_IMAGE" and node.image == image:
                        material.node_tree.nodes.remove(node)


def show_as_rendered(scene):
    """Gives the viewport the visibility and the level of detail of renders, because the exporter uses those of the viewport."""
    def show(layer):
        layer.hide_viewport = False
        layer.collection.hide_viewport = layer.collection.hide_render
        for child in layer.children:
            show(child)

    view = bpy.context.view_layer
    show(view.layer_collection)
    for thing in scene.objects:
        thing.hide_viewport = thing.hide_render
        if thing.name in view.objects:
            thing.hide_set(False)
        for modifier in thing.modifiers:
            modifier.show_viewport = modifier.show_render
            if modifier.type in ("SUBSURF", "MULTIRES"):
                modifier.levels = modifier.render_levels
    for particles in bpy.data.particles:
        particles.display_percentage = 100
        if particles.child_type != "NONE":
            particles.child_nbr = particles.rendered_child_count


def deforms(thing):
    keys = getattr(thing.data, "shape_keys", None)
    armature = any(modifier.type == "ARMATURE" and modifier.object for modifier in thing.modifiers)
    return thing.type == "MESH" and (armature or bool(keys and (keys.animation_data or keys.key_blocks)))


def take_out_nowhere(mesh, name, report):
    """Removes vertices with coordinates that are not finite, and their faces."""
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    nowhere = np.flatnonzero(~np.isfinite(points.reshape(-1, 3)).all(axis=1))
    if not len(nowhere):
        return
    report.warn(f"{name} has vertices whose coordinates are no numbers; the faces at them are left out.")
    shape = bmesh.new()
    shape.from_mesh(mesh)
    shape.verts.ensure_lookup_table()
    bmesh.ops.delete(shape, geom=[shape.verts[int(index)] for index in nowhere], context="VERTS")
    shape.to_mesh(mesh)
    shape.free()


def mend_figures(scene, report):
    """Removes invalid vertices of deforming meshes, which are exported unevaluated. Call before evaluating the scene."""
    for thing in scene.objects:
        if not thing.hide_render and deforms(thing):
            take_out_nowhere(thing.data, thing.name, report)


def mesh_of(instance, depsgraph, report):
    shown = instance.object
    evaluated = shown.original.evaluated_get(depsgraph)
    if shown.data.as_pointer() == evaluated.data.as_pointer():
        mesh = bpy.data.meshes.new_from_object(shown, preserve_all_data_layers=True, depsgraph=depsgraph)
    else:  # a curve or geometry nodes made this mesh; with `depsgraph`, Blender would evaluate the object again
        mesh = bpy.data.meshes.new_from_object(shown)
    take_out_nowhere(mesh, shown.original.name, report)
    if not mesh.polygons:
        return None
    for index, slot in enumerate(shown.material_slots):
        material = slot.material.original if slot.material else None
        if index < len(mesh.materials):
            mesh.materials[index] = material
        else:
            mesh.materials.append(material)
    return mesh


def shining_area(light, report):
    """Returns an emissive mesh with the shape, colour and radiance of an area light. It emits only towards -Z, as the light
    does."""
    across = light.size
    up = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else across
    if light.shape in ("SQUARE", "RECTANGLE"):
        outline = [(-0.5, -0.5), (-0.5, 0.5), (0.5, 0.5), (0.5, -0.5)]
    else:
        outline = [(0.5 * math.cos(-t * math.pi / 32), 0.5 * math.sin(-t * math.pi / 32)) for t in range(64)]
    mesh = bpy.data.meshes.new("area light")
    mesh.from_pydata([(x * across, y * up, 0.0) for x, y in outline], [], [list(range(len(outline)))])
    area = across * up * (1.0 if len(outline) == 4 else 0.25 * math.pi)
    material = bpy.data.materials.new("area light")
    material.use_nodes = True
    material.use_backface_culling = True
    shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = (0.0, 0.0, 0.0, 1.0)
    part("versions").input_of(shader, "Emission").default_value = (*light.color, 1.0)
    shader.inputs["Emission Strength"].default_value = light.energy / (4.0 * area)  # divided by 4 instead of pi, as in Cycles
    mesh.materials.append(material)
    return mesh


def sized(light):
    """Returns a copy of a light with its size as custom properties. The exporter writes them as extras, because glTF has no
    such property (docs/reference/gltf.md)."""
    light = light.copy()
    if light.type == "SUN":
        light["angle"] = light.angle
    else:
        light["radius"] = light.shadow_soft_size
    if light.type == "SPOT":
        light["blend"] = light.spot_blend
    part("ies").mark(light)
    return light


def unmet_by(instance):
    """Returns custom properties that hide an instance from the camera or from shadow rays. The exporter writes them as extras
    (docs/reference/gltf.md)."""
    things = [instance.object.original] + ([instance.parent.original] if instance.is_instance and instance.parent else [])
    is_area = things[0].type == "LIGHT" and things[0].data.type == "AREA"
    unmet = {}
    if things[0].type == "LIGHT" and not is_area:
        return unmet  # only meshes can be hidden
    if not all(thing.visible_camera for thing in things):
        unmet["visible_to_camera"] = 0
    if not all(thing.visible_shadow for thing in things) or is_area:
        unmet["casts_shadow"] = 0
    return unmet


def shape_of(instance, depsgraph, report):
    shown = instance.object
    if shown.type == "LIGHT":
        light = shown.data.original
        if light.type == "AREA":
            return shining_area(light, report)
        return sized(light)
    if shown.type in SOLID:
        return mesh_of(instance, depsgraph, report)
    if LOST.get(shown.type):
        report.warn(f"Objects that are {LOST[shown.type]} are left out.")
    return None


class Tracks:
    """The transforms of all exported instances at each frame, and their shapes at the first frame in which they are visible."""

    def __init__(self, still, report):
        self.still, self.report = still, report
        self.places, self.shapes, self.kept, self.outlines, self.unmet = {}, {}, {}, {}, {}

    def gather(self, frame):
        depsgraph = bpy.context.evaluated_depsgraph_get()
        meshes = {}  # instances share the mesh of one evaluated object
        for instance in depsgraph.object_instances:
            shown = instance.object
            original = shown.original
            if shown.hide_render or not instance.show_self or shown.type in ("EMPTY", "CAMERA", "ARMATURE", "LATTICE"):
                continue
            if shown.type in SOLID and shown.type != "MESH":
                continue  # Blender lists the mesh of a curve or text as another instance
            if not self.still and not instance.is_instance and deforms(original):
                self.kept[original.name_full] = original
                mark(original, unmet_by(instance))
                continue
            parent = instance.parent.original.name_full if instance.is_instance and instance.parent else ""
            key = (original.name_full, parent, tuple(instance.persistent_id) if instance.is_instance else ())
            if key not in self.shapes:
                data = (original.name_full, shown.data.as_pointer() if shown.data else 0)
                if data not in meshes:
                    meshes[data] = shape_of(instance, depsgraph, self.report)
                self.shapes[key] = meshes[data]
                self.unmet[key] = unmet_by(instance)
            if self.shapes[key] is not None:
                self.places.setdefault(key, {})[frame] = instance.matrix_world.copy()
                self.watch(key, shown)

    def watch(self, key, shown):
        if self.still or shown.type != "MESH":
            return
        points = np.empty(3 * len(shown.data.vertices), np.float32)
        shown.data.vertices.foreach_get("co", points)
        first = self.outlines.setdefault(key, points)
        if len(first) != len(points) or not np.allclose(first, points, atol=1e-5, equal_nan=True):
            self.report.warn(f"{key[0]} changes its shape by a modifier or a simulation; it keeps the shape of the first frame.")


def mark(thing, properties):
    for name, value in properties.items():
        thing[name] = value


def set_keys(thing, matrix, frame):
    thing.matrix_world = matrix  # also sets location, rotation and scale
    if frame is not None:
        for channel in ("location", "rotation_quaternion", "scale"):
            thing.keyframe_insert(channel, frame=frame)


def key_places(thing, places, frames, always=False):
    """Sets an object's transform in each frame. places: {frame: matrix}. In frames without a matrix, the object is scaled to
    almost nothing. An object at rest gets no keys unless `always`."""
    thing.rotation_mode = "QUATERNION"
    first = next(iter(places.values()))
    if not always and len(places) == len(frames) and all(place == first for place in places.values()):
        set_keys(thing, first, None)
        return
    before = None
    last = first
    for frame in frames:
        last = places.get(frame, last)
        set_keys(thing, last if frame in places else last @ Matrix.Scale(1e-6, 4), frame)
        if before is not None and before.dot(thing.rotation_quaternion) < 0.0:
            thing.rotation_quaternion.negate()
            thing.keyframe_insert("rotation_quaternion", frame=frame)
        before = thing.rotation_quaternion.copy()
    for curve in part("versions").curves_of(thing.animation_data):
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"


def eye_of(zone, name):
    camera = bpy.data.cameras.new(name)
    camera.sensor_fit = "VERTICAL"
    camera.lens = 0.5 * camera.sensor_height / (0.5 * zone.height / zone.distance)
    camera.clip_start, camera.clip_end = max(zone.near, 1e-6 * zone.distance), 1e3 * zone.distance
    if zone.is_beam:
        camera.type, camera.ortho_scale = "ORTHO", max(zone.height, zone.width)
    if any(zone.shift):
        camera["shift_x"], camera["shift_y"] = zone.shift  # the exporter writes them as extras (docs/reference/gltf.md)
    return bpy.data.objects.new(name, camera)


def simulates(scene):
    def moves(modifier):
        grows = modifier.type == "PARTICLE_SYSTEM" and modifier.particle_system.settings.type == "EMITTER"
        return grows or modifier.type in ("CLOTH", "SOFT_BODY", "FLUID", "DYNAMIC_PAINT")

    return bool(scene.rigidbody_world) or any(moves(modifier) for thing in scene.objects for modifier in thing.modifiers)


def play_up_to(scene, frame):
    """Runs simulations up to `frame`. Otherwise a still would show the beginning of simulations that are not baked."""
    if simulates(scene):
        for number in range(min(scene.frame_start, frame), frame):
            scene.frame_set(number)


def show(scene, frame):
    scene.frame_set(frame)
    bpy.context.view_layer.update()


def frames_of(request, is_blurred):
    """Returns the frames that get keys. One frame is added at the end, because the glTF exporter leaves out the last frame.
    With motion blur, one frame is added at the beginning, because the shutter opens before the first frame."""
    first, last = request["frames"]
    if request["still"]:
        return list(range(first, last + 1))
    return list(range(max(first - 1, 0) if is_blurred else first, last + 2))


def build_stage(scene, request, report):
    """Returns the scene to export, the frame.Zone of the first frame, whether a mesh has shape keys, and the tool's flags for
    lens and shutter."""
    frame_module, exposure = part("frame"), part("exposure")
    shutter = exposure.shutter_flags(scene, request["still"], report)
    frames = frames_of(request, bool(shutter))
    first = request["frames"][0]
    if shutter and first == 0:
        report.warn("Frame 0 is blurred by what follows it alone: glTF has no time before it.")
    tracks, eyes, lenses = Tracks(request["still"], report), {}, []
    play_up_to(scene, first)
    show(scene, first)
    distance, is_camera_s = None, scene.lippmann.output == "camera"
    if (is_camera_s or not frame_module.placed(scene)) and scene.camera and scene.camera.type == "CAMERA":
        distance = frame_module.plane_distance(scene)  # the same for all frames of an animation

    def zone_now():
        return frame_module.camera_zone(scene, request["aspect"], distance) if is_camera_s else frame_module.zone(scene, distance)

    zone = zone_now()
    for index, frame in enumerate(frames):
        begin("exporting the scene", index / len(frames))
        show(scene, frame)
        now = zone_now()
        if now.shift != zone.shift or abs(now.height / now.distance - zone.height / zone.distance) > 1e-6:
            report.warn("The camera's lens or shift changes; it stays as in the first frame.")
        eyes[frame] = now.world_from_frame @ Matrix.Translation((0.0, 0.0, zone.distance))
        if frame >= first:
            lenses.append(exposure.lens(scene, now))
        tracks.gather(frame)
    stage = bpy.data.scenes.new("stage")
    render = stage.render
    render.fps, render.fps_base = scene.render.fps, scene.render.fps_base
    render.resolution_x, render.resolution_y = max(1, round(1e4 * zone.width / zone.height)), 10000
    stage.frame_start, stage.frame_end = (0, 0) if request["still"] else (frames[0], frames[-1])
    for key, places in tracks.places.items():
        thing = bpy.data.objects.new(key[0], tracks.shapes[key])
        mark(thing, tracks.unmet[key])
        stage.collection.objects.link(thing)
        key_places(thing, places, frames)
    eye = eye_of(zone, EYE)
    stage.collection.objects.link(eye)
    key_places(eye, eyes, frames, always=not request["still"])  # otherwise an animation without motion would have no length
    keep_deforming(stage, tracks.kept.values())
    if not tracks.places and not tracks.kept:
        raise RuntimeError("The scene shows nothing that could be rendered: it has no visible mesh, curve, text or light.")
    blur = exposure.lens_flags(lenses, report) + shutter
    return stage, zone, any(getattr(thing.data, "shape_keys", None) for thing in tracks.kept.values()), blur


def lose_shape(thing):
    """Removes the shape of a parent, which is exported only for its transform."""
    if thing.type == "MESH":
        thing.data = bpy.data.meshes.new("place")
        return
    thing.data = thing.data.copy()
    if thing.type == "FONT":
        thing.data.body = " "
    else:
        (thing.data.elements if thing.type == "META" else thing.data.splines).clear()


def keep_deforming(stage, things):
    def link(thing):
        if thing.name not in stage.collection.objects:
            stage.collection.objects.link(thing)

    for thing in things:
        link(thing)
        above = [modifier.object for modifier in thing.modifiers if modifier.type == "ARMATURE"] + [thing.parent]
        while above:
            other = above.pop()
            if other is None:
                continue
            if other.type in SOLID and not deforms(other):
                lose_shape(other)
            link(other)
            above.append(other.parent)


def gltf_options(still, has_shape_keys, known):
    options = {"export_format": "GLB", "export_cameras": True, "export_lights": True, "export_apply": not has_shape_keys, "export_yup": True,
               "export_animations": not still, "export_frame_range": True, "export_force_sampling": True, "export_nla_strips": False,
               "export_animation_mode": "ACTIVE_ACTIONS", "export_anim_slide_to_zero": False, "export_morph": True, "export_skins": True,
               "export_extras": True, "use_selection": False, "use_active_scene": True, "export_optimize_animation_size": False}
    return {name: value for name, value in options.items() if name in known}


def export_gltf(stage, path, still, has_shape_keys):
    bpy.context.window.scene = stage
    stage.frame_set(stage.frame_start)
    bpy.context.view_layer.update()  # otherwise new objects are at the origin
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
    bpy.ops.export_scene.gltf(filepath=path, **gltf_options(still, has_shape_keys, known))


def plain_world(world):
    if world is None:
        return (0.0, 0.0, 0.0)
    if not world.use_nodes:
        return tuple(world.color)
    output = next((node for node in world.node_tree.nodes if node.type == "OUTPUT_WORLD" and node.is_active_output), None)
    if output is None or not output.inputs["Surface"].is_linked:
        return (0.0, 0.0, 0.0)
    shader = output.inputs["Surface"].links[0].from_node
    if shader.type != "BACKGROUND" or any(socket.is_linked for socket in shader.inputs):
        return None
    return tuple(shader.inputs["Strength"].default_value * channel for channel in shader.inputs["Color"].default_value[:3])


def write_panorama(world, path):
    """Renders the world as a panorama by Cycles, which supports all nodes of a world."""
    sky = bpy.data.scenes.new("sky")
    sky.world = world
    sky.render.engine = "CYCLES"
    sky.cycles.samples = 4
    sky.cycles.use_denoising = False
    sky.render.resolution_x, sky.render.resolution_y = 2048, 1024
    sky.view_settings.view_transform = "Raw"
    sky.render.image_settings.file_format = "OPEN_EXR"
    sky.render.image_settings.color_depth = "32"
    camera = bpy.data.cameras.new("sky")
    part("versions").make_panorama(camera)
    # The camera looks along +X, the direction in the middle of a panorama.
    eye = bpy.data.objects.new("sky", camera)
    eye.rotation_euler = (math.pi / 2, 0.0, -math.pi / 2)
    sky.collection.objects.link(eye)
    sky.camera = eye
    sky.render.filepath = path
    bpy.ops.render.render(write_still=True, scene=sky.name)


def main():
    request = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    sys.path.insert(0, str(HERE.parent))
    addon = importlib.import_module(HERE.name)
    addon.register()
    report = Report()
    scene = load(request)
    take_over_painted(request["painted"])
    name_everything(report)
    leave_out_missing_files(report)
    show_as_rendered(scene)
    mend_figures(scene, report)
    part("materials").simplify_all(bpy.data.materials, report)
    stage, zone, has_shape_keys, blur = build_stage(scene, request, report)
    baking = part("baking")
    kept = baking.Kept(pathlib.Path(request["baked"]), request["materials"])
    baked = baking.bake(stage, request["bake_size"], report, kept, begin) if request["bake_size"] else {}
    if request["bake_size"]:
        kept.remove_others()
    part("materials").fill_empty_slots(stage.objects, report)  # after baking, which needs to know each material of a mesh
    part("losses").say(scene, request["still"], baked, report)
    begin("writing the scene")
    export_gltf(stage, request["glb"], request["still"], has_shape_keys)
    part("glb").rewrite(request["glb"], (part("ies").move_profiles, part("materials").take_gloss_away))
    colour = plain_world(scene.world)
    if colour is None:
        begin("rendering the surroundings")
        write_panorama(scene.world, request["world"])
    environment = request["world"] if colour is None else "none" if not any(colour) else ",".join(f"{channel:.7g}" for channel in colour)
    if bpy.app.autoexec_fail:
        report.warn("Drivers in Python did not run; start Blender with --enable-autoexec, or allow them in its preferences.")
    told = {"warnings": report.warnings, "environment": environment, "distance": zone.distance, "eye": EYE, "blur": blur, "parallel_mm": PARALLEL * zone.height / zone.per_mm if zone.is_beam else 0.0}
    pathlib.Path(request["report"]).write_text(json.dumps(told))


if __name__ == "__main__":
    try:
        main()
    except Exception as error:  # the user's Blender shows this line and logs the traceback
        print(f"error: {error}", file=sys.stderr)
        raise
