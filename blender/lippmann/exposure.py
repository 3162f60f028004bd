"""Flags of `lippmann render` for depth of field and motion blur, from Blender's settings (docs/guide/displays.md, "Depth of field and motion blur")."""

from . import displays, frame


def has_eyes(scene):
    """Returns whether the output consists of views, each of one eye. Only views can have depth of field. Integral images and native frames cannot."""
    output = scene.lippmann.output
    return output in ("single", "camera") or (output != "native" and displays.chosen(scene)["kind"] == "slanted-panel")


def focused_camera(scene):
    """Returns the scene's camera if it has depth of field, else None."""
    camera = scene.camera
    return camera if camera and camera.type == "CAMERA" and camera.data.dof.use_dof else None


def lost_of_lens(scene):
    """Returns a message if the camera has depth of field that cannot be rendered, else None."""
    camera = focused_camera(scene)
    if camera is None:
        return None
    if camera.data.type != "PERSP":
        return "Depth of field is left out: the camera is not perspective."
    if not has_eyes(scene):
        return "Depth of field is left out: the display's lenses blur with depth themselves."
    return "Depth of field is left out: it takes 2 samples or more." if scene.lippmann.samples < 2 else None


def lost_of_shutter(scene, still):
    """Returns a message if the scene has motion blur that cannot be rendered, else None."""
    if not scene.render.use_motion_blur:
        return None
    if still:
        return "Motion blur is left out: a still is of one moment."
    return "Motion blur is left out: it takes 2 samples or more." if scene.lippmann.samples < 2 else None


def lens(scene, zone):
    """Returns the aperture of an eye of the viewer and the depth in focus, both in mm of the display. Returns None if everything is sharp.

    The camera may be nearer to the display's plane than the viewer, or farther away. The aperture is scaled so that points near the plane blur as in the camera.
    """
    camera = focused_camera(scene)
    if camera is None or lost_of_lens(scene):
        return None
    turned, _ = frame.rigid(camera.matrix_world)
    to_plane = -(turned.inverted() @ zone.world_from_frame.translation).z
    if to_plane <= 0.0 or camera.data.dof.aperture_fstop <= 0.0:
        return None
    diameter = 1e-3 * camera.data.lens / camera.data.dof.aperture_fstop  # as in Cycles, which takes 1 mm of the lens for 0.001 scene units
    return diameter * zone.distance / to_plane / zone.per_mm, (to_plane - frame.focus_distance(camera)) / zone.per_mm


def are_alike(one, other):
    """Returns whether two results of lens() differ invisibly: by at most 1 % of the aperture, or 0.01 mm if the aperture is below 1 mm."""
    if one is None or other is None:
        return one is other
    return max(abs(a - b) for a, b in zip(one, other)) <= 0.01 * max(other[0], 1.0)


def lens_flags(lenses, report):
    """Returns flags for the lens of the first frame, because the tool uses one lens for all frames. Warns if the lens changes. lenses: lens() of each frame."""
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
