#!/usr/bin/python3
"""Compares light-field animations with Blender's Cycles. Our program renders and denoises all 48
views together; Cycles renders view by view.

  bench/cycles_light_field.py [--asset FILE.glb] [--panorama FILE.hdr] [--view YAW PITCH] [--frames N] [--size N] [--spp N]
                              [--reference-spp N] [--levels N N N] [--output DIR] [--tool PATH] [--threads N] [--json]

The PSNR between the converged views of both programs must be at least 30 dB. The PSNR of each program is measured
against its own converged views, in 8-bit sRGB codes. The CPU time that Cycles needs for our
PSNR is interpolated between measured numbers of samples.

Our time includes set-up, denoising and files. The time of Cycles includes only rendering, and is
measured for a few views. Needs Debian's blender and python3-numpy. A file without a camera must
be .glb, and gets a camera that looks at its centre from YAW and PITCH degrees.
"""

import argparse
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "cycles"))
import fixtures  # noqa: E402
import peers  # noqa: E402

HERE = pathlib.Path(__file__).parent
VERTICES = 8
COLUMNS, ROWS, CONE_DEG = 8, 6, 40.0
VIEWS = COLUMNS * ROWS
FAN = VIEWS // 3  # number of eyes if only every third view is used
LIKENESS_DB = 30.0
BAR = 20.0


class LightField:

    def __init__(self, options, work):
        self.options, self.work = options, work
        self.scene = options.asset or work / "moving-room.gltf"
        if not options.asset:
            fixtures.moving_room().write(self.scene)
        self.scene = peers.with_camera(options.tool, self.scene, options.view, work)
        info = peers.info(options.tool, self.scene, *self.optics())
        self.array, self.fps = info["array"], info["frames_per_second"]
        self.frames = min(options.frames, info["frames"])
        self.compared_frames = sorted({0, self.frames - 1})
        self.compared_views = [self.quilt_view(i * (FAN - 1) // (options.compared_views - 1)) for i in range(options.compared_views)]

    @staticmethod
    def quilt_view(in_fan):
        return 3 * in_fan + 1

    def optics(self, columns=COLUMNS, rows=ROWS):
        return ["--optics", "multiview", "--views", f"{columns}x{rows}", "--view-angle", CONE_DEG,
                "--size", f"{columns * self.options.size}x{rows * self.options.size}"]

    def eyes(self):
        """Returns the x of each eye relative to the camera (right is positive), from left to right."""
        return [self.array["viewing_distance"] * math.tan(math.radians(CONE_DEG) * ((v + 0.5) / VIEWS - 0.5)) for v in range(VIEWS)]

    def compared(self):
        return [(f, v) for f in self.compared_frames for v in self.compared_views]


def ours(field, optics, folder, frames, spp, *more):
    options = field.options
    command = [options.tool, "render", field.scene, *optics, "--integrator", "path", "--spp", spp, "--frames", frames, "--layout", "views",
               "--max-depth", VERTICES, "--format", "exr", "--exr-pixels", "float", "--threads", options.threads, "-o", folder, *more]
    if options.panorama:
        command += ["--environment", options.panorama]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def our_view(folder, frame, view):
    return folder / f"frame_{frame:04}" / f"view_{view:03}.exr"


def their_view(folder, samples, frame, view):
    return folder / f"{samples}_{frame:04}_{view:03}.exr"


def cycles(field, folder, levels, reference_spp):
    """Returns {number of samples: (mean CPU seconds of the first view of a frame, mean CPU seconds of its other
    views)}."""
    options = field.options
    renders = [{"frame": f, "view": v, "samples": s, "seed": 99 if s == reference_spp else 7, "out": str(their_view(folder, s, f, v))}
               for s in (*levels, reference_spp) for f, v in field.compared()]
    job = {"file": str(field.scene), "panorama": options.panorama and str(options.panorama), "width": options.size, "height": options.size,
           "vertices": VERTICES, "threads": options.threads, "frames_per_second": field.fps, "distance": field.array["viewing_distance"],
           "window_height": field.array["height"], "eyes": field.eyes(), "renders": renders}
    file = field.work / "job.json"
    file.write_text(json.dumps(job))
    done = [json.loads(line) for line in peers.blender("views_inside_blender.py", [file], "VIEW")]

    def mean_seconds(samples, first):
        found = [r["cpu_seconds"] for r in done if r["samples"] == samples and (r["view"] == field.compared_views[0]) == first]
        return sum(found) / len(found)

    return {s: (mean_seconds(s, True), mean_seconds(s, False)) for s in levels}


def mean_psnr(field, reference_of, test_of):
    errors = [peers.mse(field.options.tool, reference_of(f, v), test_of(f, v)) for f, v in field.compared()]
    return peers.decibels(sum(errors) / len(errors))


def seconds_at(psnr, levels):
    """Returns the seconds for a PSNR, interpolated or extrapolated from the (dB, seconds) pairs in `levels`, in
    ascending order."""
    after = next((i for i in range(1, len(levels) - 1) if levels[i][0] >= psnr), len(levels) - 1)
    (a, start), (b, end) = levels[after - 1], levels[after]
    return start * (end / start) ** ((psnr - a) / (b - a))


def measure(field):
    options, work = field.options, field.work
    mine, mine_converged, theirs = work / "ours", work / "ours-converged", work / "cycles"
    theirs.mkdir(parents=True, exist_ok=True)
    seconds = ours(field, field.optics(), mine, f"0-{field.frames - 1}", options.spp)
    for frame in field.compared_frames:
        ours(field, field.optics(FAN, 1), mine_converged, f"{frame}-{frame}", options.reference_spp, "--denoise", "none", "--seed", 1)
    costs = cycles(field, theirs, options.levels, options.reference_spp)

    converged = lambda f, v: our_view(mine_converged, f, (v - 1) // 3)
    their_converged = lambda f, v: their_view(theirs, options.reference_spp, f, v)
    likeness = mean_psnr(field, their_converged, converged)
    if likeness < LIKENESS_DB:
        raise SystemExit(f"the converged views of both agree only at {likeness:.2f} dB, too little to compare")
    psnr = mean_psnr(field, converged, lambda f, v: our_view(mine, f, v))
    levels = []
    for spp in options.levels:
        first, other = costs[spp]
        levels.append({"spp": spp, "psnr_db": mean_psnr(field, their_converged, lambda f, v: their_view(theirs, spp, f, v)),
                       "cpu_seconds": field.frames * (first + (VIEWS - 1) * other)})
    their_seconds = seconds_at(psnr, [(level["psnr_db"], level["cpu_seconds"]) for level in levels])
    return {"scene": field.scene.name, "frames": field.frames, "views": VIEWS, "size": options.size, "likeness_db": likeness,
            "spp": options.spp, "psnr_db": psnr, "cpu_seconds": seconds, "cycles": levels, "cycles_cpu_seconds": their_seconds,
            "ratio": their_seconds / seconds, "extrapolated": not levels[0]["psnr_db"] <= psnr <= levels[-1]["psnr_db"]}


def show(row):
    print("{scene}: {frames} frames of {views} views of {size} x {size} pixels".format(**row))
    print("  converged views of both agree at {likeness_db:.2f} dB (at least 30)".format(**row))
    for level in row["cycles"]:
        print("  Cycles {spp:5} samples {psnr_db:6.2f} dB {cpu_seconds:9.1f} CPU s".format(**level))
    print("  ours   {spp:5} samples {psnr_db:6.2f} dB {cpu_seconds:9.1f} CPU s".format(**row))
    beyond = ", extrapolated" if row["extrapolated"] else ""
    print(f"  Cycles at our PSNR: {row['cycles_cpu_seconds']:.1f} CPU s{beyond} = {row['ratio']:.2f} x (bar {BAR:.0f} x)")


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--asset", type=pathlib.Path)
    parser.add_argument("--panorama", type=pathlib.Path)
    parser.add_argument("--view", type=float, nargs=2, default=(25.0, 15.0), metavar=("YAW", "PITCH"))
    parser.add_argument("--frames", type=int, default=4)
    parser.add_argument("--size", type=int, default=96, help="pixels per side of a view")
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--reference-spp", type=int, default=1024)
    parser.add_argument("--levels", type=int, nargs="+", default=[32, 128, 512], help="numbers of samples for Cycles")
    parser.add_argument("--compared-views", type=int, default=4)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--output", type=pathlib.Path)
    parser.add_argument("--tool", type=pathlib.Path, default=HERE.parent / "build" / "release" / "lippmann")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    options.levels.sort()
    if len(set(options.levels)) < 2 or options.levels[0] < 1 or options.reference_spp in options.levels:
        parser.error("--levels needs at least two numbers of samples other than --reference-spp")
    if not 2 <= options.compared_views <= FAN or options.frames < 1:
        parser.error(f"--compared-views must be 2 to {FAN}, --frames at least 1")
    return options


def main():
    options = parse()
    if not peers.has_blender():
        return
    with tempfile.TemporaryDirectory() as temporary:
        work = (options.output or pathlib.Path(temporary)).resolve()
        work.mkdir(parents=True, exist_ok=True)
        row = measure(LightField(options, work))
    if options.json:
        print(json.dumps({"bench": "cycles_light_field", "bar": BAR, "rows": [row]}, indent=2))
    else:
        show(row)


main()
