#!/usr/bin/env python3
"""Compares eye views through lenses of 2 to 10 pixels with an eye view through lenses of 1 pixel.

Prints PSNR and SSIM. All pictures are 360x360 pixels from the middle of the viewing zone, where the eye sees one pixel of each lens.
  bench/lens_width.py LIPPMANN [FOLDER]     FOLDER keeps the pictures, FOLDER/SCENE-WIDTH-eye/eye_0000.png
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

SIDE, LENS_PIXELS = 360, 11


def eye_view(tool, folder, scene, width):
    lenses = SIDE // width
    side = f"{lenses * LENS_PIXELS}x{lenses * LENS_PIXELS}"
    sheet, eye = folder / f"{scene}-{width}", folder / f"{scene}-{width}-eye"
    render = [tool, "render", scene, "--optics", "lenticular", "--size", side, "--lenses", str(lenses)]
    subprocess.run([*render, "--frames", "0", "--full-depth", "-o", sheet, "-q"], check=True)
    subprocess.run([tool, "replay", sheet, "--size", f"{SIDE}x{SIDE}", "-o", eye, "-q"], check=True)
    return eye / "eye_0000.png"


def main():
    tool = sys.argv[1]
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp())
    for scene in ("teapot", "room"):
        reference = eye_view(tool, folder, scene, 1)
        for width in (2, 3, 4, 5, 6, 8, 10):
            compared = subprocess.run([tool, "compare", reference, eye_view(tool, folder, scene, width), "--json"],
                                      check=True, capture_output=True)
            mean = json.loads(compared.stdout)["mean"]
            print(f"{scene:8} {width:3} pixels a lens  {mean['psnr_db']:5.1f} dB  SSIM {mean['ssim']:.3f}")


if __name__ == "__main__":
    main()
