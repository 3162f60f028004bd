"""Packs a glTF file with its buffers, its images and a camera into one .glb, so that two programs open exactly the same
scene."""

import base64
import json
import math
import struct
import urllib.parse

CAMERA = "fidelity"


def split_glb(data):
    """Returns the JSON document and the bytes of the first binary chunk of a .glb file."""
    length = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def bytes_of(uri, folder):
    if uri.startswith("data:"):
        return base64.b64decode(uri.split(",", 1)[1])
    return (folder / urllib.parse.unquote(uri)).read_bytes()


class OneFile:
    def __init__(self, path):
        data = path.read_bytes()
        self.folder, self.blob = path.parent, bytearray()
        self.doc, chunk = split_glb(data) if data[:4] == b"glTF" else (json.loads(data), b"")
        self.join_buffers(chunk)
        self.take_images_in()

    def append(self, data):
        self.blob += b"\0" * (-len(self.blob) % 16)
        self.blob += data
        return len(self.blob) - len(data)

    def join_buffers(self, chunk):
        starts = []
        for buffer in self.doc.get("buffers", []):
            data = bytes_of(buffer["uri"], self.folder) if "uri" in buffer else chunk
            starts.append(self.append(bytes(data).ljust(buffer["byteLength"], b"\0")))
        for view in self.doc.get("bufferViews", []):
            for part in (view, view.get("extensions", {}).get("EXT_meshopt_compression")):
                if part:
                    part["byteOffset"] = part.get("byteOffset", 0) + starts[part["buffer"]]
                    part["buffer"] = 0

    def take_images_in(self):
        for image in self.doc.get("images", []):
            uri = image.pop("uri", None)
            if uri is None:
                continue
            data = bytes_of(uri, self.folder)
            kind = "image/png" if data[:4] == b"\x89PNG" else "image/webp" if data[8:12] == b"WEBP" else "image/jpeg"
            self.doc.setdefault("bufferViews", []).append({"buffer": 0, "byteOffset": self.append(data), "byteLength": len(data)})
            image.update(bufferView=len(self.doc["bufferViews"]) - 1, mimeType=kind)

    def add_camera(self, place, turn, vertical_fov, aspect, reach):
        """vertical_fov: in radians. reach: a typical length of the scene, which sets the clipping planes."""
        doc = self.doc
        doc.setdefault("cameras", []).append({"type": "perspective", "perspective": {
            "yfov": vertical_fov, "aspectRatio": aspect, "znear": 1e-3 * reach, "zfar": 1e4 * reach}})
        doc.setdefault("nodes", []).append({"name": CAMERA, "camera": len(doc["cameras"]) - 1, "rotation": turn, "translation": place})
        doc["cameras"][-1]["name"] = CAMERA
        scene = doc.setdefault("scenes", [{"nodes": []}])[doc.get("scene", 0)]
        scene.setdefault("nodes", []).append(len(doc["nodes"]) - 1)

    def name_own_camera(self, aspect):
        """Renames the first perspective camera in use and sets its aspect ratio. Returns False if there is none."""
        cameras = self.doc.get("cameras", [])
        node = next((n for n in self.doc.get("nodes", []) if "camera" in n and cameras[n["camera"]]["type"] == "perspective"), None)
        if node is None:
            return False
        camera = cameras[node["camera"]]
        node["name"] = camera["name"] = CAMERA
        camera["perspective"]["aspectRatio"] = aspect
        return True

    def write(self, path):
        if self.blob:
            self.doc["buffers"] = [{"byteLength": len(self.blob)}]
        path.write_bytes(glb(self.doc, bytes(self.blob)))


def glb(doc, blob):
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    chunks = struct.pack("<I", len(text)) + b"JSON" + text
    if blob:
        chunks += struct.pack("<I", len(blob)) + b"BIN\0" + blob
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def fitted(array, yaw_deg, pitch_deg):
    """Returns the position, the rotation and the vertical field of view of a camera whose picture is the rectangle
    `array`, as `lippmann info` prints it."""
    y, p = math.radians(yaw_deg), math.radians(pitch_deg)
    away = (math.sin(y) * math.cos(p), math.sin(p), math.cos(y) * math.cos(p))
    place = [c + array["viewing_distance"] * a for c, a in zip(array["center"], away)]
    y, p = y / 2, p / 2
    turn = [-math.cos(y) * math.sin(p), math.sin(y) * math.cos(p), math.sin(y) * math.sin(p), math.cos(y) * math.cos(p)]
    return place, turn, 2.0 * math.atan(0.5 * array["height"] / array["viewing_distance"])
