"""Compares the figures of `lippmann compare` with NumPy implementations of docs/reference/metrics.md."""

import json
import struct
import unittest

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from support import Case, tool

HEIGHT, WIDTH = 164, 170


def pictures(seed):
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
    """Returns PSNR-Y and PSNR-YUV in dB, in the colour space of BT.709."""
    matrix = np.array([[0.2126, 0.7152, 0.0722], [-0.2126, -0.7152, 1 - 0.0722], [1 - 0.2126, -0.7152, -0.0722]])
    matrix[1] /= 2 * (1 - 0.0722)
    matrix[2] /= 2 * (1 - 0.2126)
    error = a.astype(float) @ matrix.T - b.astype(float) @ matrix.T
    db = 10 * np.log10(255**2 / np.mean(error**2, axis=(0, 1)))
    return db[0], (6 * db[0] + db[1] + db[2]) / 8


def gaussian_window():
    t = np.arange(-5, 6)
    window = np.exp(-(t[:, None] ** 2 + t**2) / (2 * 1.5**2))
    return window / window.sum()


def luma(picture):
    return picture @ np.array([0.299, 0.587, 0.114])


def ssim(a, b):
    """Returns the mean SSIM (Wang et al. 2004, equation 13). In each window, variances and covariances
    are weighted means of products of deviations from the window's mean."""
    weights = gaussian_window()
    a, b = (sliding_window_view(luma(p), weights.shape) for p in (a, b))
    mean_a, mean_b = (np.sum(weights * p, axis=(2, 3), keepdims=True) for p in (a, b))
    variance_a, variance_b, covariance = (
        np.sum(weights * p * q, axis=(2, 3)) for p, q in ((a - mean_a, a - mean_a), (b - mean_b, b - mean_b), (a - mean_a, b - mean_b))
    )
    mean_a, mean_b = mean_a[:, :, 0, 0], mean_b[:, :, 0, 0]
    c1, c2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2
    similarity = (2 * mean_a * mean_b + c1) * (2 * covariance + c2)
    return np.mean(similarity / ((mean_a**2 + mean_b**2 + c1) * (variance_a + variance_b + c2)))


def ms_ssim(a, b):
    window = gaussian_window()
    a, b = luma(a), luma(b)
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
    """Returns the FLIP error map, computed as in the paper with two-dimensional filters."""
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


def write_motion(path, motion):
    """Writes an uncompressed OpenEXR file with the channels motion.X and motion.Y. motion: (height, width, 2)."""
    height, width, _ = motion.shape
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channel = struct.pack("<4i", 2, 0, 1, 1)  # 32-bit samples, one per pixel
    attributes = {
        "channels chlist": b"motion.X\0" + channel + b"motion.Y\0" + channel + b"\0",
        "compression compression": b"\0",
        "dataWindow box2i": box,
        "displayWindow box2i": box,
        "lineOrder lineOrder": b"\0",
        "pixelAspectRatio float": struct.pack("<f", 1),
        "screenWindowCenter v2f": struct.pack("<2f", 0, 0),
        "screenWindowWidth float": struct.pack("<f", 1),
    }
    content = b"\x76\x2f\x31\x01\x02\0\0\0"
    for name, value in attributes.items():
        content += name.replace(" ", "\0").encode() + b"\0" + struct.pack("<i", len(value)) + value
    content += b"\0"
    rows = [struct.pack("<2i", y, 8 * width) + motion[y].T.astype("<f4").tobytes() for y in range(height)]
    first = len(content) + 8 * height
    content += struct.pack(f"<{height}Q", *(first + y * len(rows[0]) for y in range(height)))
    path.write_bytes(content + b"".join(rows))


def moving_pictures(count):
    """Returns `count` frames, each with the codes of a reference picture, the codes of a test picture, and the
    motion since the previous frame. The reference shows waves, which move by another vector in each frame. The
    returned motion differs from this vector by up to half a pixel."""
    rng = np.random.default_rng(3)
    height, width = 32, 44
    y, x = np.mgrid[:height, :width].astype(float)
    place, frames = np.zeros(2), []
    for _ in range(count):
        step = rng.uniform(-3, 3, 2)
        place = place + step
        waves = [127 + 90 * np.sin((x - place[0]) / (5 + c) + c) * np.cos((y - place[1]) / 6) for c in range(3)]
        reference = np.stack(waves, -1)
        test = reference + rng.normal(0, 6, reference.shape)
        codes = [np.clip(np.round(p), 0, 255).astype(np.uint8) for p in (reference, test)]
        frames.append((*codes, (step + rng.uniform(-0.5, 0.5, (height, width, 2))).astype(np.float32)))
    return frames


def flicker(before, frame):
    """Returns the flicker of a frame. For each pixel p, the previous frame is interpolated bilinearly at p -
    motion(p)."""
    (a0, b0, _), (a1, b1, motion) = before, frame
    height, width = motion.shape[:2]
    y, x = np.mgrid[:height, :width]
    from_x, from_y = x - motion[..., 0].astype(float), y - motion[..., 1].astype(float)
    inside = (from_x >= 0) & (from_x <= width - 1) & (from_y >= 0) & (from_y <= height - 1)
    across, down = (
        np.maximum(0, 1 - abs(place[inside][:, None] - np.arange(size))) for place, size in ((from_x, width), (from_y, height))
    )
    a0, b0 = (np.einsum("ny,nx,yxc->nc", down, across, p.astype(float), optimize=True) for p in (a0, b0))
    a1, b1 = a1[inside].astype(float), b1[inside].astype(float)
    weight = np.exp(-50 * np.sum(((a1 - a0) / 255) ** 2, axis=1, keepdims=True))
    change = (b1 - a1) - (b0 - a0)
    return np.sqrt(np.sum(weight * change**2) / np.sum(weight * np.ones(3)))


class Metrics(Case):
    def compared(self, *words):
        return json.loads(tool("compare", self.folder / "a", self.folder / "b", "--json", *words))

    def write(self, count, make):
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
            self.assertAlmostEqual(frame["ssim"], ssim(a, b), places=9)
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
            options = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False, "data_range": 255}
            self.assertAlmostEqual(frame["ssim"], structural_similarity(luma(a), luma(b), **options), places=6)

    def test_angular_consistency_agrees_with_its_definition(self):
        pairs = self.write(10, pictures)
        found = self.compared("--metrics", "angular", "--views", "5x2")
        errors = np.array([b.astype(int) - a for a, b in pairs]).reshape(2, 5, HEIGHT, WIDTH, 3)
        changes = [np.diff(errors, axis=axis).ravel() for axis in (0, 1)]
        expected = 10 * np.log10(255**2 / np.mean(np.concatenate(changes) ** 2))
        self.assertAlmostEqual(found["consistency"][0]["angular_psnr_db"], expected, places=9)
        self.assertEqual([frame["name"] for frame in found["frames"]], [f"a/view_{i:03}" for i in range(10)])

    def test_flicker_of_ten_frames_agrees_with_its_definition(self):
        frames = moving_pictures(10)
        for side, name in enumerate("ab"):
            (self.folder / name).mkdir()
            for i, frame in enumerate(frames):
                write_ppm(self.folder / name / f"frame_{i:04}.ppm", frame[side])
                if name == "a":
                    write_motion(self.folder / name / f"aov_{i:04}.exr", frame[2])
        found = self.compared("--metrics", "flicker", "--views", "1x1")["consistency"]
        self.assertIsNone(found[0]["flicker"])
        for i in range(1, 10):
            expected = flicker(frames[i - 1], frames[i])
            self.assertGreater(expected, 5)
            self.assertAlmostEqual(found[i]["flicker"], expected, places=9)


if __name__ == "__main__":
    unittest.main()
