"""Draws the display into the viewport: its plane, the range of sharp depth, and the viewing zone."""

import math

import bpy
import gpu
from gpu_extras.batch import batch_for_shader

from . import frame, tool, versions

PLANE = (0.15, 0.75, 1.0, 1.0)
SHARP = (0.2, 0.9, 0.35, 0.9)
SHARP_FILL = (0.2, 0.9, 0.35, 0.10)
ZONE = (1.0, 0.7, 0.1, 0.8)

_handle = None


def rectangle(zone, z):
    """Returns the corners of the rectangle at depth z that the viewer sees through the display."""
    grow = 1.0 - z / zone.distance
    return [(sx * 0.5 * zone.width * grow, sy * 0.5 * zone.height * grow, z) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def loop(corners):
    return [corner for i in range(len(corners)) for corner in (corners[i], corners[(i + 1) % len(corners)])]


def figures(zone):
    front, back = min(zone.budget, 0.9 * zone.distance), -zone.budget
    near, far = rectangle(zone, front), rectangle(zone, back)
    eye = (0.0, 0.0, zone.distance)
    reach = zone.distance
    half = math.tan(0.5 * zone.cone) * reach
    ends = [(-half, 0.0, reach), (half, 0.0, reach)]
    sides = [corner for pair in zip(near, far) for corner in pair]
    fill = [corner for r in (near, far) for corner in (r[0], r[1], r[2], r[0], r[2], r[3])]
    return [("TRIS", fill, SHARP_FILL), ("LINES", loop(near) + loop(far) + sides, SHARP), ("LINES", loop(rectangle(zone, 0.0)), PLANE),
            ("LINES", [(0, 0, 0), ends[0], (0, 0, 0), ends[1], ends[0], eye, eye, ends[1]], ZONE)]


def draw():
    scene = bpy.context.scene
    if scene.render.engine != "LIPPMANN" or not scene.lippmann.show_overlay or not bpy.context.space_data.overlay.show_overlays:
        return
    try:
        zone = frame.zone(scene)
    except tool.ToolError:
        return  # the panel shows the error
    shader = versions.plain_shader()
    gpu.state.blend_set("ALPHA")
    with gpu.matrix.push_pop():
        gpu.matrix.multiply_matrix(zone.world_from_frame)
        for kind, corners, colour in figures(zone):
            gpu.state.depth_test_set("LESS_EQUAL" if kind == "TRIS" else "NONE")
            gpu.state.depth_mask_set(False)
            gpu.state.line_width_set(2.0)
            shader.bind()
            shader.uniform_float("color", colour)
            batch_for_shader(shader, kind, {"pos": corners}).draw(shader)
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")
    gpu.state.line_width_set(1.0)


def register():
    global _handle
    if not bpy.app.background:
        _handle = bpy.types.SpaceView3D.draw_handler_add(draw, (), "WINDOW", "POST_VIEW")


def unregister():
    global _handle
    if _handle:
        bpy.types.SpaceView3D.draw_handler_remove(_handle, "WINDOW")
        _handle = None
