"""Builds a scene from arrays: a pyramid that rotates above a floor. Renders it as an animation in memory."""
import numpy as np

import lippmann

scene = lippmann.Scene("pyramid", frames=12)
corners = [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1], [0, 1.5, 0]]
red, floor = lippmann.Material((0.8, 0.1, 0.1), roughness=0.3), lippmann.Material((0.6, 0.6, 0.7))
pyramid = scene.add_mesh(corners, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], material=red)
turns = np.array([[0, np.sin(a / 2), 0, np.cos(a / 2)] for a in np.linspace(0, np.pi, 12)])  # quaternions x, y, z, w
pyramid.animate(rotation=turns)
scene.add_plane((0, -0.01, 0), material=floor)
scene.add_light("spot", position=(3, 5, 4), target=(0, 0, 0), intensity=60)
scene.add_camera((0, 2, 6), target=(0, 0.6, 0))
for field in lippmann.frames(scene, lippmann.camera_grid(size=(96, 96)), spp=8, progress=lambda frame, share: None):
    print(field.report["frame"], field.views.mean())
