"""Compares the figures of `lippmann compare` with plain NumPy implementations of the definitions in
docs/reference/metrics.md."""

import json
import unittest

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from support import Case, tool

HEIGHT, WIDTH = 164, 170


def pictures(seed):
    """Returns the codes of a reference picture and of a test picture. The error depends on `seed`."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    reference = np.stack([127 + 120 * np.sin(x / rng.uniform(3, 30) + y / rng.uniform(3, 30) + c) for c in range(3)], -1)
    reference[40:90, 50:110] = rng.uniform(0, 255, 3)
    kinds = [
        lambda a: a + rng.normal(0, 2 + 3 * seed, a.shape),
        lambda a: (a + np.roll(a, 1, 0) + np.roll(a, 1, 1) + np.roll(a, -1, 1)) / 4,
        lambda a: a // 32 * 32,
        lambda a: 0.8 * a + 20,
        lambda a: np.roll(a, 2, 1),
    ]
    test = kinds[seed % len(kinds)](reference)
    return [np.clip(np.round(p), 0, 255).astype(np.uint8) for p in (reference, test)]


def write_ppm(path, picture):
    path.write_bytes(b"P6 %d %d 255\n" % (picture.shape[1], picture.shape[0]) + picture.tobytes())


def correlate(plane, kernel):
    return np.einsum("yxij,ij->yx", sliding_window_view(plane, kernel.shape), kernel)


def psnr_yuv(a, b):
    """Returns PSNR-Y and PSNR-YUV in dB. The rows of the matrix convert RGB to Y, Cb and Cr of BT.709."""
    matrix = np.array([[0.2126, 0.7152, 0.0722], [-0.2126, -0.7152, 1 - 0.0722], [1 - 0.2126, -0.7152, -0.0722]])
    matrix[1] /= 2 * (1 - 0.0722)
    matrix[2] /= 2 * (1 - 0.2126)
    error = a.astype(float) @ matrix.T - b.astype(float) @ matrix.T
    db = 10 * np.log10(255**2 / np.mean(error**2, axis=(0, 1)))
    return db[0], (6 * db[0] + db[1] + db[2]) / 8


def ms_ssim(a, b):
    t = np.arange(-5, 6)
    window = np.exp(-(t[:, None] ** 2 + t**2) / (2 * 1.5**2))
    window /= window.sum()
    a, b = (p @ np.array([0.299, 0.587, 0.114]) for p in (a, b))
    product = 1.0
    for scale, weight in enumerate((0.0448, 0.2856, 0.3001, 0.2363, 0.1333)):
        mean_a, mean_b = correlate(a, window), correlate(b, window)
        variance = correlate(a * a, window) - mean_a**2 + correlate(b * b, window) - mean_b**2
        similarity = (2 * (correlate(a * b, window) - mean_a * mean_b) + 7.65**2) / (variance + 7.65**2)
        if scale == 4:
            similarity = similarity * (2 * mean_a * mean_b + 2.55**2) / (mean_a**2 + mean_b**2 + 2.55**2)
        product *= similarity.mean() ** weight
        a, b = (np.pad(p, [(0, p.shape[0] % 2), (0, p.shape[1] % 2)], mode="edge") for p in (a, b))
        a, b = ((p[::2, ::2] + p[1::2, ::2] + p[::2, 1::2] + p[1::2, 1::2]) / 4 for p in (a, b))
    return product


XYZ = np.array(
    [
        [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
        [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
        [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
    ]
)
WHITE = XYZ.sum(axis=1)


def filtered(plane, kernel):
    return correlate(np.pad(plane, kernel.shape[0] // 2, mode="edge"), kernel)


def hunt_lab(linear):
    t = linear @ XYZ.T / WHITE
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    lightness = 116 * f[..., 1] - 16
    a, b = 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])
    return np.stack([lightness, 0.01 * lightness * a, 0.01 * lightness * b], -1)


def hyab(a, b):
    return abs(a[..., 0] - b[..., 0]) + np.hypot(a[..., 1] - b[..., 1], a[..., 2] - b[..., 2])


def flip(a, b):
    """Returns the FLIP error map, computed with two-dimensional filters as in the paper."""
    per_degree = 3840 * np.pi / 180
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi**2)) * per_degree))
    t = np.arange(-radius, radius + 1) / per_degree
    z = t[:, None] ** 2 + t**2
    sensitivities = [
        sum(k * np.sqrt(np.pi / s) * np.exp(-(np.pi**2) * z / s) for k, s in terms)
        for terms in ([(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)])
    ]
    deviation = 0.5 * 0.082 * per_degree
    r = int(np.ceil(3 * deviation))
    x = np.arange(-r, r + 1)
    gauss = np.exp(-(x[:, None] ** 2 + x**2) / (2 * deviation**2))
    features = []
    for kernel in (-x * gauss, (x**2 / deviation**2 - 1) * gauss):
        features.append(np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), kernel / -kernel[kernel < 0].sum()))
    colors, found = [], []
    for picture in (a, b):
        codes = picture / 255
        linear = np.where(codes > 0.04045, ((codes + 0.055) / 1.055) ** 2.4, codes / 12.92)
        xyz = linear @ XYZ.T / WHITE
        opponents = [116 * xyz[..., 1] - 16, 500 * (xyz[..., 0] - xyz[..., 1]), 200 * (xyz[..., 1] - xyz[..., 2])]
        luminance, red_green, blue_yellow = (filtered(p, s / s.sum()) for p, s in zip(opponents, sensitivities))
        middle = (luminance + 16) / 116
        seen = np.stack([middle + red_green / 500, middle, middle - blue_yellow / 200], -1) * WHITE
        colors.append(hunt_lab(np.clip(seen @ np.linalg.inv(XYZ).T, 0, 1)))
        found.append([np.hypot(filtered(xyz[..., 1], k), filtered(xyz[..., 1], k.T)) for k in features])
    largest = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))) ** 0.7
    power = hyab(*colors) ** 0.7
    knee = 0.4 * largest
    color = np.where(power < knee, 0.95 / knee * power, 0.95 + (power - knee) / (largest - knee) * 0.05)
    feature = np.maximum(*(abs(p - q) for p, q in zip(*found)))
    return np.mean(color ** (1 - (feature / np.sqrt(2)) ** 0.5))


class Metrics(Case):
    def compared(self, *words):
        return json.loads(tool("compare", self.folder / "a", self.folder / "b", "--json", *words))

    def write(self, count, make):
        """Writes `count` pairs of pictures from make(i) to the folders a and b. Returns the pairs."""
        pairs = [make(i) for i in range(count)]
        for side, name in enumerate("ab"):
            (self.folder / name).mkdir()
            for i, pair in enumerate(pairs):
                write_ppm(self.folder / name / f"view_{i:03}.ppm", pair[side])
        return pairs

    def test_ten_pictures_agree_with_the_definitions(self):
        pairs = self.write(10, pictures)
        found = self.compared("--metrics", "psnr-y,psnr-yuv,ms-ssim,flip")
        for (a, b), frame in zip(pairs, found["frames"]):
            y, yuv = psnr_yuv(a, b)
            self.assertAlmostEqual(frame["psnr_y_db"], y, places=9)
            self.assertAlmostEqual(frame["psnr_yuv_db"], yuv, places=9)
            self.assertAlmostEqual(frame["ms_ssim"], ms_ssim(a, b), places=9)
            self.assertAlmostEqual(frame["flip"], flip(a, b), places=9)
        for key, worst in (("psnr_y_db", min), ("ms_ssim", min), ("flip", max)):
            values = [frame[key] for frame in found["frames"]]
            self.assertEqual(found["worst"][key], worst(values))
            self.assertAlmostEqual(found["mean"][key], np.mean(values), places=12)

    def test_ssim_agrees_with_scikit_image(self):
        try:
            from skimage.metrics import structural_similarity
        except ImportError:
            self.skipTest("scikit-image (python3-skimage) is not installed")
        pairs = self.write(10, pictures)
        for (a, b), frame in zip(pairs, self.compared()["frames"]):
            luma = [p @ np.array([0.299, 0.587, 0.114]) for p in (a, b)]
            options = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False, "data_range": 255}
            self.assertAlmostEqual(frame["ssim"], structural_similarity(*luma, **options), places=6)

    def test_angular_consistency_agrees_with_its_definition(self):
        pairs = self.write(6, pictures)
        found = self.compared("--metrics", "angular", "--views", "3x2")
        errors = np.array([b.astype(int) - a for a, b in pairs]).reshape(2, 3, HEIGHT, WIDTH, 3)
        changes = [np.diff(errors, axis=axis).ravel() for axis in (0, 1)]
        expected = 10 * np.log10(255**2 / np.mean(np.concatenate(changes) ** 2))
        self.assertAlmostEqual(found["consistency"][0]["angular_psnr_db"], expected, places=9)
        self.assertEqual([frame["name"] for frame in found["frames"]], [f"a/view_{i:03}" for i in range(6)])


if __name__ == "__main__":
    unittest.main()
