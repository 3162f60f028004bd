"""Ctrl-C: KeyboardInterrupt soon, in a process of its own, and all goes on after it."""

import os
import signal
import subprocess
import sys

from support import Case

PROGRAM = """
import sys, time, lippmann
grid = lippmann.camera_grid(5, 5, (800, 800))
def started(frame, share):
    if share > 0 and not told:
        told.append(1)
        print("started", flush=True)
told = []
try:
    lippmann.render("room", grid, spp=64, progress=started)
    print("finished", flush=True)
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(lippmann.render("room", lippmann.camera_grid(1, 2, (8, 8))).shape, flush=True)
"""


class Interruption(Case):
    def test_ctrl_c_raises_keyboard_interrupt_and_the_library_still_works(self):
        with subprocess.Popen([sys.executable, "-c", PROGRAM], stdout=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), "started\n")
            os.kill(process.pid, signal.SIGINT)
            said = process.stdout.read()
            self.assertEqual(said, "interrupted\n(1, 2, 8, 8, 3)\n")
        self.assertEqual(process.returncode, 0)
