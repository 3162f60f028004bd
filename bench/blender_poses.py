#!/usr/bin/python3
"""Compares the vertices of skinned and morphed meshes in glTF files with those that Blender computes.

  bench/blender_poses.py FILE.glb ... [--times N] [--bar FRACTION] [--tool PATH] [--json]

The error is the largest distance from a vertex of one program to the nearest vertex of the
other program, as a fraction of the diagonal of the bounds. The exit code is 1 if an error exceeds
--bar. Needs Debian's blender and python3-numpy, and the build target dump_pose.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def compare(file, tool, times):
    command = ["blender", "-b", "--python-exit-code", "1", "-P", HERE / "cycles" / "poses_inside_blender.py", "--", file, tool, times]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          env={**os.environ, "PATH": "/usr/bin:/bin"})  # Blender needs Debian's Python
    rows = [json.loads(line.removeprefix("POSES ")) for line in done.stdout.splitlines() if line.startswith("POSES ")]
    if done.returncode or not rows:
        raise SystemExit(f"Blender could not compare {file}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return [{"file": file.name, **row} for row in rows]


def show(row, bar):
    if "skipped" in row:
        print("{file:24} {animation:12} skipped: {skipped}".format(**row), flush=True)
        return
    verdict = "ok" if row["error"] <= bar else f"ABOVE {bar:g} at {row['at_seconds']:.4f} s"
    print("{file:24} {animation:12} {vertices:7} vertices, {times} times, moving {moved:.2f}: error {error:.1e} "
          "({error_without_slerp:.1e} without slerp)  ".format(**row) + verdict, flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="FILE", type=pathlib.Path)
    parser.add_argument("--times", type=int, default=10)
    parser.add_argument("--bar", type=float, default=1e-4)
    parser.add_argument("--tool", type=pathlib.Path, default=HERE.parent / "build" / "release" / "dump_pose")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    if not shutil.which("blender", path="/usr/bin:/bin"):
        print("skipped: Blender is not installed (apt-get install blender)", file=sys.stderr)
        return
    if options.times < 1:
        parser.error("--times must be at least 1")
    for path in [options.tool, *options.files]:
        if not path.is_file():
            raise SystemExit(f"no such file: {path}")
    rows = []
    for file in options.files:
        found = compare(file.resolve(), options.tool.resolve(), options.times)
        rows += found
        if not options.json:
            for row in found:
                show(row, options.bar)
    if options.json:
        print(json.dumps({"bench": "blender_poses", "bar": options.bar, "rows": rows}, indent=2))
    if any(not row.get("error", 0.0) <= options.bar for row in rows):
        raise SystemExit(1)


main()
