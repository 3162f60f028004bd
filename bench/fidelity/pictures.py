"""Reads and writes PNG files as arrays.

A picture is an array (h, w, 4) of 8-bit codes for red, green, blue and alpha. Row 0 is at the top.
"""

import struct
import zlib

import numpy as np

CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}


def paeth(left, up, corner):
    """Returns the neighbour nearest to left + up - corner. Ties are broken as in the PNG specification."""
    estimate = left + up - corner
    a, b, c = abs(estimate - left), abs(estimate - up), abs(estimate - corner)
    return left if a <= b and a <= c else up if b <= c else corner


def unfilter_one_by_one(kind, row, above, step):
    """Decodes a row whose filter depends on the previously decoded pixel: average (3) or Paeth (4)."""
    row, above = [0] * step + row.tolist(), [0] * step + above.tolist()
    for i in range(step, len(row)):
        left, up = row[i - step], above[i]
        row[i] = (row[i] + ((left + up) // 2 if kind == 3 else paeth(left, up, above[i - step]))) & 255
    return np.array(row[step:], np.uint8)


def unfilter(kind, row, above, step):
    if kind == 0:
        return row
    if kind == 1:
        return np.cumsum(row.reshape(-1, step), axis=0, dtype=np.uint8).reshape(-1)
    if kind == 2:
        return row + above
    return unfilter_one_by_one(kind, row, above, step)


def chunks(data):
    at = 8
    while at + 12 <= len(data):
        length = struct.unpack(">I", data[at:at + 4])[0]
        yield data[at + 4:at + 8], data[at + 8:at + 8 + length]
        at += 12 + length


def read(path):
    """Raises SystemExit unless the file has 8 or 16 bits per channel, no palette and no interlacing."""
    data = path.read_bytes()
    found = list(chunks(data)) if data[:8] == b"\x89PNG\r\n\x1a\n" else []
    if not found or found[0][0] != b"IHDR":
        raise SystemExit(f"{path}: not a PNG picture")
    width, height, bits, color, _, _, interlaced = struct.unpack(">IIBBBBB", found[0][1])
    if bits not in (8, 16) or color not in CHANNELS or interlaced:
        raise SystemExit(f"{path}: a PNG with a palette, interlacing or {bits} bits; accepted: 8 or 16 bits per channel, not interlaced")
    step = CHANNELS[color] * bits // 8
    raw = np.frombuffer(zlib.decompress(b"".join(d for name, d in found if name == b"IDAT")), np.uint8).reshape(height, 1 + width * step)
    rows, above = [], np.zeros(width * step, np.uint8)
    for line in raw:
        above = unfilter(line[0], line[1:].copy(), above, step)
        rows.append(above)
    return with_alpha(np.stack(rows).reshape(height, width, CHANNELS[color], bits // 8)[..., 0])


def with_alpha(codes):
    """Returns RGBA codes for codes of grey, grey and alpha, RGB, or RGBA."""
    count = codes.shape[-1]
    alpha = codes[..., -1:] if count in (2, 4) else np.full_like(codes[..., :1], 255)
    color = codes[..., :3] if count >= 3 else np.repeat(codes[..., :1], 3, axis=-1)
    return np.concatenate([color, alpha], axis=-1)


def png(codes):
    """Returns the bytes of a PNG file for an array (h, w, 3) or (h, w, 4)."""
    height, width, count = codes.shape
    chunk = lambda name, body: struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
    rows = np.concatenate([np.zeros((height, 1), np.uint8), codes.reshape(height, -1)], axis=1)
    header = struct.pack(">IIBBBBB", width, height, 8, 6 if count == 4 else 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b"")


def encode(light):
    light = np.clip(light, 0, 1)
    return np.round(255 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light**(1 / 2.4) - 0.055)).astype(np.uint8)


def decode(codes):
    value = codes.astype(float) / 255
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055)**2.4)


def shrunk(picture, width, height):
    """Reduces the picture by an integer factor to this size, or returns None if the factor is not an integer. Light is
    weighted by coverage."""
    times = picture.shape[0] // height
    if picture.shape[:2] != (height * times, width * times) or times == 0:
        return None
    if times == 1:
        return picture
    blocks = lambda p: p.reshape(height, times, width, times, -1).mean(axis=(1, 3))
    alpha = picture[..., 3:] / 255.0
    cover = blocks(alpha)
    color = blocks(decode(picture[..., :3]) * alpha) / np.maximum(cover, 1e-9)
    return np.concatenate([encode(color), np.round(255 * cover).astype(np.uint8)], axis=-1)


def before_grey(picture, light=0.18):
    """Returns RGB codes in front of plain grey, on which both black and white are visible."""
    alpha = picture[..., 3:] / 255.0
    return encode(decode(picture[..., :3]) * alpha + light * (1 - alpha))
