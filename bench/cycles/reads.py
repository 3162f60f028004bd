"""Finds the features of a glTF file that a renderer does not read."""

SILENT = {"KHR_xmp", "KHR_xmp_json_ld"}  # these extensions have no effect on pictures
COLOURED_GLOSS = "KHR_materials_specular's colour"
FIRST_WITH_COLOURED_GLOSS = (4, 0, 0)  # in earlier versions, the Principled surface had only a scalar tint


def has_colour(gloss):
    return "specularColorTexture" in gloss or len(set(gloss.get("specularColorFactor", []))) > 1


def extensions_of(value):
    """Returns the extensions used in a glTF document. A coloured gloss counts as an extension."""
    if isinstance(value, list):
        return set().union(*map(extensions_of, value))
    if not isinstance(value, dict):
        return set()
    own = value.get("extensions", {})
    found = set(own)
    if has_colour(own.get("KHR_materials_specular", {})):
        found.add(COLOURED_GLOSS)
    return found.union(*(extensions_of(item) for key, item in value.items() if key != "extras"))


def unread(names, known, version):
    """Returns the sorted extensions in `names` that this version of Blender does not show. version: a tuple such as (4,
    3, 0). known: the extensions that the importer reads."""
    shown = known | SILENT | ({COLOURED_GLOSS} if version >= FIRST_WITH_COLOURED_GLOSS else set())
    return sorted(names - shown)
