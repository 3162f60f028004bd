"""The light-field frame: an empty whose XY plane is the display's, its +Z towards the viewer. Where it stands, and what is sharp there.

Without one the display stands before the scene's camera: at its focus where it has depth of field, else amid what it sees.
Depths follow docs/guide/displays.md: a display of height H mm that is h units high in the scene has H / h mm per unit, its viewer at the viewing distance D, and
resolves depth within the budget b on either side; both are figures of `lippmann displays --json`.
"""

import math
from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector

from . import displays, tool

LINES = 9          # of sight, across and up
MOST_HIDDEN = 16   # things that a line passes
CAMERA_WIDTH_MM = 64.0  # width that the tool gives a picture without a display
UNFOCUSED = 10.0   # units to the plane where a camera sees nothing: Blender's own focus
_seen = {}         # what was asked last, since the scene has changed


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
    near: float = 0.0  # from the viewer to the camera's near clipping plane; walls before it are cut; 0: none
    shift: tuple = (0.0, 0.0)  # of the picture, to the right and up, in heights of it
    is_beam: bool = False      # the viewer is an orthographic camera


def rigid(matrix):
    """The transform without its scale, and how much it scales heights by."""
    place, turn, scale = matrix.decompose()
    return Matrix.Translation(place) @ turn.to_matrix().to_4x4(), abs(scale.y)


def placed(scene):
    """The scene's frame; None: there is none, or it has been taken out of the scene."""
    thing = scene.lippmann.frame
    return thing if thing and scene in thing.users_scene else None


def is_focused(camera):
    """Whether its focus is something that somebody chose: without depth of field it is what Blender's version began with, 0 or 10 units."""
    return camera.data.dof.use_dof or camera.data.dof.focus_object is not None


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


def framed(camera, aspect, distance):
    """The transform and the height of what the camera frames at a distance, in pictures of this aspect (width over height). A shift moves the
    frame aside: the display's viewer stands before its middle, not where the camera is."""
    data = camera.data
    side = fitted_side(camera, distance)
    is_height = data.sensor_fit == "VERTICAL" or (data.sensor_fit == "AUTO" and aspect < 1.0)
    turned, _ = rigid(camera.matrix_world)
    return turned @ Matrix.Translation((data.shift_x * side, data.shift_y * side, -distance)), side if is_height else side / aspect


def camera_zone(scene, aspect, distance):
    """Returns the zone whose viewer is the scene's camera itself. aspect: of the picture. distance: from the camera to the plane. Raises ToolError."""
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
    """Returns the distance from a display's viewer to the camera's near clipping plane, if the camera stands between the viewer and the display and looks
    at the display; else 0. Walls within this distance are cut if they hide the scene."""
    if not camera or camera.type != "CAMERA":
        return 0.0
    to_frame = world_from_frame.inverted() @ rigid(camera.matrix_world)[0]
    away = to_frame.translation.z
    is_before = 0.0 < away - camera.data.clip_start and away < distance
    looks_at_it = -(to_frame.to_3x3() @ Vector((0.0, 0.0, -1.0))).z > 0.5
    return distance - away + camera.data.clip_start if is_before and looks_at_it else 0.0


def sight_lines(camera, aspect):
    """Rays through what the camera frames, evenly spread: start and direction in world space, and how near to the middle, 1 to 0."""
    middle, height = framed(camera, aspect, 1.0)
    away = middle.to_3x3() @ Vector((0.0, 0.0, -1.0))
    steps = [(i + 0.5) / LINES - 0.5 for i in range(LINES)]
    for x in steps:
        for y in steps:
            target = middle @ Vector((x * height * aspect, y * height, 0.0))
            start = camera.matrix_world.translation if camera.data.type == "PERSP" else target - away
            yield start, (target - start).normalized(), (1.0 - 2.0 * abs(x)) * (1.0 - 2.0 * abs(y))


def median(weighted):
    """The value that half of the weight lies below; of pairs of a value and its weight."""
    weighted = sorted(weighted)
    left = 0.5 * sum(weight for _, weight in weighted)
    for value, weight in weighted:
        left -= weight
        if left <= 0.0:
            return value


def first_met(scene, depsgraph, start, direction):
    """Where a ray meets something that renders show; None where it meets nothing, or passes many things that they do not."""
    for _ in range(MOST_HIDDEN):
        is_met, place, _, _, thing, _ = scene.ray_cast(depsgraph, start, direction)
        if not is_met or not thing.hide_render:
            return place if is_met else None
        start = place + 1e-4 * max(1.0, (place - start).length) * direction
    return None


def seen_distance(scene, aspect):
    """From the camera to what it sees, along its view: of half of it, the middle of the picture counting most. Where nothing is seen, its focus."""
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
    """From the camera to the display's plane where no frame is set: its focus, or what it sees now. Raises ToolError."""
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
    """The zone of the scene's frame or, without one, of a plane before its camera. distance: from the camera to that plane, where it has no focus of its
    own; None: what it sees there now decides, which takes rays and so no render's thread. Raises ToolError."""
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
