"""What a glTF file has that a renderer of it does not read."""

SILENT = {"KHR_xmp", "KHR_xmp_json_ld"}  # nothing that could be seen
COLOURED_GLOSS = "KHR_materials_specular's colour"
FIRST_WITH_COLOURED_GLOSS = (4, 0, 0)  # Blender, whose Principled surface had a tint by one number before


def has_colour(gloss):
    return "specularColorTexture" in gloss or len(set(gloss.get("specularColorFactor", []))) > 1


def extensions_of(value):
    """The extensions that anything in a glTF document has, as objects that hold them; the gloss's colour too, by a name of its own."""
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
    """Those of extensions_of(a document) that a Blender of a version, (4, 3, 0), does not show, whose importer knows some. Sorted."""
    shown = known | SILENT | ({COLOURED_GLOSS} if version >= FIRST_WITH_COLOURED_GLOSS else set())
    return sorted(names - shown)
