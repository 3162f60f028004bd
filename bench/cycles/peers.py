"""Runs this program and Blender, and compares their pictures."""

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
PATH = "/usr/bin:/bin"
BLENDER = os.environ.get("BLENDER", "blender")  # path of the program Blender


class Failed(SystemExit):
    """A program failed. Ends the script with the message if it is not caught."""


def reason(text):
    """Returns the line of a program's output that states the error, or the last line."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    errors = [line for line in lines if re.match(r"(\w+\.)*\w*(Error|Exception)\b.*:", line) and not line.startswith(("Error: Python:", "Error: script failed"))]
    return (errors or lines or ["no message"])[-1]


def has_blender():
    if shutil.which(BLENDER, path=PATH):
        return True
    print("skipped: Blender is not installed (apt-get install blender)", file=sys.stderr)
    return False


def blender(script, words, mark):
    """Runs a script of this folder inside Blender. Returns the rest of each output line that begins with `mark`."""
    command = [BLENDER, "-b", "--python-exit-code", "1", "-P", HERE / script, "--", *words]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env={**os.environ, "PATH": PATH})
    found = [line.removeprefix(mark).strip() for line in done.stdout.splitlines() if line.startswith(mark)]
    if done.returncode or not found:
        raise Failed(f"Blender could not run {script}: {reason(done.stdout + done.stderr)}")
    return found


def info(tool, scene, *flags):
    done = subprocess.run([str(word) for word in (tool, "info", scene, *flags, "--json")], capture_output=True, text=True)
    if done.returncode:
        raise Failed(done.stderr.strip())
    return json.loads(done.stdout)


def with_camera(tool, asset, view, work):
    """Returns the file if it has a camera. Otherwise, returns a copy in the folder `work` with a camera that looks at
    the scene's centre. view: yaw and pitch of this camera in degrees."""
    found = info(tool, asset)
    if found["cameras"]:
        return asset
    copy, array = one_file.OneFile(asset), found["array"]
    copy.add_camera(*one_file.fitted(array, *view), 1.0, array["viewing_distance"])
    copy.write(work / f"{asset.stem}.glb")
    return work / f"{asset.stem}.glb"


def mse(tool, reference, test):
    done = subprocess.run([str(tool), "compare", str(reference), str(test), "--json"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    return json.loads(done.stdout)["mean"]["mse"]["mean"]


def decibels(mean_mse):
    return 10.0 * math.log10(255.0**2 / mean_mse) if mean_mse > 0 else math.inf


def psnr(tool, reference, test):
    return decibels(mse(tool, reference, test))
