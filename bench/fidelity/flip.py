"""Computes FLIP: how different two pictures look if a viewer alternates between them, from 0 to 1
per pixel.

Based on Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A
Difference Evaluator for Alternating Images", 2020. Section numbers are those of the paper.
"""

import numpy as np

PIXELS_PER_DEGREE = 67.0206  # the paper's viewing conditions: 0.7 m from a monitor that is 0.7 m wide and has 3840 pixels
RGB_TO_XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                       [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                       [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = RGB_TO_XYZ.sum(axis=1)
COLOR_POWER, COLOR_SPLIT, COLOR_SHARE, FEATURE_POWER = 0.7, 0.4, 0.95, 0.5
FEATURE_WIDTH_DEG = 0.082
# Contrast sensitivity of the eye for lightness, red-green and blue-yellow. A pair (a, b) is the Gaussian a sqrt(pi / b)
# exp(-(pi x)^2 / b), with the distance x in degrees.
SENSITIVITY = (((1.0, 0.0047),), ((1.0, 0.0053),), ((34.1, 0.04), (13.5, 0.025)))
WIDEST = 0.04


def linear(codes):
    return np.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055)**2.4)


def opponent(rgb):
    """Returns the YCxCz values of a picture (h, w, 3) of linear RGB."""
    x, y, z = np.moveaxis(rgb @ RGB_TO_XYZ.T / WHITE, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def from_opponent(ycc):
    y = (ycc[..., 0] + 16) / 116
    xyz = np.stack([y + ycc[..., 1] / 500, y, y - ycc[..., 2] / 200], axis=-1) * WHITE
    return xyz @ np.linalg.inv(RGB_TO_XYZ).T


def hunt_lab(rgb):
    """Returns L*, a* and b* of linear RGB, with a* and b* scaled by the lightness (Hunt effect)."""
    part = rgb @ RGB_TO_XYZ.T / WHITE
    edge = 6 / 29
    root = np.where(part > edge**3, np.cbrt(part), part / (3 * edge**2) + 4 / 29)
    lightness = 116 * root[..., 1] - 16
    scale = 0.01 * lightness
    return np.stack([lightness, scale * 500 * (root[..., 0] - root[..., 1]), scale * 200 * (root[..., 1] - root[..., 2])], axis=-1)


def hyab(a, b):
    d = a - b
    return np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def along(picture, kernel, axis):
    """Convolves along an axis, with repeated border pixels."""
    radius = len(kernel) // 2
    pad = [(radius, radius) if i == axis else (0, 0) for i in range(picture.ndim)]
    wide, size = np.pad(picture, pad, mode="edge"), picture.shape[axis]
    return sum(k * np.take(wide, range(i, i + size), axis=axis) for i, k in enumerate(kernel))


def as_seen(channel, gaussians):
    radius = int(np.ceil(3 * np.sqrt(WIDEST / (2 * np.pi**2)) * PIXELS_PER_DEGREE))
    degrees = np.arange(-radius, radius + 1) / PIXELS_PER_DEGREE
    total, weight = 0.0, 0.0
    for a, b in gaussians:
        kernel = np.exp(-(np.pi * degrees)**2 / b)
        scale = a * np.sqrt(np.pi / b)
        total, weight = total + scale * along(along(channel, kernel, 0), kernel, 1), weight + scale * kernel.sum()**2
    return total / weight


def color_difference(a, b):
    """Returns the colour differences between two YCxCz pictures, from 0 to 1."""
    seen = [np.stack([as_seen(p[..., i], SENSITIVITY[i]) for i in range(3)], axis=-1) for p in (a, b)]
    labs = [hunt_lab(np.clip(from_opponent(p), 0, 1)) for p in seen]
    most = hyab(*hunt_lab(np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])))**COLOR_POWER
    error, split = hyab(*labs)**COLOR_POWER, COLOR_SPLIT * most
    return np.where(error < split, COLOR_SHARE * error / split, COLOR_SHARE + (1 - COLOR_SHARE) * (error - split) / (most - split))


def features(lightness):
    deviation = 0.5 * FEATURE_WIDTH_DEG * PIXELS_PER_DEGREE
    x = np.arange(-int(np.ceil(3 * deviation)), int(np.ceil(3 * deviation)) + 1)
    bell = np.exp(-x**2 / (2 * deviation**2))
    found = []
    for kernel in (-x * bell, (x**2 / deviation**2 - 1) * bell):
        kernel = np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), -kernel / kernel[kernel < 0].sum())
        across = [along(along(lightness, kernel, axis), bell / bell.sum(), 1 - axis) for axis in (0, 1)]
        found.append(np.hypot(*across))
    return found


def difference(a, b):
    """Returns the FLIP map (h, w) of two pictures (h, w, 3) of 8-bit sRGB codes."""
    pictures = [opponent(linear(p.astype(float) / 255)) for p in (a, b)]
    (edge_a, point_a), (edge_b, point_b) = [features((p[..., 0] + 16) / 116) for p in pictures]
    feature = (np.maximum(np.abs(edge_a - edge_b), np.abs(point_a - point_b)) / np.sqrt(2))**FEATURE_POWER
    return color_difference(*pictures)**(1 - np.clip(feature, 0, 1))
