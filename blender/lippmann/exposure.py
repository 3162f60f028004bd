"""What a camera's lens and shutter blur, as flags of `lippmann render` (docs/guide/displays.md, "Depth of field and motion blur")."""

from . import displays, frame


def has_eyes(scene):
    """Whether the output is what single eyes see, which can be lenses; pixels of lens arrays and of native frames have directions of their own."""
    output = scene.lippmann.output
    return output in ("single", "camera") or (output != "native" and displays.chosen(scene)["kind"] == "slanted-panel")


def focused_camera(scene):
    """The scene's camera if it has depth of field, else None."""
    camera = scene.camera
    return camera if camera and camera.type == "CAMERA" and camera.data.dof.use_dof else None


def lost_of_lens(scene):
    """Why the camera's depth of field is left out; None where it is not, or there is none."""
    camera = focused_camera(scene)
    if camera is None:
        return None
    if camera.data.type != "PERSP":
        return "Depth of field is left out: the camera is not perspective."
    if not has_eyes(scene):
        return "Depth of field is left out: the display's lenses blur with depth themselves."
    return "Depth of field is left out: it takes 2 samples or more." if scene.lippmann.samples < 2 else None


def lost_of_shutter(scene, still):
    """Why motion blur is left out; None where it is not, or there is none."""
    if not scene.render.use_motion_blur:
        return None
    if still:
        return "Motion blur is left out: a still is of one moment."
    return "Motion blur is left out: it takes 2 samples or more." if scene.lippmann.samples < 2 else None


def lens(scene, zone):
    """The diameter of the viewer's eye and the depth that is sharp, in the display's millimetres: what is near the display's plane blurs as it
    does in the camera, which may be nearer to the plane or farther away than the viewer. None: all is sharp."""
    camera = focused_camera(scene)
    if camera is None or lost_of_lens(scene):
        return None
    turned, _ = frame.rigid(camera.matrix_world)
    to_plane = -(turned.inverted() @ zone.world_from_frame.translation).z
    if to_plane <= 0.0 or camera.data.dof.aperture_fstop <= 0.0:
        return None
    diameter = 1e-3 * camera.data.lens / camera.data.dof.aperture_fstop  # of Cycles: a lens' millimetres are thousandths of the scene's units
    return diameter * zone.distance / to_plane / zone.per_mm, (to_plane - frame.focus_distance(camera)) / zone.per_mm


def are_alike(one, other):
    """Whether two lenses differ by no more than a hundredth of their width or of a millimetre, which nobody sees."""
    if one is None or other is None:
        return one is other
    return max(abs(a - b) for a, b in zip(one, other)) <= 0.01 * max(other[0], 1.0)


def lens_flags(lenses, report):
    """Of what `lens` says of every frame; the tool knows one lens for all."""
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
