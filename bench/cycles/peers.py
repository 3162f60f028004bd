"""What scripts that hold this program beside Blender share: running both, and comparing their pictures."""

import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

import one_file

HERE = pathlib.Path(__file__).resolve().parent
PATH = "/usr/bin:/bin"  # Blender's Python is Debian's, whatever else there is
BLENDER = os.environ.get("BLENDER", "blender")  # of another version, say


class Failed(SystemExit):
    """A program could not do what it was asked for. Ends a script that does not catch it, with its message."""


def reason(text):
    """Of what a program printed before it gave up, the line that says why, else the last one."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    told = [line for line in lines if re.match(r"(\w+\.)*\w*(Error|Exception)\b.*:", line) and not line.startswith(("Error: Python:", "Error: script failed"))]
    return (told or lines or ["it says nothing of why"])[-1]


def has_blender():
    """Says so where there is none."""
    if shutil.which(BLENDER, path=PATH):
        return True
    print("skipped: Blender is not installed (apt-get install blender)", file=sys.stderr)
    return False


def blender(script, words, mark):
    """Runs a script of this folder inside Blender; what follows `mark` on the lines of its output that begin with that."""
    command = [BLENDER, "-b", "--python-exit-code", "1", "-P", HERE / script, "--", *words]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env={**os.environ, "PATH": PATH})
    found = [line.removeprefix(mark).strip() for line in done.stdout.splitlines() if line.startswith(mark)]
    if done.returncode or not found:
        raise Failed(f"Blender could not run {script}: {reason(done.stdout + done.stderr)}")
    return found


def info(tool, scene, *flags):
    """What `lippmann info` says."""
    done = subprocess.run([str(word) for word in (tool, "info", scene, *flags, "--json")], capture_output=True, text=True)
    if done.returncode:
        raise Failed(done.stderr.strip())
    return json.loads(done.stdout)


def with_camera(tool, asset, view, work):
    """The file, or a copy in the folder `work` that has a camera. view: yaw and pitch in degrees from which it looks at the file's middle."""
    found = info(tool, asset)
    if found["cameras"]:
        return asset
    copy, array = one_file.OneFile(asset), found["array"]
    copy.add_camera(*one_file.fitted(array, *view), 1.0, array["viewing_distance"])
    copy.write(work / f"{asset.stem}.glb")
    return work / f"{asset.stem}.glb"


def mse(tool, reference, test):
    """Of the 8-bit sRGB codes of two pictures."""
    done = subprocess.run([str(tool), "compare", str(reference), str(test), "--json"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    return json.loads(done.stdout)["mean"]["mse"]["mean"]


def decibels(mean_mse):
    return 10.0 * math.log10(255.0**2 / mean_mse) if mean_mse > 0 else math.inf


def psnr(tool, reference, test):
    return decibels(mse(tool, reference, test))
