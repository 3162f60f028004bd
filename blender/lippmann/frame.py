"""The placement of the display in a Blender scene.

A light-field frame is an empty whose XY plane is the display and whose +Z axis points to the viewer. Without a frame, the display
stands in front of the scene's camera: at the focus distance if the camera has depth of field, else amid the objects that it sees.

A display H mm high that is h units high in the scene has H / h mm per unit.
"""

import math
from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector

from . import displays, tool

LINES = 9          # sight_lines() casts LINES x LINES rays through the picture
MOST_HIDDEN = 16   # a ray passes through at most this many objects that are hidden in renders
CAMERA_WIDTH_MM = 64.0  # picture width for renders without a display, as in the tool
UNFOCUSED = 10.0   # distance of the plane, in scene units, if the camera sees nothing; Blender's default focus distance
_seen = {}         # cache of plane_distance() with at most one entry; cleared when the scene changes


@dataclass
class Zone:
    """Placement of a display. Lengths are in scene units."""

    world_from_frame: Matrix  # rigid transform
    width: float
    height: float
    distance: float    # from the plane to the viewer
    budget: float      # depth that is sharp on each side of the plane
    cone: float        # full angle of the viewing zone, in radians
    per_mm: float      # Blender's units per millimetre of the display
    near: float = 0.0  # walls nearer to the viewer than this may be cut; 0: none are cut
    shift: tuple = (0.0, 0.0)  # shift of the picture to the right and up, divided by its height
    is_beam: bool = False      # whether the viewer is an orthographic camera


def rigid(matrix):
    """Returns the transform without its scale, and the scale of its y axis."""
    place, turn, scale = matrix.decompose()
    return Matrix.Translation(place) @ turn.to_matrix().to_4x4(), abs(scale.y)


def placed(scene):
    thing = scene.lippmann.frame
    return thing if thing and scene in thing.users_scene else None


def is_focused(camera):
    """Returns whether the user has set the camera's focus. Otherwise the focus distance is Blender's default."""
    return camera.data.dof.use_dof or camera.data.dof.focus_object is not None


def focus_distance(camera):
    focused = camera.data.dof
    if focused.focus_object:
        towards = camera.matrix_world.inverted() @ focused.focus_object.matrix_world.translation
        return max(-towards.z, 1e-4)
    return max(focused.focus_distance, 1e-4)


def fitted_side(camera, distance):
    """Blender fits the sensor to one side of the picture. Returns the length of this side at a distance from the camera."""
    data = camera.data
    if data.type != "PERSP":
        return data.ortho_scale
    return distance * (data.sensor_height if data.sensor_fit == "VERTICAL" else data.sensor_width) / data.lens


def framed(camera, aspect, distance):
    """Returns the transform and the height of the rectangle that fills the camera's picture at a distance. aspect: width /
    height of the picture. A lens shift moves the rectangle sideways."""
    data = camera.data
    side = fitted_side(camera, distance)
    is_height = data.sensor_fit == "VERTICAL" or (data.sensor_fit == "AUTO" and aspect < 1.0)
    turned, _ = rigid(camera.matrix_world)
    return turned @ Matrix.Translation((data.shift_x * side, data.shift_y * side, -distance)), side if is_height else side / aspect


def camera_zone(scene, aspect, distance):
    """Returns the Zone of a display whose viewer is the scene's camera. aspect: width / height of the picture. distance: from
    the camera to the display's plane. Raises ToolError."""
    camera = scene.camera
    if not camera or camera.type != "CAMERA":
        raise tool.ToolError("The scene has no camera. Add one, or choose another output.")
    data = camera.data
    turned, _ = rigid(camera.matrix_world)
    _, height = framed(camera, aspect, distance)
    shift = tuple(amount * fitted_side(camera, distance) / height for amount in (data.shift_x, data.shift_y))
    return Zone(turned @ Matrix.Translation((0.0, 0.0, -distance)), height * aspect, height, distance, math.inf, 0.0, height * aspect / CAMERA_WIDTH_MM, data.clip_start, shift,
                data.type != "PERSP")


def near_of_viewer(camera, world_from_frame, distance):
    """Returns the distance from the display's viewer to the camera's near clipping plane. Returns 0 unless the camera is
    between the viewer and the display, and looks at the display."""
    if not camera or camera.type != "CAMERA":
        return 0.0
    to_frame = world_from_frame.inverted() @ rigid(camera.matrix_world)[0]
    away = to_frame.translation.z
    is_before = 0.0 < away - camera.data.clip_start and away < distance
    looks_at_it = -(to_frame.to_3x3() @ Vector((0.0, 0.0, -1.0))).z > 0.5
    return distance - away + camera.data.clip_start if is_before and looks_at_it else 0.0


def sight_lines(camera, aspect):
    """Yields evenly spread rays through the camera's picture: (start, direction, weight) in world space. The weight falls from
    1 in the middle to 0 at the border."""
    middle, height = framed(camera, aspect, 1.0)
    away = middle.to_3x3() @ Vector((0.0, 0.0, -1.0))
    steps = [(i + 0.5) / LINES - 0.5 for i in range(LINES)]
    for x in steps:
        for y in steps:
            target = middle @ Vector((x * height * aspect, y * height, 0.0))
            start = camera.matrix_world.translation if camera.data.type == "PERSP" else target - away
            yield start, (target - start).normalized(), (1.0 - 2.0 * abs(x)) * (1.0 - 2.0 * abs(y))


def median(weighted):
    weighted = sorted(weighted)
    left = 0.5 * sum(weight for _, weight in weighted)
    for value, weight in weighted:
        left -= weight
        if left <= 0.0:
            return value


def first_met(scene, depsgraph, start, direction):
    """Returns the point where a ray hits the first object that is visible in renders, or None. Gives up after MOST_HIDDEN
    hidden objects."""
    for _ in range(MOST_HIDDEN):
        is_met, place, _, _, thing, _ = scene.ray_cast(depsgraph, start, direction)
        if not is_met or not thing.hide_render:
            return place if is_met else None
        start = place + 1e-4 * max(1.0, (place - start).length) * direction
    return None


def seen_distance(scene, aspect):
    """Returns the median depth of the points that the camera sees, with more weight in the middle. Returns the focus distance
    if it sees nothing."""
    camera, depsgraph = scene.camera, bpy.context.evaluated_depsgraph_get()
    to_camera = rigid(camera.matrix_world)[0].inverted()
    seen = []
    for start, direction, weight in sight_lines(camera, aspect):
        place = first_met(scene, depsgraph, start, direction)
        if place is not None:
            seen.append((-(to_camera @ place).z, weight))
    if seen:
        return max(median(seen), 1e-4)
    return focus_distance(camera) if focus_distance(camera) > camera.data.clip_start else UNFOCUSED


@bpy.app.handlers.persistent
def forget_what_is_seen(*_):
    _seen.clear()


HANDLERS = ("depsgraph_update_post", "load_post", "undo_post", "redo_post")


def register():
    for name in HANDLERS:
        getattr(bpy.app.handlers, name).append(forget_what_is_seen)


def unregister():
    for name in HANDLERS:
        getattr(bpy.app.handlers, name).remove(forget_what_is_seen)


def plane_distance(scene):
    """Returns the distance from the camera to the display's plane: the focus distance if the user has set it, else
    seen_distance(). Raises ToolError."""
    camera = scene.camera
    if is_focused(camera):
        return focus_distance(camera)
    aspect = displays.aspect(displays.chosen(scene))
    key = (scene.name, scene.frame_current, camera.name, aspect, *(number for row in camera.matrix_world for number in row))
    if key not in _seen:
        _seen.clear()
        _seen[key] = seen_distance(scene, aspect)
    return _seen[key]


def zone(scene, distance=None):
    """Returns the Zone of the display, at the light-field frame or in front of the camera. Raises ToolError.

    distance: from the camera to the plane, if neither a frame nor the focus determines it. None: plane_distance(), which casts
    rays and must not run in a render's thread.
    """
    display = displays.chosen(scene)
    aspect = displays.aspect(display)
    thing = placed(scene)
    if thing:
        matrix, scale = rigid(thing.matrix_world)
        height = thing.lippmann.height * scale
    elif scene.camera and scene.camera.type == "CAMERA":
        matrix, height = framed(scene.camera, aspect, distance if distance and not is_focused(scene.camera) else plane_distance(scene))
    else:
        raise tool.ToolError("The scene has neither a light-field frame nor a camera. Add one of them.")
    if not height > 1e-9:
        raise tool.ToolError("The light-field frame has no size. Scale it up, or set its height.")
    per_mm = height / display["size_mm"][1]
    distance_to_viewer = display["viewing_distance_mm"] * per_mm
    return Zone(matrix, height * aspect, height, distance_to_viewer, display["depth_budget_mm"] * per_mm, math.radians(display["view_cone_deg"]), per_mm,
                near_of_viewer(scene.camera, matrix, distance_to_viewer))


def add(context):
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
    corners = [thing.matrix_world @ Vector(corner) for thing in objects for corner in (thing.bound_box if thing.type != "EMPTY" else [(0, 0, 0)])]
    lower = Vector(min(corner[axis] for corner in corners) for axis in range(3))
    upper = Vector(max(corner[axis] for corner in corners) for axis in range(3))
    return 0.5 * (lower + upper), max(upper - lower)


def place_at_objects(empty, objects, camera):
    """Centres the light-field frame on the objects. The frame faces the camera or, without a camera, -Y. The frame's
    height is 1.2 times the longest side of the objects."""
    middle, extent = around(objects)
    turn = camera.matrix_world.to_quaternion() if camera else Matrix.Rotation(math.pi / 2, 4, "X").to_quaternion()
    place(empty, Matrix.Translation(middle) @ turn.to_matrix().to_4x4(), max(1.2 * extent, 1e-3))
