#!/usr/bin/python3
"""Compares path tracing with Blender's Cycles. Prints the PSNR between both programs, and the
samples per CPU second of each.

  bench/cycles_peers.py [NAME ...] [--size N] [--spp N] [--output DIR] [--tool PATH] [--threads N] [--json]

The scenes are those of bench/cycles/fixtures.py. PSNR is computed from 8-bit sRGB codes. The
CPU seconds of an eighth of the samples are subtracted from those of all samples, which excludes
the set-up. Needs Debian's blender and python3-numpy.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "cycles"))
import fixtures  # noqa: E402
import peers  # noqa: E402

HERE = pathlib.Path(__file__).parent
VERTICES = 8


def ours(tool, scene, panorama, size, spp, folder, threads):
    command = [tool, "render", scene, "--optics", "single", "--size", f"{size}x{size}", "--integrator", "path", "--denoise", "none", "--spp", spp, "--frames",
               "0-0", "--max-depth", VERTICES, "--format", "exr", "--exr-pixels", "float", "--threads", threads, "-o", folder]
    if panorama:
        command += ["--environment", panorama]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads((folder / "report.json").read_text())["frames"][0]["cpu_seconds"]


def cycles(scene, panorama, size, spp, out, threads):
    words = [scene, out, size, size, spp, VERTICES, threads, 7] + ([panorama] if panorama else [])
    return float(peers.blender("inside_blender.py", words, "CYCLES_SECONDS")[0])


def measure(name, scene, panorama, bar, options, work):
    few = max(1, options.spp // 8)
    folder = work / name
    folder.mkdir(parents=True, exist_ok=True)
    seconds = ours(options.tool, scene, panorama, options.size, options.spp, folder / "ours", options.threads)
    seconds -= ours(options.tool, scene, panorama, options.size, few, folder / "ours-few", options.threads)
    theirs = cycles(scene, panorama, options.size, options.spp, folder / "cycles.exr", options.threads)
    theirs -= cycles(scene, panorama, options.size, few, folder / "cycles-few.exr", options.threads)
    samples = (options.spp - few) * options.size**2
    row = {"scene": name, "psnr_db": peers.psnr(options.tool, folder / "cycles.exr", folder / "ours" / "frame_0000.exr"), "bar_db": bar,
           "ours_msamples_s": samples / seconds * 1e-6, "cycles_msamples_s": samples / theirs * 1e-6, "speed_ratio": theirs / seconds}
    if not options.json:
        print("{scene:14} {psnr_db:6.2f} dB (bar {bar_db:.0f})   {ours_msamples_s:6.2f} : {cycles_msamples_s:5.2f} Msamples/CPU s = "
              "{speed_ratio:.2f} x".format(**row), flush=True)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="NAME", help="of: " + ", ".join(fixtures.FIXTURES))
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--spp", type=int, default=1024)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--output", type=pathlib.Path)
    parser.add_argument("--tool", type=pathlib.Path, default=HERE.parent / "build" / "release" / "lippmann")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    if not peers.has_blender():
        return
    unknown = set(options.scenes) - set(fixtures.FIXTURES)
    if unknown:
        raise SystemExit(f"no such scene: {', '.join(sorted(unknown))}; there are {', '.join(fixtures.FIXTURES)}")
    with tempfile.TemporaryDirectory() as temporary:
        work = options.output or pathlib.Path(temporary)
        work.mkdir(parents=True, exist_ok=True)
        panorama = work / "panorama.hdr"
        fixtures.write_panorama(panorama)
        rows = []
        for name in options.scenes or fixtures.FIXTURES:
            make, lit_by_panorama, bar = fixtures.FIXTURES[name]
            scene = work / f"{name}.gltf"
            make().write(scene)
            rows.append(measure(name, scene, panorama if lit_by_panorama else None, bar, options, work))
    if options.json:
        print(json.dumps({"bench": "cycles", "rows": rows}, indent=2))


main()
