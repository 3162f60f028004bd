"""Renders a light field of a scene with depth, disparity, normals and motion as arrays."""
import sys

import lippmann

scene, folder = sys.argv[1:] if len(sys.argv) == 3 else sys.exit("usage: render_layers.py SCENE FOLDER")
cameras = lippmann.camera_grid(rows=5, columns=5, size=(120, 160), baseline_mm=8)
field = lippmann.render(scene, cameras, frame=40, layers=["depth", "normal", "motion"], spp=4)
print("views (rows, columns, y, x, channel):", field.views.shape, field.views.dtype)
print("depth:", field.depth.shape, "disparity, pixels:", field.disparity.min(), "to", field.disparity.max())
print("normals:", field.normals.shape, "motion:", field.motion.shape)
field.save(folder, "hci")  # the format of the HCI benchmark, with depth and disparity
