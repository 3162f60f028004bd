"""Converts a scene from USD, Alembic, FBX, Collada or STL to .glb, which the tool can render.

  blender -b --factory-startup --python to_glb.py -- SCENE.usdz SCENE.glb

Converts meshes, materials, lamps, cameras, armatures, shape keys and animations, as far as Blender imports and exports them. On
failure, prints one line and exits with code 1.
"""

import os
import pathlib
import sys

import bpy

# Maps file endings to Blender's import operators (module, name). The first operator that this version of Blender has is used.
USD, STL = [("wm", "usd_import")], [("wm", "stl_import"), ("import_mesh", "stl")]
IMPORTERS = {".usd": USD, ".usda": USD, ".usdc": USD, ".usdz": USD, ".abc": [("wm", "alembic_import")], ".fbx": [("import_scene", "fbx")], ".dae": [("wm", "collada_import")], ".stl": STL}


def fail(words):
    words = words.replace("Error: ", "")
    print(f"to_glb: {words}", file=sys.stderr, flush=True)
    sys.exit(1)


def operator_of(names):
    for group, name in names:
        operator = getattr(getattr(bpy.ops, group), name)
        try:
            operator.get_rna_type()
        except (KeyError, RuntimeError):
            continue
        return operator
    return None


def read_into_blender(source):
    names = IMPORTERS.get(source.suffix.lower())
    if not names:
        fail(f"{source}: is not a format that this reads; accepted: {' '.join(IMPORTERS)}")
    if not source.is_file():
        fail(f"{source}: there is no such file")
    importer = operator_of(names)
    if not importer:
        fail(f"{source}: this Blender ({bpy.app.version_string}) was built without an importer of {source.suffix}, as those of Debian are of USD and Alembic; accepted: one from blender.org, named in place of blender")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.preferences.filepaths.use_scripts_auto_execute = False
    try:
        done = importer(filepath=str(source))
    except RuntimeError as error:
        fail(f"{source}: {str(error).strip()}")
    if "FINISHED" not in done or not bpy.data.objects:
        fail(f"{source}: holds nothing that Blender has read")


def cover_animations(scene):
    """Sets the scene's frame range to cover all animations, because some importers do not set it."""
    ranges = [action.frame_range for action in bpy.data.actions]
    if ranges:
        scene.frame_start, scene.frame_end = int(min(r[0] for r in ranges)), int(-(-max(r[1] for r in ranges) // 1))


def write_glb(target):
    """Exports the scene. A failure leaves no incomplete file."""
    part = target.with_name(f"{target.stem}.part.glb")
    has_shape_keys = any(mesh.shape_keys for mesh in bpy.data.meshes)
    try:
        bpy.ops.export_scene.gltf(filepath=str(part), export_format="GLB", export_cameras=True, export_lights=True, export_apply=not has_shape_keys, export_frame_range=True)
        os.replace(part, target)
    except (RuntimeError, OSError) as error:
        part.unlink(missing_ok=True)
        fail(f"{target}: {str(error).strip()}")


def main():
    words = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(words) != 2 or not words[1].lower().endswith(".glb"):
        fail("needs two paths after `--`: SCENE FILE.glb")
    source, target = (pathlib.Path(word).absolute() for word in words)
    read_into_blender(source)
    cover_animations(bpy.context.scene)
    write_glb(target)
    print(f"to_glb: {target}: {len(bpy.data.objects)} objects; next: lippmann render {target}")


main()
