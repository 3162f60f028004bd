"""Opens a light field in any format, refocuses it, renders what an eye sees and an epipolar-plane image, and converts it."""
import sys

import lippmann

path, folder = sys.argv[1:] if len(sys.argv) == 3 else sys.exit("usage: convert_refocus.py FILE FOLDER")
field = lippmann.open(path)
print(field)
near, far = field.refocus(z_mm=10), field.refocus(z_mm=-10)  # arrays (y, x, 3) of linear light
left = field.eye(x=-20)
line = field.epi(row=field.shape[2] // 2)
print("refocused:", near.shape, "eye:", left.shape, "epipolar-plane image:", line.shape)
print("sharpness:", lippmann.to_codes(near).std(), lippmann.to_codes(far).std())
field.save(folder, "stanford")
