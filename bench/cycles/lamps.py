"""Scales the intensities of lamps in glTF files that Blender's exporter wrote, as src/scene/gltf/light.cpp does."""

import math
import re

LUMENS_PER_WATT = 683.0
FIRST_IN_LUMENS = (3, 4, 39)


def version(generator):
    """Returns the three numbers of the version after the last " v". Missing numbers are 0."""
    found = re.match(r"(\d+)(?:\.(\d+))?(?:\.(\d+))?", generator.rpartition(" v")[2])
    return tuple(int(n or 0) for n in found.groups()) if found else (0, 0, 0)


def scale(generator, kind):
    """kind: "point", "spot" or "directional", as in the file."""
    unnumbered = "Khronos Blender glTF 2.0 I/O" in generator
    if not unnumbered and "Blender I/O" not in generator:
        return 1.0
    if not unnumbered and version(generator) >= FIRST_IN_LUMENS:
        return 1.0 / LUMENS_PER_WATT
    return 1.0 if kind == "directional" else 1.0 / (4.0 * math.pi)
