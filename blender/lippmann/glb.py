"""A .glb file after Blender's exporter has written it: its JSON, changed where the exporter cannot say something."""

import json
import pathlib
import struct

JSON_CHUNK = 0x4E4F534A  # "JSON" in the order of bytes that files have


def rewrite(path, changes):
    """changes: functions of the document that tell whether they have changed it. The file stays as it is where none has."""
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
