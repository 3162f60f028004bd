#!/usr/bin/env python3
"""Writes desk.glb and vase.ply beside this script. Both are dedicated to the public domain (CC0 1.0).

desk.glb: a textured table top, a rotating checkered cube, a metal ball, a lacquered ball that hops, and two cameras.
vase.ply: a surface of revolution about the z axis, which points upwards.
"""
import json
import math
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent


def png(width, height, rgb):
    """Returns an 8-bit PNG file. rgb(x, y) returns the colour of a pixel."""
    rows = b"".join(b"\0" + bytes(c for x in range(width) for c in rgb(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def cube():
    positions, normals, uvs, triangles = [], [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                point = [0, 0, 0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = sign, u * sign, v
                positions.append(point)
                normals.append([sign if i == axis else 0 for i in range(3)])
                uvs.append([(u + 1) / 2, (v + 1) / 2])
            triangles += [first, first + 1, first + 2, first, first + 2, first + 3]
    return positions, normals, uvs, triangles


def ball(around=24, down=12):
    positions, uvs, triangles = [], [], []
    for j in range(down + 1):
        for i in range(around + 1):
            theta, phi = math.pi * j / down, 2 * math.pi * i / around
            positions.append([math.sin(theta) * math.cos(phi), math.cos(theta), -math.sin(theta) * math.sin(phi)])
            uvs.append([i / around, j / down])
    for j in range(down):
        for i in range(around):
            a = j * (around + 1) + i
            b = a + around + 1
            if j > 0:
                triangles += [a, b, a + 1]
            if j < down - 1:
                triangles += [a + 1, b, b + 1]
    return positions, positions, uvs, triangles


class Glb:
    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0", "copyright": "CC0 1.0"}, "buffers": [], "bufferViews": [], "accessors": []}

    def view(self, data):
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data
        return len(self.json["bufferViews"]) - 1

    def floats(self, rows, kind):
        flat = [value for row in rows for value in (row if isinstance(row, (list, tuple)) else [row])]
        size = len(flat) // len(rows)
        accessor = {"bufferView": self.view(struct.pack(f"<{len(flat)}f", *flat)), "componentType": 5126,
                    "count": len(rows), "type": kind}
        accessor["min"] = [min(flat[i::size]) for i in range(size)]
        accessor["max"] = [max(flat[i::size]) for i in range(size)]
        # glTF requires bounds that equal stored values, which have single precision.
        for end in ("min", "max"):
            accessor[end] = [struct.unpack("<f", struct.pack("<f", value))[0] for value in accessor[end]]
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def mesh(self, shape, material):
        positions, normals, uvs, triangles = shape
        attributes = {"POSITION": self.floats(positions, "VEC3"), "NORMAL": self.floats(normals, "VEC3"),
                      "TEXCOORD_0": self.floats(uvs, "VEC2")}
        indices = self.view(struct.pack(f"<{len(triangles)}H", *triangles))
        self.json["accessors"].append({"bufferView": indices, "componentType": 5123, "count": len(triangles),
                                       "type": "SCALAR"})
        primitive = {"attributes": attributes, "indices": len(self.json["accessors"]) - 1, "material": material}
        self.json.setdefault("meshes", []).append({"primitives": [primitive]})
        return len(self.json["meshes"]) - 1

    def bytes(self):
        self.binary += b"\0" * (-len(self.binary) % 4)
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self.binary)
        return (struct.pack("<4sII", b"glTF", 2, total) + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(self.binary), b"BIN\0") + self.binary)


def around_x(degrees):
    half = math.radians(degrees) / 2
    return [math.sin(half), 0, 0, math.cos(half)]


def around_y(degrees):
    half = math.radians(degrees) / 2
    return [0, math.sin(half), 0, math.cos(half)]


def times(a, b):
    """Returns the product of two quaternions with components x, y, z, w."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


def desk():
    glb = Glb()
    squares = png(64, 64, lambda x, y: (216, 96, 48) if (x // 16 + y // 16) % 2 else (240, 232, 216))
    wood = png(128, 64, lambda x, y: tuple(int(c * (0.8 + 0.2 * math.sin(0.45 * y + 2 * math.sin(0.06 * x))))
                                           for c in (176, 120, 72)))
    images = [{"bufferView": glb.view(image), "mimeType": "image/png"} for image in (squares, wood)]
    glb.json["images"] = images
    glb.json["textures"] = [{"source": 0}, {"source": 1}]

    def rough(texture=None, color=(1, 1, 1, 1), metallic=0.0, roughness=0.8):
        model = {"baseColorFactor": list(color), "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            model["baseColorTexture"] = {"index": texture}
        return {"pbrMetallicRoughness": model}

    glb.json["materials"] = [
        {"name": "Wood", **rough(1, roughness=0.5)},
        {"name": "Squares", **rough(0)},
        {"name": "Brass", **rough(color=(0.91, 0.75, 0.38, 1), metallic=1.0, roughness=0.2)},
        {"name": "Blue lacquer", **rough(color=(0.05, 0.15, 0.55, 1), roughness=0.15)}]
    side = [-1, 1]
    table = ([[x, 0, z] for z in side for x in side], [[0, 1, 0]] * 4, [[u, v] for v in (0, 1) for u in (0, 1)],
             [0, 2, 1, 1, 2, 3])
    meshes = [glb.mesh(table, 0), glb.mesh(cube(), 1), glb.mesh(ball(), 2), glb.mesh(ball(), 3)]
    glb.json["cameras"] = [
        {"name": name, "type": "perspective", "perspective": {"yfov": 0.6, "aspectRatio": 1.0, "znear": 0.01}}
        for name in ("Front", "Side")]
    glb.json["nodes"] = [
        {"name": "Table", "mesh": meshes[0], "scale": [1.2, 1, 0.9]},
        {"name": "Cube", "mesh": meshes[1], "translation": [-0.35, 0.2, -0.1], "scale": [0.2, 0.2, 0.2]},
        {"name": "Brass ball", "mesh": meshes[2], "translation": [0.3, 0.22, -0.25], "scale": [0.22, 0.22, 0.22]},
        {"name": "Blue ball", "mesh": meshes[3], "translation": [0.15, 0.14, 0.35], "scale": [0.14, 0.14, 0.14]},
        {"name": "Front", "camera": 0, "translation": [0, 1.1, 2.4], "rotation": around_x(-21)},
        {"name": "Side", "camera": 1, "translation": [1.8, 1.1, 1.8], "rotation": times(around_y(45), around_x(-21))}]
    glb.json["scenes"] = [{"nodes": list(range(6))}]
    glb.json["scene"] = 0
    turn_times = glb.floats([0, 0.5, 1, 1.5, 2], "SCALAR")
    turns = glb.floats([around_y(90 * i) for i in range(5)], "VEC4")
    hop_times = glb.floats([i / 8 for i in range(17)], "SCALAR")
    hops = glb.floats([[0.15, 0.14 + 0.3 * abs(math.sin(math.pi * i / 8)), 0.35] for i in range(17)], "VEC3")
    glb.json["animations"] = [{
        "name": "Play",
        "samplers": [{"input": turn_times, "output": turns}, {"input": hop_times, "output": hops}],
        "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}},
                     {"sampler": 1, "target": {"node": 3, "path": "translation"}}]}]
    return glb.bytes()


def vase(around=32, up=24):
    lines = ["ply", "format ascii 1.0", "comment CC0 1.0", f"element vertex {around * (up + 1)}", "property float x",
             "property float y", "property float z", f"element face {around * up}",
             "property list uchar int vertex_indices", "end_header"]
    for j in range(up + 1):
        radius = 0.5 + 0.2 * math.sin(2 * math.pi * j / up)
        for i in range(around):
            phi = 2 * math.pi * i / around
            lines.append(f"{radius * math.cos(phi):.4f} {radius * math.sin(phi):.4f} {2 * j / up:.4f}")
    for j in range(up):
        for i in range(around):
            a, b = j * around + i, j * around + (i + 1) % around
            lines.append(f"4 {a} {b} {b + around} {a + around}")
    return ("\n".join(lines) + "\n").encode()


if __name__ == "__main__":
    (FOLDER / "desk.glb").write_bytes(desk())
    (FOLDER / "vase.ply").write_bytes(vase())
