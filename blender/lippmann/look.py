"""The look of pictures: how light becomes codes. The add-on's settings decide it, in the tool; Blender's view transform must then show codes as they are."""

CURVES = {"AgX": "agx", "Filmic": "agx", "Filmic Log": "agx", "Khronos PBR Neutral": "neutral"}  # of the tool, nearest to Blender's view transforms


def is_plain(view):
    """Whether Blender shows a picture's codes as they are."""
    return (view.view_transform, view.look, view.exposure, view.gamma) == ("Standard", "None", 0.0, 1.0) and not view.use_curve_mapping


def lost(view):
    """Why Blender's render window does not show what the files hold; None where it does."""
    if is_plain(view):
        return None
    return f"Blender's window shows pictures through {view.view_transform}, too; their files are as the settings say. Take Over View Transform makes both alike."


def flags(settings, more):
    """Those of lippmann render. more: flags that the user wrote, which count first."""
    tone = ["--tone", settings.tone] if settings.tone != "none" and "--tone" not in more else []
    return tone + (["--exposure", f"{settings.exposure:.6g}"] if settings.exposure != 0.0 and "--exposure" not in more else [])


def take_over(settings, view):
    """Makes Blender's view transform, exposure and all, a setting of the add-on's, and Blender's own plain."""
    settings.tone = CURVES.get(view.view_transform, "none")
    settings.exposure += view.exposure
    view.view_transform, view.look, view.exposure, view.gamma, view.use_curve_mapping = "Standard", "None", 0.0, 1.0, False
