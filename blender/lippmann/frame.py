"""The light-field frame: an empty whose XY plane is the display's, its +Z towards the viewer. Where it stands, and what is sharp there.

Depths follow docs/displays.md: a display of height H mm that is h units high in the scene has H / h mm per unit, its viewer at the viewing distance D, and
resolves depth within the budget b on either side; both are figures of `lippmann displays --json`.
"""

import math
from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector

from . import displays, tool


@dataclass
class Zone:
    """Where a display stands: a rigid transform to world space, and lengths in the scene's units."""

    world_from_frame: Matrix
    width: float
    height: float
    distance: float    # from the plane to the viewer
    budget: float      # sharp this far in front and behind
    cone: float        # full angle of the viewing zone
    per_mm: float      # of a millimetre of the display


def rigid(matrix):
    """The transform without its scale, and how much it scales heights by."""
    place, turn, scale = matrix.decompose()
    return Matrix.Translation(place) @ turn.to_matrix().to_4x4(), abs(scale.y)


def focus_distance(camera):
    """From the camera to what it is focused on, along its view."""
    focused = camera.data.dof
    if focused.focus_object:
        towards = camera.matrix_world.inverted() @ focused.focus_object.matrix_world.translation
        return max(-towards.z, 1e-4)
    return max(focused.focus_distance, 1e-4)


def fitted_side(camera, distance):
    """How long the side that the camera's sensor is fitted to is in what it frames at a distance. Other cameras than perspective ones: at any."""
    data = camera.data
    if data.type != "PERSP":
        return data.ortho_scale
    return distance * (data.sensor_height if data.sensor_fit == "VERTICAL" else data.sensor_width) / data.lens


def at_focus(camera, aspect):
    """The transform and the height of what the camera frames at its focus, in pictures of this aspect (width over height). A shift moves the
    frame aside: the display's viewer stands before its middle, not where the camera is."""
    data, distance = camera.data, focus_distance(camera)
    side = fitted_side(camera, distance)
    is_height = data.sensor_fit == "VERTICAL" or (data.sensor_fit == "AUTO" and aspect < 1.0)
    turned, _ = rigid(camera.matrix_world)
    return turned @ Matrix.Translation((data.shift_x * side, data.shift_y * side, -distance)), side if is_height else side / aspect


def zone(scene):
    """The zone of the scene's frame or, without one, of its camera's focus. Raises ToolError."""
    display = displays.chosen(scene)
    aspect = displays.aspect(display)
    placed = scene.lippmann.frame
    if placed and scene in placed.users_scene:
        matrix, scale = rigid(placed.matrix_world)
        height = placed.lippmann.height * scale
    elif scene.camera and scene.camera.type == "CAMERA":
        matrix, height = at_focus(scene.camera, aspect)
    else:
        raise tool.ToolError("The scene has neither a light-field frame nor a camera. Add one of them.")
    if not height > 1e-9:
        raise tool.ToolError("The light-field frame has no size. Scale it up, or set its height.")
    per_mm = height / display["size_mm"][1]
    return Zone(matrix, height * aspect, height, display["viewing_distance_mm"] * per_mm, display["depth_budget_mm"] * per_mm,
                math.radians(display["view_cone_deg"]), per_mm)


def add(context):
    """A new frame in the scene, which becomes the scene's."""
    empty = bpy.data.objects.new("Light-field frame", None)
    empty.empty_display_type = "ARROWS"
    empty.empty_display_size = 0.1
    empty.rotation_mode = "QUATERNION"
    empty.lippmann.is_frame = True
    context.scene.collection.objects.link(empty)
    context.scene.lippmann.frame = empty
    return empty


def place(empty, matrix, height):
    empty.matrix_world = matrix
    empty.lippmann.height = height


def around(objects):
    """The middle and the largest extent of objects, in world space."""
    corners = [thing.matrix_world @ Vector(corner) for thing in objects for corner in (thing.bound_box if thing.type != "EMPTY" else [(0, 0, 0)])]
    lower = Vector(min(corner[axis] for corner in corners) for axis in range(3))
    upper = Vector(max(corner[axis] for corner in corners) for axis in range(3))
    return 0.5 * (lower + upper), max(upper - lower)


def place_at_objects(empty, objects, camera):
    """Through the middle of the objects, facing the camera where there is one, else along -Y; as high as they are large, with a margin."""
    middle, extent = around(objects)
    turn = camera.matrix_world.to_quaternion() if camera else Matrix.Rotation(math.pi / 2, 4, "X").to_quaternion()
    place(empty, Matrix.Translation(middle) @ turn.to_matrix().to_4x4(), max(1.2 * extent, 1e-3))
