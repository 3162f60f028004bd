"""Gives a .glb file without a camera one, in a copy, so that two programs look at it from the same place."""

import json
import math
import struct


def quaternion(yaw_deg, pitch_deg):
    """Turns a camera that looks along -z: about the vertical, after it was tilted down."""
    y, p = math.radians(yaw_deg) / 2, math.radians(pitch_deg) / 2
    return [-math.cos(y) * math.sin(p), math.sin(y) * math.cos(p), math.sin(y) * math.sin(p), math.cos(y) * math.cos(p)]


def backwards(yaw_deg, pitch_deg):
    """From what it looks at to the camera."""
    y, p = math.radians(yaw_deg), math.radians(pitch_deg)
    return [math.sin(y) * math.cos(p), math.sin(p), math.cos(y) * math.cos(p)]


def with_camera(source, array, view, out):
    """array: of `lippmann info`: center, height and viewing_distance of the plane that the camera's view fills. view: yaw and pitch in
    degrees. Returns `out`."""
    data = source.read_bytes()
    if data[:4] != b"glTF":
        raise SystemExit(f"{source} has no camera: only .glb files can be given one")
    length = struct.unpack("<I", data[12:16])[0]
    doc, rest = json.loads(data[20:20 + length]), data[20 + length:]
    distance = array["viewing_distance"]
    doc.setdefault("cameras", []).append({"type": "perspective", "perspective": {
        "yfov": 2 * math.atan(0.5 * array["height"] / distance), "aspectRatio": 1.0, "znear": 0.001 * distance, "zfar": 100 * distance}})
    doc.setdefault("nodes", []).append({
        "name": "camera", "camera": len(doc["cameras"]) - 1, "rotation": quaternion(*view),
        "translation": [c + distance * b for c, b in zip(array["center"], backwards(*view))]})
    doc["scenes"][doc.get("scene", 0)].setdefault("nodes", []).append(len(doc["nodes"]) - 1)
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    out.write_bytes(b"glTF" + struct.pack("<III", 2, 20 + len(text) + len(rest), len(text)) + b"JSON" + text + rest)
    return out
