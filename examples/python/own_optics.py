"""Renders with optics that are defined by a function: a pinhole camera with the distortion of a wide-angle lens."""

import numpy as np

import lippmann


def barrel(points, height=240, eye_mm=300.0, bent=2e-5):
    x, y = (points[:, 0] - height / 2) * 0.5, (height / 2 - points[:, 1]) * 0.5  # mm from the middle, y upwards
    wider = 1 + bent * (x * x + y * y)
    directions = np.stack([x * wider, y * wider, np.full_like(x, -eye_mm)], axis=1)
    return np.tile([0.0, 0.0, eye_mm], (len(points), 1)), directions


lippmann.render("room", lippmann.own_optics(barrel, (240, 240), pixel_mm=0.5), frame=40).save("barrel.png")
