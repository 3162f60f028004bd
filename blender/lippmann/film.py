"""Blender's Film > Transparent, as `--transparent` of the tool (docs/reference/formats.md): pictures with alpha, whose surroundings light the scene and are not seen."""


def lost_of_transparency(scene, still):
    """Why it is left out; None where it is not, or was not asked for."""
    if not scene.render.film_transparent:
        return None
    if scene.lippmann.output == "native":
        return "Transparent is left out: native frames have no alpha."
    if scene.lippmann.video and not still:
        return "Transparent is left out: videos have no alpha. Without Video the pictures have it."
    return None


def is_transparent(scene, still):
    return scene.render.film_transparent and not lost_of_transparency(scene, still)
