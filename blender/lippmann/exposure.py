"""Flags of `lippmann render` for depth of field and motion blur, from Blender's settings."""

from . import displays, frame


def has_eyes(scene):
    """Returns whether each picture is one view. Only such pictures can have depth of field; integral images and native frames
    cannot."""
    output = scene.lippmann.output
    return output in ("single", "camera") or (output != "native" and displays.chosen(scene)["kind"] == "slanted-panel")


def focused_camera(scene):
    camera = scene.camera
    return camera if camera and camera.type == "CAMERA" and camera.data.dof.use_dof else None


def lost_of_lens(scene):
    camera = focused_camera(scene)
    if camera is None:
        return None
    if camera.data.type != "PERSP":
        return "Depth of field is left out: the camera is not perspective."
    if not has_eyes(scene):
        return "Depth of field is left out: the display's lenses blur with depth themselves."
    return "Depth of field is left out: it takes 2 samples or more." if scene.lippmann.samples < 2 else None


def lost_of_shutter(scene, still):
    if not scene.render.use_motion_blur:
        return None
    if still:
        return "Motion blur is left out: a still is of one moment."
    return "Motion blur is left out: it takes 2 samples or more." if scene.lippmann.samples < 2 else None


def lens(scene, zone):
    """Returns (aperture diameter, depth in focus) in mm of the display, or None without depth of field.

    The aperture is scaled by viewing distance / camera distance, so that points near the display's plane blur as in the camera.
    """
    camera = focused_camera(scene)
    if camera is None or lost_of_lens(scene):
        return None
    turned, _ = frame.rigid(camera.matrix_world)
    to_plane = -(turned.inverted() @ zone.world_from_frame.translation).z
    if to_plane <= 0.0 or camera.data.dof.aperture_fstop <= 0.0:
        return None
    diameter = 1e-3 * camera.data.lens / camera.data.dof.aperture_fstop  # 1 mm of focal length is 0.001 scene units, as in Cycles
    return diameter * zone.distance / to_plane / zone.per_mm, (to_plane - frame.focus_distance(camera)) / zone.per_mm


def are_alike(one, other):
    """Returns whether two results of lens() differ by at most 1 % of the aperture, or 0.01 mm if the aperture is below 1 mm."""
    if one is None or other is None:
        return one is other
    return max(abs(a - b) for a, b in zip(one, other)) <= 0.01 * max(other[0], 1.0)


def lens_flags(lenses, report):
    """Returns flags for the lens of the first frame. Warns if the lens changes, because the tool uses one lens for all frames.
    lenses: lens() of each frame."""
    first = lenses[0]
    if not all(are_alike(one, first) for one in lenses):
        report.warn("The camera's lens changes; it stays as in the first frame.")
    return ["--aperture", f"{first[0]:.6g}", "--focal-plane", f"{first[1]:.6g}"] if first else []


def shutter_flags(scene, still, report):
    if not scene.render.use_motion_blur or lost_of_shutter(scene, still):
        return []
    if scene.render.motion_blur_shutter > 1.0:
        report.warn("The shutter is open for longer than a frame; a whole frame is blurred.")
    return ["--shutter", f"{min(scene.render.motion_blur_shutter, 1.0):.6g}"]
