"""Maps Blender's setting Film > Transparent to the flag --transparent, which renders pictures with alpha."""


def lost_of_transparency(scene, still):
    if not scene.render.film_transparent:
        return None
    if scene.lippmann.output == "native":
        return "Transparent is left out: native frames have no alpha."
    if scene.lippmann.video and not still:
        return "Transparent is left out: videos have no alpha. Without Video the pictures have it."
    return None


def is_transparent(scene, still):
    return scene.render.film_transparent and not lost_of_transparency(scene, still)
