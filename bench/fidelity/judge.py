"""Compares each renderer's picture of a scenario with the median of the other renderers' pictures.

Only pixels that some picture covers count: an empty background says nothing about a renderer. Pictures are RGBA codes (pictures.py),
compared over plain grey.
"""

import math

import flip
import numpy as np
import pictures


def decibels(mean_square):
    return 10.0 * math.log10(255.0**2 / mean_square) if mean_square > 0 else math.inf


def psnr(a, b, counted):
    """Returns the PSNR of RGB codes over the pixels in the mask `counted`."""
    return decibels(np.mean((a[counted].astype(float) - b[counted])**2))


def noise(few, many, times):
    """Returns the mean square of the noise in the picture of `times` as many samples, from its difference to one with independent noise. An
    upper bound if samples are stratified, since noise then falls faster than with their number."""
    counted = (few[..., 3] > 0) | (many[..., 3] > 0)
    a, b = pictures.before_grey(few).astype(float), pictures.before_grey(many)
    return float(np.mean((a[counted] - b[counted])**2) / (times + 1)) if counted.any() else 0.0


def noise_together(facts):
    """Returns the PSNR of two pictures that differ only by the noise of both."""
    return decibels(sum(value for name, value in facts.items() if name in ("lippmann_noise", "cycles_noise")))


def median_of(others):
    """Returns the median per pixel and channel; the mean for two pictures."""
    return np.round(np.median(np.stack(others), axis=0)).astype(np.uint8)


def counted_pixels(named):
    """Returns the pixels that any of the pictures covers."""
    counted = np.any([p[..., 3] > 0 for p in named.values()], axis=0)
    if not counted.any():
        raise SystemExit("all pictures show only the background; check that the camera sees the model")
    return counted


def among_others(named, own):
    """Returns the PSNR of the others among each other: the mean square of each against the median of the rest. None for fewer than two."""
    counted = counted_pixels(named)
    flat = [pictures.before_grey(p) for name, p in named.items() if name != own]
    if len(flat) < 2:
        return None
    rests = [median_of(flat[:i] + flat[i + 1:]) for i in range(len(flat))]
    return decibels(float(np.mean([np.mean((p[counted].astype(float) - rest[counted])**2) for p, rest in zip(flat, rests)])))


def judged(named):
    """Returns {renderer: {"psnr_db", "flip", "map", "median"}} for {renderer: RGBA picture}; needs two or more pictures of one size.

    flip: the mean over the counted pixels of the map (h, w) of differences, 0 to 1.
    """
    counted = counted_pixels(named)
    flat = {name: pictures.before_grey(p) for name, p in named.items()}
    rows = {}
    for name, picture in flat.items():
        median = median_of([other for key, other in flat.items() if key != name])
        difference = flip.difference(median, picture)
        rows[name] = {"psnr_db": psnr(picture, median, counted), "flip": float(difference[counted].mean()), "map": difference, "median": median}
    return rows
