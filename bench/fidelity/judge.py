"""Each renderer's picture of a scenario against the median of the others'.

Pixels count that any of the pictures covers: an empty background says nothing of a renderer. Pictures are RGBA codes (pictures.py), compared before a plain grey.
"""

import math

import flip
import numpy as np
import pictures


def decibels(mean_square):
    return 10.0 * math.log10(255.0**2 / mean_square) if mean_square > 0 else math.inf


def psnr(a, b, counted):
    """Of RGB codes, over the pixels that count."""
    return decibels(np.mean((a[counted].astype(float) - b[counted])**2))


def noise(few, many, times):
    """The mean square that noise has in the picture of `times` as many samples, from its difference to one of other noise. An upper bound where
    samples are spread so well that noise falls faster than by their number."""
    counted = (few[..., 3] > 0) | (many[..., 3] > 0)
    a, b = pictures.before_grey(few).astype(float), pictures.before_grey(many)
    return float(np.mean((a[counted] - b[counted])**2) / (times + 1)) if counted.any() else 0.0


def noise_together(facts):
    """The PSNR that two pictures would have which differ by the noise of both alone."""
    return decibels(sum(value for name, value in facts.items() if name in ("lippmann_noise", "cycles_noise")))


def median_of(others):
    """Per pixel and channel; of two pictures, the mean."""
    return np.round(np.median(np.stack(others), axis=0)).astype(np.uint8)


def counted_pixels(named):
    """Those that any of the pictures covers."""
    counted = np.any([p[..., 3] > 0 for p in named.values()], axis=0)
    if not counted.any():
        raise SystemExit("no renderer's picture shows anything but the background: does the camera see the model?")
    return counted


def among_others(named, own):
    """The PSNR that the others have against one another: of the mean square of each against the median of the rest of them. None of fewer than two."""
    counted = counted_pixels(named)
    flat = [pictures.before_grey(p) for name, p in named.items() if name != own]
    if len(flat) < 2:
        return None
    rests = [median_of(flat[:i] + flat[i + 1:]) for i in range(len(flat))]
    return decibels(float(np.mean([np.mean((p[counted].astype(float) - rest[counted])**2) for p, rest in zip(flat, rests)])))


def judged(named):
    """{renderer: {"psnr_db", "flip", "map", "median"}} of {renderer: RGBA picture}, all of one size; needs two pictures or more.

    flip: the mean over what counts of the map (h, w) of differences, 0 to 1.
    """
    counted = counted_pixels(named)
    flat = {name: pictures.before_grey(p) for name, p in named.items()}
    rows = {}
    for name, picture in flat.items():
        median = median_of([other for key, other in flat.items() if key != name])
        difference = flip.difference(median, picture)
        rows[name] = {"psnr_db": psnr(picture, median, counted), "flip": float(difference[counted].mean()), "map": difference, "median": median}
    return rows
