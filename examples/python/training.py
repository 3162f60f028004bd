"""Yields endless training data: random scenes, seen by random cameras. The same seed gives the same data."""
import numpy as np

import lippmann

for field in lippmann.training_data(seed=7, count=3, rows=3, columns=3, size=(64, 64), spp=4):
    views, disparity = field.views, field.disparity
    print(views.shape, disparity.shape, "pixels:", np.round([disparity.min(), disparity.max()], 2))
display = lippmann.random_display(seed=7, size=(96, 128))
field = lippmann.render(lippmann.random_scene(seed=7, frames=5), display, frame=4, layout="native", spp=4)
print(display.name, field.picture.shape)
