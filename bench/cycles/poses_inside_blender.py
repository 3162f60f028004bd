"""Runs inside Blender. Compares the vertices of skinned or morphed meshes posed by Blender with
those of dump_pose.

  blender -b --python-exit-code 1 -P poses_inside_blender.py -- FILE DUMP_POSE TIMES

The importer may split and drop vertices, so poses are compared as sets of points: the error is
the largest distance from a point of one set to the nearest point of the other set, as a fraction
of the diagonal of the bounds. Prints a line "POSES {json}" for each animation.

Between keys, Blender interpolates the components of a rotation separately instead of along the
arc, so keys are added at the compared times. Blender's importer drops the tangents of cubic
splines, so such animations are left out.
"""

import json
import subprocess
import sys

import bpy
import mathutils
import numpy as np
from io_scene_gltf2.blender.imp.gltf2_blender_animation import BlenderAnimation

np.bool = bool  # the importer of Blender 3.4 uses this name, which some versions of numpy do not have

file, dump_pose, count = sys.argv[sys.argv.index("--") + 1:]


def load(index):
    """Loads a new scene that plays one animation. Returns the names, the lengths in seconds and the interpolations of
    all animations."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    animations = []
    restore = BlenderAnimation.restore_animation

    # Without this, the importer would apply the first animation, which may change values that animation `index` does not set.
    def restore_ours(gltf, _):
        for animation in gltf.data.animations:
            ends = [gltf.data.accessors[animation.samplers[channel.sampler].input].max[0] for channel in animation.channels]
            animations.append((animation.track_name, max(ends), {sampler.interpolation for sampler in animation.samplers}))
        restore(gltf, animations[index][0])

    BlenderAnimation.restore_animation = restore_ours
    try:
        bpy.ops.import_scene.gltf(filepath=file)
    finally:
        BlenderAnimation.restore_animation = restore
    for keys in bpy.data.shape_keys:
        for block in keys.key_blocks:  # Blender limits weights to the range of their sliders, but glTF has no limits
            block.slider_min, block.slider_max = -10.0, 10.0
    return animations


def frame_of(seconds):
    return seconds * bpy.context.scene.render.fps


def slerp_rotations(times):
    """Adds keys at `times` to all rotations with linear interpolation."""
    for action in {thing.animation_data.action for thing in bpy.data.objects if thing.animation_data} - {None}:
        for path in {curve.data_path for curve in action.fcurves if curve.data_path.endswith("rotation_quaternion")}:
            curves = [action.fcurves.find(path, index=i) for i in range(4)]
            if curves[0].keyframe_points[0].interpolation == "LINEAR":
                slerp_rotation(curves, [frame_of(t) for t in times])


def slerp_rotation(curves, frames):
    keys = np.array([[key.co for key in curve.keyframe_points] for curve in curves])
    for frame in frames:
        after = int(np.searchsorted(keys[0, :, 0], frame))
        if after in (0, keys.shape[1]) or np.abs(keys[0, :, 0] - frame).min() < 0.02:  # Blender merges nearer keys
            continue
        start, end = keys[0, after - 1:after + 1, 0]
        turns = [mathutils.Quaternion(keys[:, k, 1]) for k in (after - 1, after)]
        for curve, value in zip(curves, turns[0].slerp(turns[1], (frame - start) / (end - start))):
            curve.keyframe_points.insert(frame, value).interpolation = "LINEAR"


def pose_by_blender(seconds):
    """Returns the vertices in world space, with y upwards."""
    scene = bpy.context.scene
    frame = frame_of(seconds)
    scene.frame_set(int(frame), subframe=frame - int(frame))
    graph = bpy.context.evaluated_depsgraph_get()
    points = [np.zeros((0, 3))]
    for thing in scene.objects:
        if thing.type != "MESH" or not (thing.data.shape_keys or any(m.type == "ARMATURE" for m in thing.modifiers)):
            continue
        posed = thing.evaluated_get(graph)
        mesh = posed.to_mesh()
        flat = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", flat)
        world = np.array(posed.matrix_world)
        points.append(flat.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3])
        posed.to_mesh_clear()
    x, y, z = np.concatenate(points).T
    return np.stack([x, z, -y], axis=1)


def poses_by_lippmann(index, times):
    done = subprocess.run([dump_pose, file, str(index), *map(repr, times)], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    points = np.array([line.split()[3:] for line in done.stdout.splitlines()], float).reshape(len(times), -1, 3)
    return list(points)


def reach(points, others):
    tree = mathutils.kdtree.KDTree(len(others))
    for i, point in enumerate(others):
        tree.insert(point, i)
    tree.balance()
    return max(tree.find(point)[2] for point in points)


def errors(ours, theirs, diagonal):
    return [max(reach(a, b), reach(b, a)) / diagonal for a, b in zip(ours, theirs)]


def measure(index, name, end):
    # These times avoid the keys. At a key, rounding would decide which of two values a step interpolation has.
    times = [end * (k + 0.618034) / int(count) for k in range(int(count))]
    unchanged = [pose_by_blender(t) for t in times]
    slerp_rotations(times)
    theirs = [pose_by_blender(t) for t in times]
    ours = poses_by_lippmann(index, times)
    if not len(theirs[0]) or not len(ours[0]):
        raise SystemExit(f"{file}: no skinned or morphing meshes: {len(ours[0])} vertices here, {len(theirs[0])} in Blender")
    everything = np.concatenate(theirs)
    diagonal = np.linalg.norm(everything.max(0) - everything.min(0))
    error = errors(ours, theirs, diagonal)
    row = {"animation": name, "seconds": end, "times": len(times), "vertices": len(ours[0]), "blender_vertices": len(theirs[0]),
           "moved": np.abs(np.stack(theirs) - theirs[0]).max() / diagonal, "error": max(error),
           "at_seconds": times[int(np.argmax(error))], "error_without_slerp": max(errors(ours, unchanged, diagonal))}
    print("POSES", json.dumps(row), flush=True)


animations = load(0)
if not animations:
    raise SystemExit(f"{file}: no animations")
for index, (name, end, interpolations) in enumerate(animations):
    if "CUBICSPLINE" in interpolations:
        print("POSES", json.dumps({"animation": name, "skipped": "cubic splines, whose tangents Blender's importer drops"}), flush=True)
        continue
    load(index)
    measure(index, name, end)
