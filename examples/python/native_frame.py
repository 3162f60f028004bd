"""Renders the picture for a calibrated panel, in which each sub-pixel has its own ray."""
import sys

import lippmann

scene, calibration, picture = sys.argv[1:] if len(sys.argv) == 4 else sys.exit("usage: native_frame.py SCENE CALIBRATION OUT.png")
field = lippmann.render(scene, lippmann.display(calibration), layout="native", layers=["depth"])
print("pixels of the panel:", field.codes.shape, field.codes.dtype)
print("depth behind each:", field.panel_layer("depth").shape, "mm")
field.save(picture)
