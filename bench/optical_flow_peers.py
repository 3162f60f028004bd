#!/usr/bin/python3
"""Compares in-between frames with optical flow. Both start from every second frame of the same
integral images.

  bench/optical_flow_peers.py [SCENE ...] [--frames N] [--first F] [--output DIR] [--tool PATH]

Optical flow estimates motion from pictures; Lippmann uses the motion of the scene. Two methods
are compared: ffmpeg's minterpolate on the whole integral image, and OpenCV's DIS flow in every
directional view (T. Kroeger, R. Timofte, D. Dai, L. Van Gool, "Fast optical flow using dense
inverse search", ECCV 2016).

Prints the mean PSNR over the in-between frames, for all pixels and for the pixels that change
between the key frames. Needs Debian's python3-opencv and ffmpeg.
"""

import argparse
import math
import pathlib
import subprocess
import tempfile

import cv2
import numpy as np

LENS_PIXELS = 8
BEYOND = 4  # extra frames at the end, because minterpolate stops before its last input


def run(*command, cwd=None):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=cwd)


def render(tool, scene, first, last, folder, *options):
    """Renders frames as arrays of 8-bit codes. The scene keeps its full depth, as in the paper."""
    run(tool, "render", *scene.split(), "--full-depth", "--frames", f"{first}-{last}", "--output", folder, *options)
    return [cv2.imread(str(path)) for path in sorted(folder.glob("frame_*.png"))]


def minterpolate(keys, work):
    for name in ("given", "made"):
        (work / name).mkdir()
    for i, key in enumerate(keys):
        cv2.imwrite(str(work / "given" / f"{i:04d}.png"), key)
    run("ffmpeg", "-framerate", "1", "-i", "given/%04d.png", "-vf",
        "minterpolate=fps=2:mi_mode=mci:mc_mode=aobmc:me_mode=bidir:vsbmc=1:scd=none", "-pix_fmt", "rgb24", "-start_number", "0",
        "made/%04d.png", cwd=work)
    return [cv2.imread(str(path)) for path in sorted((work / "made").glob("*.png"))[1::2]]


def warped_half_way(image, flow):
    """Warps the image by half of the flow, which is read at the target position. This is accurate enough for small
    motion."""
    height, width = flow.shape[:2]
    x, y = np.meshgrid(np.arange(width, dtype=np.float32), np.arange(height, dtype=np.float32))
    return cv2.remap(image, x - 0.5 * flow[..., 0], y - 0.5 * flow[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)


def dis_flow(keys):
    dis = cv2.DISOpticalFlow_create(cv2.DISOPTICAL_FLOW_PRESET_MEDIUM)
    made = []
    for before, after in zip(keys, keys[1:]):
        between = np.empty_like(before)
        for view in range(LENS_PIXELS):
            # A view has one column per lens, so it is resized to square pixels for the search.
            a, b = (cv2.resize(key[:, view::LENS_PIXELS], (before.shape[1], before.shape[0])) for key in (before, after))
            gray_a, gray_b = (cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY) for picture in (a, b))
            forth, back = dis.calc(gray_a, gray_b, None), dis.calc(gray_b, gray_a, None)
            mean = (warped_half_way(a, forth).astype(np.float32) + warped_half_way(b, back)) / 2
            small = cv2.resize(mean, (before.shape[1] // LENS_PIXELS, before.shape[0]), interpolation=cv2.INTER_AREA)
            between[:, view::LENS_PIXELS] = np.clip(np.rint(small), 0, 255)
        made.append(between)
    return made


def psnr(truth, made, where=None):
    error = (truth.astype(np.float64) - made) ** 2
    if where is not None:
        error = error[where]
    mse = error.mean() if error.size else 0.0
    return math.inf if mse == 0 else 10 * math.log10(255**2 / mse)


def figures(traced, made):
    """Returns the mean PSNR of the in-between frames over all pixels, and over the pixels that differ between the key
    frames. Frames without error are left out."""
    every, moving = [], []
    for i, picture in enumerate(made):
        before, truth, after = traced[2 * i], traced[2 * i + 1], traced[2 * i + 2]
        every.append(psnr(truth, picture))
        moving.append(psnr(truth, picture, (before != after).any(axis=2)))
    return [np.mean(finite) if (finite := [v for v in values if math.isfinite(v)]) else math.inf for values in (every, moving)]


def compare(scene, options):
    last = options.first + options.frames
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        traced = render(options.tool, scene, options.first, last + BEYOND, work / "traced", "--reuse", "none")
        keys = traced[::2]
        made = {
            "ours, forward": render(options.tool, scene, options.first, last, work / "forward", "--reuse", "forward", "--keyframes", "2")[1::2],
            "ours, exact": render(options.tool, scene, options.first, last, work / "exact", "--reuse", "exact", "--keyframes", "2")[1::2],
            "minterpolate": minterpolate(keys, work),
            "DIS per view": dis_flow(keys),
        }
    count = min(options.frames // 2, *(len(pictures) for pictures in made.values()))
    for method, pictures in made.items():
        every, moving = figures(traced, pictures[:count])
        print(f"{scene:>14}  {method:>16}  {every:8.2f} dB  {moving:8.2f} dB on moving pixels", flush=True)
    middle = count // 2
    row = [traced[2 * middle + 1]] + [pictures[middle] for pictures in made.values()]
    options.output.mkdir(parents=True, exist_ok=True)
    path = options.output / f"{pathlib.Path(scene.split()[0]).stem}.png"
    cv2.imwrite(str(path), np.hstack(row))
    print(f"{'':>14}  {path}: traced, {', '.join(made)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="as for lippmann render, with its options in one word")
    parser.add_argument("--frames", type=int, default=16, help="frames of each animation")
    parser.add_argument("--first", type=int, default=100)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("out/optical-flow"))
    parser.add_argument("--tool", default=pathlib.Path(__file__).parent.parent / "build/release/lippmann")
    options = parser.parse_args()
    for scene in options.scenes or ["teapot", "room", "small-balls", "primitives", "tree", "gears"]:
        compare(scene, options)


if __name__ == "__main__":
    main()
