"""Compares each renderer's picture of a scenario with the median of the other renderers' pictures.
All pictures are placed in front of plain grey.

Only pixels that are covered in at least one picture count, because all renderers agree about an
empty background.
"""

import math

import flip
import numpy as np
import pictures


def decibels(mean_square):
    return 10.0 * math.log10(255.0**2 / mean_square) if mean_square > 0 else math.inf


def psnr(a, b, counted):
    """counted: mask of the compared pixels."""
    return decibels(np.mean((a[counted].astype(float) - b[counted])**2))


def noise(few, many, times):
    """Returns the mean squared noise of the picture `many`, from its difference to `few`, which has independent noise
    and 1 / `times` of the samples. For stratified samples, the result is an upper bound."""
    counted = (few[..., 3] > 0) | (many[..., 3] > 0)
    a, b = pictures.before_grey(few).astype(float), pictures.before_grey(many)
    return float(np.mean((a[counted] - b[counted])**2) / (times + 1)) if counted.any() else 0.0


def noise_together(facts):
    """Returns the PSNR in dB of two pictures that differ only by their noise."""
    return decibels(sum(value for name, value in facts.items() if name in ("lippmann_noise", "cycles_noise")))


def median_of(others):
    return np.round(np.median(np.stack(others), axis=0)).astype(np.uint8)


def counted_pixels(named):
    counted = np.any([p[..., 3] > 0 for p in named.values()], axis=0)
    if not counted.any():
        raise SystemExit("all pictures show only the background; check that the camera sees the model")
    return counted


def among_others(named, own):
    """Compares the pictures of all renderers except `own`: each picture with the median of the rest. Returns the PSNR
    of the mean error in dB, or None for fewer than two pictures."""
    counted = counted_pixels(named)
    flat = [pictures.before_grey(p) for name, p in named.items() if name != own]
    if len(flat) < 2:
        return None
    rests = [median_of(flat[:i] + flat[i + 1:]) for i in range(len(flat))]
    return decibels(float(np.mean([np.mean((p[counted].astype(float) - rest[counted])**2) for p, rest in zip(flat, rests)])))


def judged(named):
    """Returns {renderer: {"psnr_db", "flip", "map", "median"}} for two or more RGBA pictures of
    equal size.

    "map" contains the FLIP differences (h, w), from 0 to 1. "flip" is their mean over the
    counted pixels.
    """
    counted = counted_pixels(named)
    flat = {name: pictures.before_grey(p) for name, p in named.items()}
    rows = {}
    for name, picture in flat.items():
        median = median_of([other for key, other in flat.items() if key != name])
        difference = flip.difference(median, picture)
        rows[name] = {"psnr_db": psnr(picture, median, counted), "flip": float(difference[counted].mean()), "map": difference, "median": median}
    return rows
