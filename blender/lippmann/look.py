"""The look of pictures: how light becomes codes. The add-on's settings decide it, in the tool; Blender's view transform must then show codes as they are."""

CURVES = {"AgX": "agx", "Filmic": "agx", "Filmic Log": "agx", "Khronos PBR Neutral": "neutral"}  # Blender's view transform -> the nearest curve of the tool


def is_plain(view):
    """Whether Blender shows a picture's codes as they are."""
    return (view.view_transform, view.look, view.exposure, view.gamma) == ("Standard", "None", 0.0, 1.0) and not view.use_curve_mapping


def lost(view):
    """Returns a sentence if Blender's render window shows other codes than the files hold, else None."""
    if is_plain(view):
        return None
    return f"Blender's window shows pictures through {view.view_transform}, too; their files are as the settings say. Take Over View Transform makes both alike."


def flags(settings, more):
    """Returns flags of lippmann render. more: the user's own flags, which replace them."""
    tone = ["--tone", settings.tone] if settings.tone != "none" and "--tone" not in more else []
    return tone + (["--exposure", f"{settings.exposure:.6g}"] if settings.exposure != 0.0 and "--exposure" not in more else [])


def take_over(settings, view):
    """Moves Blender's view transform and exposure into the add-on's settings, and sets Blender's own to Standard."""
    settings.tone = CURVES.get(view.view_transform, "none")
    settings.exposure += view.exposure
    view.view_transform, view.look, view.exposure, view.gamma, view.use_curve_mapping = "Standard", "None", 0.0, 1.0, False
