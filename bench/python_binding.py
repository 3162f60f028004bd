#!/usr/bin/python3
"""Compares the CPU time of a render by the Python package with that of the tool. Both render the
same frame to a file, alternately.

  PYTHONPATH=build/release/python bench/python_binding.py build/release/lippmann [RUNS]

Prints the medians of user CPU seconds, of whole processes and of rendering alone, and the peak
memory of both. The pictures must have the same bytes.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

SCENE, DISPLAY, FRAME, SPP = "room", "looking-glass-portrait", 9, 1
OWN = """
import json, sys, lippmann
field = lippmann.render(sys.argv[1], sys.argv[2], frame=int(sys.argv[3]), spp=int(sys.argv[4]), threads=1)
field.save(sys.argv[5])
print(json.dumps(field.report["cpu_seconds"]))
"""


def measured(command):
    """Runs a command. Returns its user CPU seconds, its peak memory in MB, and its output."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{command} failed")
    return usage.ru_utime, usage.ru_maxrss / 1024, json.loads(output)


def main():
    tool, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 7
    what = [SCENE, DISPLAY, str(FRAME), str(SPP)]
    start = measured([sys.executable, "-c", "import lippmann; print(0)"])[0]
    figures = {"tool": [], "python": []}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for _ in range(runs):
            options = ["--display", DISPLAY, "--frames", str(FRAME), "--spp", str(SPP), "--threads", "1", "--force", "--json"]
            user, memory, report = measured([tool, "render", SCENE, *options, "-o", str(folder / "tool")])
            figures["tool"].append((user, report["totals"]["cpu_seconds"], memory))
            figures["python"].append(measured([sys.executable, "-c", OWN, *what, str(folder / "own.png")]))
        (picture,) = (folder / "tool").glob("frame_*.png")
        if picture.read_bytes() != (folder / "own.png").read_bytes():
            sys.exit("the pictures differ")
    figures["python"] = [(user, cpu, memory) for user, memory, cpu in figures["python"]]
    median = {who: [statistics.median(run[i] for run in rows) for i in range(3)] for who, rows in figures.items()}
    print(f"{SCENE} on {DISPLAY}, {SPP} samples per pixel, one thread, medians of {runs} runs in turns")
    print(f"{'':28}{'tool':>9}{'python':>9}{'ratio':>8}")
    for i, name in enumerate(("process, user CPU s", "rendering alone, CPU s", "largest memory, MB")):
        one, other = median["tool"][i], median["python"][i]
        print(f"{name:28}{one:9.3f}{other:9.3f}{other / one:8.3f}")
    print(f"{'starting Python, user CPU s':28}{'':9}{start:9.3f}")


if __name__ == "__main__":
    main()
