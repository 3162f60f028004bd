"""Makes glTF scenes like the Khronos samples. Each scene is a single .gltf file."""

import base64
import json
import math
import struct
import zlib


def turned_down(angle):
    return [-math.sin(0.5 * angle), 0.0, 0.0, math.cos(0.5 * angle)]


class Gltf:
    """Builds a glTF document with all binary data in one buffer."""

    def __init__(self):
        self.blob = b""
        self.doc = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": [],
                    "accessors": [], "bufferViews": [], "textures": [], "images": [], "cameras": []}

    def _view(self, data):
        self.blob += b"\0" * (-len(self.blob) % 4)
        self.doc["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)})
        self.blob += data
        return len(self.doc["bufferViews"]) - 1

    def _accessor(self, rows, kind, component=5126):
        flat = [x for row in rows for x in row] if kind != "SCALAR" else rows
        data = struct.pack(f"<{len(flat)}{'f' if component == 5126 else 'I'}", *flat)
        accessor = {"bufferView": self._view(data), "componentType": component, "count": len(rows), "type": kind}
        if kind == "VEC3":
            accessor["min"] = [min(r[i] for r in rows) for i in range(3)]
            accessor["max"] = [max(r[i] for r in rows) for i in range(3)]
        self.doc["accessors"].append(accessor)
        return len(self.doc["accessors"]) - 1

    def texture(self, size, color):
        """color(x, y) returns the four bytes of a pixel."""
        rows = b"".join(b"\0" + bytes(v for x in range(size) for v in color(x, y)) for y in range(size))
        chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        png = (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 6, 0, 0, 0)) +
               chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
        self.doc["images"].append({"bufferView": self._view(png), "mimeType": "image/png"})
        self.doc["textures"].append({"source": len(self.doc["images"]) - 1})
        return {"index": len(self.doc["textures"]) - 1}

    def material(self, color=(0.8, 0.8, 0.8), metallic=0.0, roughness=1.0, alpha=1.0, **more):
        pbr = {"baseColorFactor": [*color, alpha], "metallicFactor": metallic, "roughnessFactor": roughness}
        for key in ("baseColorTexture", "metallicRoughnessTexture"):
            if key in more:
                pbr[key] = more.pop(key)
        self.doc["materials"].append({"pbrMetallicRoughness": pbr, "doubleSided": True, **more})
        return len(self.doc["materials"]) - 1

    def node(self, **fields):
        self.doc["nodes"].append(fields)
        self.doc["scenes"][0]["nodes"].append(len(self.doc["nodes"]) - 1)

    def move(self, seconds, places):
        """Moves the last node in straight lines from place to place."""
        sampler = {"input": self._accessor(seconds, "SCALAR"), "output": self._accessor(places, "VEC3"), "interpolation": "LINEAR"}
        self.doc["accessors"][sampler["input"]].update(min=[seconds[0]], max=[seconds[-1]])
        animations = self.doc.setdefault("animations", [{"samplers": [], "channels": []}])
        animations[0]["samplers"].append(sampler)
        animations[0]["channels"].append({"sampler": len(animations[0]["samplers"]) - 1,
                                          "target": {"node": len(self.doc["nodes"]) - 1, "path": "translation"}})

    def mesh(self, material, positions, normals, uvs, indices, at=(0.0, 0.0, 0.0)):
        self.doc["meshes"].append({"primitives": [{
            "attributes": {"POSITION": self._accessor(positions, "VEC3"), "NORMAL": self._accessor(normals, "VEC3"),
                           "TEXCOORD_0": self._accessor(uvs, "VEC2")},
            "indices": self._accessor(indices, "SCALAR", 5125), "material": material}]})
        self.node(mesh=len(self.doc["meshes"]) - 1, translation=list(at))

    def quad(self, material, center, half_u, half_v, repeat=1.0):
        """The normal is the cross product of half_u and half_v."""
        c, u, v = center, half_u, half_v
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        length = math.sqrt(sum(x * x for x in n))
        corners = [[c[i] + a * u[i] + b * v[i] for i in range(3)] for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        self.mesh(material, corners, [[x / length for x in n]] * 4, [(0, repeat), (repeat, repeat), (repeat, 0), (0, 0)],
                  [0, 1, 2, 0, 2, 3])

    def sphere(self, material, center, radius, steps=96):
        positions, normals, uvs, indices = [], [], [], []
        for j in range(steps // 2 + 1):
            for i in range(steps + 1):
                polar, turn = math.pi * j / (steps // 2), 2 * math.pi * i / steps
                n = (math.sin(polar) * math.cos(turn), math.cos(polar), -math.sin(polar) * math.sin(turn))
                positions.append([radius * x for x in n])
                normals.append(n)
                uvs.append((i / steps, j / (steps // 2)))
        row = steps + 1
        for j in range(steps // 2):
            for i in range(steps):
                a = j * row + i
                if j > 0:
                    indices += [a, a + row, a + 1]
                if j < steps // 2 - 1:
                    indices += [a + 1, a + row, a + row + 1]
        self.mesh(material, positions, normals, uvs, indices, center)

    def box(self, material, center, half):
        x, y, z = ([h if i == k else 0.0 for i in range(3)] for k, h in enumerate(half))
        plus = lambda a, s: [center[i] + s * a[i] for i in range(3)]
        for n, u, v in ((x, y, z), (y, z, x), (z, x, y)):
            self.quad(material, plus(n, 1), u, v)
            self.quad(material, plus(n, -1), v, u)

    def point_light(self, at, candela, color=(1.0, 1.0, 1.0)):
        self.light(at, type="point", intensity=candela, color=list(color))

    def light(self, at, down=0.0, **light):
        """The light shines along -z, tilted down by `down` radians."""
        lights = self.doc.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append(light)
        self.node(translation=list(at), rotation=turned_down(down), extensions={"KHR_lights_punctual": {"light": len(lights) - 1}})

    def camera(self, at, aspect=1.0, fov=0.6, down=0.0):
        self.doc["cameras"].append({"type": "perspective",
                                    "perspective": {"yfov": fov, "aspectRatio": aspect, "znear": 0.01, "zfar": 1000.0}})
        self.node(camera=0, translation=list(at), rotation=turned_down(down))

    def write(self, path):
        doc = {key: value for key, value in self.doc.items() if value not in ([], {})}
        doc["buffers"] = [{"byteLength": len(self.blob),
                           "uri": "data:application/octet-stream;base64," + base64.b64encode(self.blob).decode()}]
        used = {key for m in self.doc["materials"] for key in m.get("extensions", {})} | set(doc.get("extensions", {}))
        if used:
            doc["extensionsUsed"] = sorted(used)
        path.write_text(json.dumps(doc))


MATTE = {"extensions": {"KHR_materials_specular": {"specularFactor": 0.0}}}


def emission(strength, color=(1.0, 1.0, 1.0)):
    return {"emissiveFactor": list(color), "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": strength},
                                                          "KHR_materials_specular": {"specularFactor": 0.0}}}


def checker(a, b, cells=8, size=64):
    return lambda x, y: (*(a if (x * cells // size + y * cells // size) % 2 else b), 255)


def box_room(g, white, left, right):
    g.quad(white, (0, -1, 0), (1, 0, 0), (0, 0, -1))
    g.quad(white, (0, 1, 0), (1, 0, 0), (0, 0, 1))
    g.quad(white, (0, 0, -1), (1, 0, 0), (0, 1, 0))
    g.quad(left, (-1, 0, 0), (0, 0, -1), (0, 1, 0))
    g.quad(right, (1, 0, 0), (0, 0, 1), (0, 1, 0))
    g.camera((0, 0, 4.4))


def diffuse_box():
    """Colour bleeding below a square area lamp, with many bounces."""
    g = Gltf()
    white = g.material(**MATTE)
    box_room(g, white, g.material((0.7, 0.08, 0.05), **MATTE), g.material((0.1, 0.5, 0.08), **MATTE))
    g.quad(g.material((0, 0, 0), **emission(12.0)), (0, 0.99, 0), (0.3, 0, 0), (0, 0, 0.3))
    g.box(white, (0.35, -0.7, 0.2), (0.25, 0.3, 0.25))
    g.sphere(white, (-0.4, -0.6, -0.2), 0.4)
    return g


def textured_point_lights():
    """The bumps are gentle, because Cycles changes steep normals at grazing angles."""
    g = Gltf()
    waves = lambda x, y: (int(127.5 + 35 * math.sin(2 * math.pi * x / 16)), int(127.5 + 35 * math.sin(2 * math.pi * y / 16)), 245, 255)
    bumps = g.texture(64, waves)
    tiles = g.texture(64, checker((200, 160, 90), (60, 80, 120)))
    wall = g.material((1, 1, 1), baseColorTexture=tiles, normalTexture=bumps, **MATTE)
    box_room(g, wall, g.material((0.7, 0.6, 0.5), **MATTE), g.material((0.5, 0.6, 0.7), **MATTE))
    g.sphere(g.material((1, 1, 1), baseColorTexture=tiles, **MATTE), (0.1, -0.4, 0.0), 0.5)
    g.point_light((0.5, 0.7, 0.6), 1.2, (1.0, 0.9, 0.7))
    g.point_light((-0.6, 0.2, 0.7), 0.5, (0.6, 0.7, 1.0))
    return g


def dielectrics():
    """Plastic with three roughnesses, lit by a panorama."""
    g = Gltf()
    g.quad(g.material((0.5, 0.5, 0.5), **MATTE), (0, -0.5, 0), (3, 0, 0), (0, 0, -3))
    for i, roughness in enumerate((0.15, 0.35, 0.7)):
        g.sphere(g.material(((0.6, 0.1, 0.1), (0.1, 0.5, 0.1), (0.1, 0.15, 0.6))[i], roughness=roughness), (i - 1.0, 0, 0), 0.45)
    g.camera((0, 0.4, 5.0))
    return g


def metals():
    """Metal with three roughnesses, lit by a panorama."""
    g = Gltf()
    g.quad(g.material((0.5, 0.5, 0.5), **MATTE), (0, -0.5, 0), (3, 0, 0), (0, 0, -3))
    for i, roughness in enumerate((0.1, 0.3, 0.6)):
        g.sphere(g.material(((0.95, 0.8, 0.5), (0.9, 0.9, 0.92), (0.9, 0.5, 0.4))[i], 1.0, roughness), (i - 1.0, 0, 0), 0.45)
    g.camera((0, 0.4, 5.0))
    return g


def glass():
    """A smooth glass ball in front of tiles, lit by a panorama."""
    g = Gltf()
    tiles = g.texture(64, checker((220, 220, 220), (40, 60, 110)))
    g.quad(g.material((1, 1, 1), baseColorTexture=tiles, **MATTE), (0, -0.5, 0), (3, 0, 0), (0, 0, -3), 3.0)
    clear = {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_ior": {"ior": 1.45}}}
    g.sphere(g.material((1, 1, 1), roughness=0.0, **clear), (0, 0.1, 0), 0.6, 256)
    g.camera((0, 0.4, 5.0))
    return g


def rough_glass():
    """Glass with three roughnesses in front of tiles, lit by a panorama."""
    g = Gltf()
    tiles = g.texture(64, checker((220, 220, 220), (40, 60, 110)))
    g.quad(g.material((1, 1, 1), baseColorTexture=tiles, **MATTE), (0, -0.5, 0), (3, 0, 0), (0, 0, -3), 3.0)
    clear = {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_ior": {"ior": 1.5}}}
    for i, roughness in enumerate((0.3, 0.6, 0.9)):
        g.sphere(g.material((1, 1, 1), roughness=roughness, **clear), (i - 1.0, 0, 0), 0.45)
    g.camera((0, 0.4, 5.0))
    return g


def leaves():
    """Cards with a cut-out and a half-transparent texture above a floor, lit by a panorama."""
    g = Gltf()
    g.quad(g.material((0.6, 0.6, 0.55), **MATTE), (0, -0.5, 0), (3, 0, 0), (0, 0, -3))
    disc = lambda x, y: (60, 140, 40, 255 if (x - 31.5) ** 2 + (y - 31.5) ** 2 < 26**2 else 0)
    leaf = g.texture(64, disc)
    cut = g.material((1, 1, 1), baseColorTexture=leaf, alphaMode="MASK", alphaCutoff=0.5, **MATTE)
    veil = g.material((0.9, 0.3, 0.2), alpha=0.4, alphaMode="BLEND", **MATTE)
    for i in range(4):
        g.quad(cut, (-0.9 + 0.5 * i, 0.3 * (i % 2), -0.4 + 0.3 * i), (0.35, 0, 0.1), (0, 0.35, 0.05))
    g.quad(veil, (0.7, 0.1, 0.8), (0.3, 0, 0), (0, 0.4, 0))
    g.camera((0, 0.4, 5.0))
    return g


def post(at, down, **light):
    """A post and a glossy ball on a floor, lit by one area lamp."""
    g = Gltf()
    g.quad(g.material((0.6, 0.6, 0.6), **MATTE), (0, 0, 0), (4, 0, 0), (0, 0, -4))
    g.box(g.material((0.7, 0.4, 0.2), **MATTE), (-0.3, 0.6, 0), (0.12, 0.6, 0.12))
    g.sphere(g.material((0.9, 0.9, 0.9), metallic=1.0, roughness=0.3), (0.8, 0.3, 0.7), 0.3)
    g.light(at, down, **light)
    g.camera((0, 2.4, 5.0), fov=0.7, down=0.42)
    return g


def ball_lamp():
    return post((-1.4, 1.9, 1.0), 0.0, type="point", intensity=8.0, extras={"radius": 0.5})


def spot_lamp():
    return post((-0.4, 2.6, 2.0), 0.9, type="spot", intensity=20.0, spot={"innerConeAngle": 0.3, "outerConeAngle": 0.45},
                extras={"radius": 0.3, "blend": 0.5})


def sun_disc():
    return post((0, 3, 0), 0.7, type="directional", intensity=2.0, extras={"angle": math.radians(10.0)})


def moving_room():
    """A room with a plastic ball and a matte ball below a square lamp. The matte ball rolls for 2 seconds."""
    g = Gltf()
    tiles = g.texture(64, checker((200, 160, 90), (60, 80, 120)))
    wall = g.material((1, 1, 1), baseColorTexture=tiles, **MATTE)
    box_room(g, wall, g.material((0.7, 0.08, 0.05), **MATTE), g.material((0.1, 0.5, 0.08), **MATTE))
    g.quad(g.material((0, 0, 0), **emission(12.0)), (0, 0.99, 0), (0.3, 0, 0), (0, 0, 0.3))
    g.sphere(g.material((0.15, 0.2, 0.6), roughness=0.3), (0.4, -0.6, -0.3), 0.4)
    g.sphere(g.material((0.8, 0.7, 0.6), **MATTE), (0, 0, 0), 0.25)
    g.move([0.0, 1.0, 2.0], [(-0.6, -0.75, 0.2), (0.5, -0.75, 0.5), (-0.6, -0.75, 0.2)])
    return g


# For each name: the function that makes the scene, whether the panorama lights it, and the required PSNR in dB.
FIXTURES = {"diffuse-box": (diffuse_box, False, 35.0), "textured": (textured_point_lights, False, 35.0),
            "leaves": (leaves, True, 35.0), "plastic": (dielectrics, True, 30.0), "metal": (metals, True, 30.0),
            "glass": (glass, True, 30.0), "rough-glass": (rough_glass, True, 30.0), "ball-lamp": (ball_lamp, False, 38.0),
            "spot-lamp": (spot_lamp, False, 37.0), "sun-disc": (sun_disc, False, 40.0)}


def write_panorama(path, width=256):
    def texel(x, y):
        u, v = (x + 0.5) / width, (y + 0.5) / (width // 2)
        sky = 0.9 - 0.7 * v
        spot = 30.0 * math.exp(-((u - 0.7) ** 2 + (v - 0.25) ** 2) * 600.0)
        return (0.6 * sky + spot, 0.75 * sky + 0.8 * spot, sky + 0.5 * spot)

    def rgbe(color):
        mantissa, exponent = math.frexp(max(*color, 1e-9))
        scale = mantissa * 256.0 / max(*color, 1e-9)
        return bytes([*(min(255, int(c * scale)) for c in color), exponent + 128])

    pixels = b"".join(rgbe(texel(x, y)) for y in range(width // 2) for x in range(width))
    path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (width // 2, width) + pixels)
