"""Compares the figures of `lippmann compare` with those of other programs, for the ten pairs of metric_pictures.py."""

import json
import re
import shutil
import subprocess

import metric_pictures
import numpy as np
from support import Case, tool

# Figures that other programs print for the pairs. luma(p) is p @ (0.299, 0.587, 0.114) in double precision.
#   FLIP     NVlabs/flip 1.6, the C++ program, with PNG copies of the pictures: flip -r a.png -t b.png -v 1
#   MS-SSIM  pytorch-msssim 1.0.0 on PyTorch 1.13.1: ms_ssim(luma(a), luma(b), data_range=255, win=w), where w is the window
#            exp(-t^2 / 4.5), t = -5 ... 5, divided by its sum, in double precision (the default window has 32 bits)
#   SSIM     scikit-image 0.19.3: structural_similarity(luma(a), luma(b), gaussian_weights=True, sigma=1.5,
#            use_sample_covariance=False, data_range=255)
FLIP = [0.080805, 0.079229, 0.144403, 0.201334, 0.103204, 0.137817, 0.119638, 0.612106, 0.074367, 0.104252]
MS_SSIM = [
    0.9679342754, 0.9794380180, 0.9573094039, 0.9842139246, 0.9099368622,
    0.9564837863, 0.8945089646, 0.9422449763, 0.8272451923, 0.8854167866,
]
SSIM = [
    0.7757641637, 0.9172434880, 0.8431416831, 0.9876863514, 0.7490450058,
    0.9128306311, 0.9732054068, 0.7872454109, 0.5530622362, 0.9763086689,
]

# NVlabs' program computes with 32-bit numbers, which changes its means by up to 1.1e-5. With doubles in their place, it differs
# from ours by up to 8e-8.
FLIP_TOLERANCE = 2e-5
SSIM_TOLERANCE = 1e-9  # of the ten digits above
# FFmpeg's zscale converts to Y, U and V in 32 bits, and rounds them to 16 bits. The largest difference was 5e-4 dB.
PSNR_TOLERANCE_DB = 1e-3


class MetricsJudges(Case):
    def compared(self, *words):
        pairs = [metric_pictures.pair(seed) for seed in range(metric_pictures.COUNT)]
        metric_pictures.write_pairs(self.folder, pairs)
        return json.loads(tool("compare", self.folder / "a", self.folder / "b", "--json", *words))["frames"]

    def assertAgrees(self, frames, key, expected, tolerance):
        np.testing.assert_allclose([frame[key] for frame in frames], expected, rtol=0, atol=tolerance, err_msg=key)

    def test_flip_ms_ssim_and_ssim_agree_with_published_programs(self):
        frames = self.compared("--metrics", "ms-ssim,flip")
        self.assertAgrees(frames, "flip", FLIP, FLIP_TOLERANCE)
        self.assertAgrees(frames, "ms_ssim", MS_SSIM, SSIM_TOLERANCE)
        self.assertAgrees(frames, "ssim", SSIM, SSIM_TOLERANCE)

    def test_psnr_of_luma_and_chroma_agrees_with_ffmpeg(self):
        if not shutil.which("ffmpeg"):
            self.skipTest("FFmpeg (ffmpeg) is not installed")
        frames = self.compared()
        convert = "format=gbrp,zscale=matrix=709:range=full,format=yuv444p16"
        graph = f"[0]{convert}[a];[1]{convert}[b];[b][a]psnr,metadata=print:file=-"
        words = ["-i", self.folder / "a/view_%03d.ppm", "-i", self.folder / "b/view_%03d.ppm", "-lavfi", graph, "-f", "null", "-"]
        printed = subprocess.run(["ffmpeg", "-v", "error", *words], check=True, capture_output=True, text=True).stdout
        y, u, v = (np.array(re.findall(rf"psnr\.psnr\.{plane}=(\S+)", printed), float) for plane in "yuv")
        self.assertAgrees(frames, "psnr_y_db", y, PSNR_TOLERANCE_DB)
        self.assertAgrees(frames, "psnr_yuv_db", (6 * y + u + v) / 8, PSNR_TOLERANCE_DB)
