"""Makes ten pairs of pictures, a reference and a distorted copy, for comparisons of metrics with other programs. All arithmetic is
that of integers, so the pictures are the same on every machine.

    python3 tests/python/metric_pictures.py FOLDER       writes FOLDER/a/view_000.ppm, ..., and the copies FOLDER/b/view_000.ppm, ...
"""

import pathlib
import sys

import numpy as np

COUNT, HEIGHT, WIDTH = 10, 176, 192  # sides that MS-SSIM can halve four times


def random_codes(seed, *places):
    """Returns an integer from 0 to 255 for each place: a hash of its coordinates."""
    value = np.full(places[0].shape, 3266489917 * (seed + 1), np.uint64)
    for place, factor in zip(places, (374761393, 668265263, 2246822519)):
        value += place.astype(np.uint64) * np.uint64(factor)
    for shift, factor in ((13, 1274126177), (16, 2654435761)):
        value &= np.uint64(0xFFFFFFFF)
        value = (value ^ (value >> np.uint64(shift))) * np.uint64(factor)
    return (value >> np.uint64(24) & np.uint64(0xFF)).astype(int)


def smooth_noise(seed, x, y, channel, cell):
    """Returns random codes on a grid of `cell` pixels, interpolated bilinearly."""
    u, v = x % cell, y % cell
    corner = lambda i, j: random_codes(seed, x // cell + i, y // cell + j, channel)
    above = (cell - u) * corner(0, 0) + u * corner(1, 0)
    below = (cell - u) * corner(0, 1) + u * corner(1, 1)
    return ((cell - v) * above + v * below) // cell**2


def scene(seed, with_disc=True):
    """Returns a picture with smooth and rough regions, stripes, and a disc with a sharp edge."""
    y, x, channel = np.mgrid[:HEIGHT, :WIDTH, :3]
    picture = sum(weight * smooth_noise(seed, x, y, channel, cell) for weight, cell in ((4, 48), (2, 12), (1, 3))) // 7
    stripes = (x // (2 + seed % 4) + y // 5) % 2 * 160 + 40
    picture = np.where((x > 120) & (y > 100 - 3 * seed), stripes, picture)
    disc = (x - 60 - 4 * seed) ** 2 + (y - 70) ** 2 < 34**2
    return np.where(disc & with_disc, 30 + 70 * channel + 8 * seed, picture)


def neighbours(picture):
    """Returns the nine pictures that are shifted by up to one pixel, with repeated edge pixels."""
    padded = np.pad(picture, [(1, 1), (1, 1), (0, 0)], mode="edge")
    return [padded[i : i + HEIGHT, j : j + WIDTH] for i in range(3) for j in range(3)]


def distorted(seed, a):
    y, x, channel = np.mgrid[:HEIGHT, :WIDTH, :3]
    blocks = a.reshape(HEIGHT // 8, 8, WIDTH // 8, 8, 3).sum(axis=(1, 3)) // 64
    return [
        lambda: a + random_codes(90, x, y, channel) // 8 - 16,
        lambda: sum(neighbours(a)) // 9,
        lambda: a // 32 * 32 + 16,
        lambda: a * 4 // 5 + 20,
        lambda: neighbours(a)[3],  # one pixel to the right
        lambda: (a + np.repeat(np.repeat(blocks, 8, 0), 8, 1)) // 2,
        lambda: np.where(x < WIDTH // 2, a, a[..., ::-1]),  # red and blue exchanged in the right half
        lambda: a * a // 255,
        lambda: np.where(random_codes(91, x, y) < 6, random_codes(92, x, y) // 128 * 255, a),  # black and white dots
        lambda: (a + scene(seed, with_disc=False)) // 2 + 1,  # a transparent disc
    ][seed]()


def pair(seed):
    reference = scene(seed)
    return [np.clip(picture, 0, 255).astype(np.uint8) for picture in (reference, distorted(seed, reference))]


def write_pairs(folder, pairs):
    for side, name in enumerate("ab"):
        (folder / name).mkdir(parents=True)
        for i, pictures in enumerate(pairs):
            content = b"P6 %d %d 255\n" % (WIDTH, HEIGHT) + pictures[side].tobytes()
            (folder / name / f"view_{i:03}.ppm").write_bytes(content)


if __name__ == "__main__":
    write_pairs(pathlib.Path(sys.argv[1]), [pair(seed) for seed in range(COUNT)])
