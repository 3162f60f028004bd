"""Tests meshes of trimesh and Open3D, which are imitated by classes with the same attributes."""

import types

import numpy as np

import lippmann
from support import Case, small_grid

CORNERS = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
FACES = np.array([[0, 1, 2], [0, 2, 3]])
UVS = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)


class Image:
    """Imitates a PIL.Image with a red upper row and a green lower row."""

    def convert(self, mode):
        assert mode == "RGBA"
        return np.repeat(np.array([[[255, 0, 0, 255]] * 2, [[0, 255, 0, 255]] * 2], np.uint8), 4, axis=0)


def trimesh(**visual):
    return types.SimpleNamespace(vertices=CORNERS, faces=FACES, vertex_normals=-CORNERS, visual=types.SimpleNamespace(**visual))


def open3d(normals=None, colors=None):
    return types.SimpleNamespace(
        vertices=CORNERS, triangles=FACES, vertex_normals=normals, vertex_colors=colors,
        has_vertex_normals=lambda: normals is not None, has_vertex_colors=lambda: colors is not None,
    )


class Meshes(Case):
    def seen(self, mesh, *more, **options):
        scene = lippmann.Scene()
        scene.add_mesh(mesh, *more, **options)
        scene.place_display(height=3, viewing_distance=20)
        return lippmann.render(scene, small_grid(1, 1, (16, 16)), integrator="whitted", environment=(1, 1, 1), spp=1).views[0, 0]

    def test_meshes_equal_their_arrays(self):
        self.assertSame(self.seen(trimesh(kind=None)), self.seen(CORNERS, FACES))
        self.assertSame(self.seen(open3d()), self.seen(CORNERS, FACES))
        normals = np.tile([0.0, 0.6, 0.8], (4, 1))
        self.assertSame(self.seen(open3d(normals=normals)), self.seen(CORNERS, FACES, normals=normals))

    def test_vertex_colours_become_linear_light(self):
        half = 0.21404114  # the linear light of the sRGB value 0.5
        linear = self.seen(CORNERS, FACES, colors=np.full((4, 3), half))
        np.testing.assert_allclose(self.seen(open3d(colors=np.full((4, 3), 0.5))), linear, rtol=1e-5)
        codes = np.tile(np.array([128, 128, 128, 255], np.uint8), (4, 1))
        np.testing.assert_allclose(self.seen(trimesh(kind="vertex", vertex_colors=codes)), linear, rtol=0.02)

    def test_textures_are_upright(self):
        surface = types.SimpleNamespace(baseColorTexture=Image())
        picture = self.seen(trimesh(kind="texture", uv=UVS, material=surface))
        self.assertGreater(picture[5, 8, 0], 10 * picture[5, 8, 1])
        self.assertGreater(picture[10, 8, 1], 10 * picture[10, 8, 0])
        plain = self.seen(trimesh(kind="texture", uv=UVS, material=surface), material=lippmann.Material())
        self.assertSame(plain, self.seen(CORNERS, FACES))

    def test_invalid_meshes_are_named(self):
        for thing in (CORNERS, types.SimpleNamespace(vertices=CORNERS), 7):
            error = self.assertWrong("triangles", self.seen, thing)
            self.assertIn("trimesh", error.accepted)
