"""Edits the JSON of a .glb file, to add properties that Blender's exporter cannot write."""

import json
import pathlib
import struct

JSON_CHUNK = 0x4E4F534A  # the text "JSON" as a little-endian integer


def rewrite(path, changes):
    """Calls each function of `changes` with the JSON of a .glb file. A function returns whether it changed the JSON. Writes the
    file only if the JSON has changed."""
    file = pathlib.Path(path)
    data = file.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    if not any([change(document) for change in changes]):
        return
    words = json.dumps(document).encode()
    words += b" " * (-len(words) % 4)
    rest = data[20 + length:]
    file.write_bytes(data[:8] + struct.pack("<III", 20 + len(words) + len(rest), len(words), JSON_CHUNK) + words + rest)
