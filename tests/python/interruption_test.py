"""Tests that Ctrl-C raises KeyboardInterrupt soon, and that the library works afterwards."""

import os
import signal
import subprocess
import sys

from support import Case

RENDER = """
import sys, time, lippmann
grid = lippmann.camera_grid(5, 5, (800, 800))
def started(frame, share):
    if share > 0 and not calls:
        calls.append(1)
        print("started", flush=True)
calls = []
try:
    lippmann.render("room", grid, spp=64, progress=started)
    print("finished", flush=True)
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(lippmann.render("room", lippmann.camera_grid(1, 2, (8, 8))).shape, flush=True)
"""

LOOK = """
import os, signal, sys, threading, numpy as np, lippmann
field = lippmann.LightField(np.full((100, 100, 4, 4, 3), 128, np.uint8), distance_mm=500, baseline_mm=1, pixel_mm=10)
field.eye(size=(8, 8)), field.refocus(7, size=(8, 8))
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    field.{what}
    print("finished", flush=True)
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(field.eye(size=(8, 8)).mean() > 0.1, field.refocus(7, size=(8, 8)).mean() > 0.1, flush=True)
"""


class Interruption(Case):
    def test_ctrl_c_ends_eye_and_refocus(self):
        for what in ("eye(pupil_mm=30, crosstalk=8, size=(2000, 2000))", "refocus(7, size=(6000, 6000))"):
            with self.subTest(what):
                done = subprocess.run([sys.executable, "-c", LOOK.format(what=what)], stdout=subprocess.PIPE, text=True)
                self.assertEqual((done.stdout, done.returncode), ("interrupted\nTrue True\n", 0))

    def test_ctrl_c_stops_a_render(self):
        with subprocess.Popen([sys.executable, "-c", RENDER], stdout=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), "started\n")
            os.kill(process.pid, signal.SIGINT)
            output = process.stdout.read()
            self.assertEqual(output, "interrupted\n(1, 2, 8, 8, 3)\n")
        self.assertEqual(process.returncode, 0)
