"""The tone curve and the exposure, which the tool applies. Blender's view transform must then be Standard, or it would change
the pictures again."""

CURVES = {"AgX": "agx", "Filmic": "agx", "Filmic Log": "agx", "Khronos PBR Neutral": "neutral"}  # Blender's view transform -> the most similar --tone


def is_plain(view):
    return (view.view_transform, view.look, view.exposure, view.gamma) == ("Standard", "None", 0.0, 1.0) and not view.use_curve_mapping


def lost(view):
    """Returns a message if Blender's render window shows other colours than the files contain, else None."""
    if is_plain(view):
        return None
    return f"Blender's window shows pictures through {view.view_transform}, too; their files are as the settings say. Take Over View Transform makes both alike."


def flags(settings, more):
    """Returns the flags --tone and --exposure. more: the user's extra flags, which take precedence."""
    tone = ["--tone", settings.tone] if settings.tone != "none" and "--tone" not in more else []
    return tone + (["--exposure", f"{settings.exposure:.6g}"] if settings.exposure != 0.0 and "--exposure" not in more else [])


def take_over(settings, view):
    settings.tone = CURVES.get(view.view_transform, "none")
    settings.exposure += view.exposure
    view.view_transform, view.look, view.exposure, view.gamma, view.use_curve_mapping = "Standard", "None", 0.0, 1.0, False
