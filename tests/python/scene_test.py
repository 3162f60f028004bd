"""Tests scenes that are made of arrays."""

import numpy as np

import lippmann
from support import Case, DESK, small_grid

QUAD = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]


def front(scene, **options):
    """Renders the front view, which is 2 units high."""
    scene.place_display(height=2, viewing_distance=20)
    options.setdefault("spp", 1)
    return lippmann.render(scene, small_grid(1, 1, (32, 32)), light="none", **options).views[0, 0]


class SceneTest(Case):
    def test_an_unlit_mesh_has_its_colour(self):
        scene = lippmann.Scene()
        scene.add_mesh(QUAD, FACES, material=lippmann.Material((0.25, 0.5, 0.75), unlit=True))
        np.testing.assert_allclose(front(scene)[16, 16], (0.25, 0.5, 0.75), rtol=1e-5)

    def test_textures_use_uvs_with_v_downwards(self):
        texture = np.zeros((2, 2, 3), np.uint8)
        texture[0, 0], texture[1, 1] = (255, 0, 0), (0, 0, 255)
        scene = lippmann.Scene()
        uvs = [[0, 1], [1, 1], [1, 0], [0, 0]]
        scene.add_mesh(QUAD, FACES, uvs=uvs, material=lippmann.Material((1, 1, 1), unlit=True, texture=texture))
        picture = front(scene)
        self.assertGreater(picture[8, 8, 0], 0.9)
        self.assertGreater(picture[24, 24, 2], 0.9)
        self.assertLess(picture[8, 24].max(), 0.1)

    def test_equal_textures_are_shared(self):
        scene, uvs = lippmann.Scene(), [[0, 1], [1, 1], [1, 0], [0, 0]]

        def add(texture, x):
            material = lippmann.Material((1, 1, 1), unlit=True, texture=texture)
            scene.add_mesh(QUAD, FACES, uvs=uvs, material=material, translation=(x, 0, 0), scale=(0.4, 1, 1))

        texture = np.zeros((2, 3, 3), np.uint8)
        for x, color in ((-0.5, (255, 0, 0)), (0.5, (0, 255, 0))):
            texture[...] = color
            add(texture, x)
        picture = front(scene)
        np.testing.assert_allclose(picture[16, [8, 24]], [[1, 0, 0], [0, 1, 0]], atol=1e-5)
        self.assertEqual(scene._core.material_count, 2)
        add(texture.copy(), 2)
        add(texture[::-1, ::-1], 3)
        # an opaque alpha channel, as stored textures have
        add(np.dstack([texture, np.full((2, 3), 255, np.uint8)]), 4)
        self.assertEqual(scene._core.material_count, 2)
        add(texture.reshape(3, 2, 3), 5)
        self.assertEqual(scene._core.material_count, 3)

    def test_scenes_far_from_the_origin_are_exact(self):
        def field(place):
            scene = lippmann.Scene()
            material = lippmann.Material((0.25, 0.5, 0.75), unlit=True)
            scene.add_mesh(QUAD, FACES, material=material, translation=place, scale=(0.5, 0.75, 1))
            scene.place_display(place, height=2, viewing_distance=20)
            corners = np.multiply(QUAD, (0.5, 0.75, 1)) + place
            np.testing.assert_array_equal(scene.bounds(), [corners.min(axis=0), corners.max(axis=0)])
            return lippmann.render(scene, small_grid(1, 1, (32, 32)), light="none", spp=1)

        place = (4194304, 1024, -2097152)  # float32 represents these coordinates exactly
        near, far = field((0, 0, 0)), field(place)
        np.testing.assert_array_equal(far.views, near.views)
        moved = near.world_from_display
        moved[:3, 3] += place
        np.testing.assert_array_equal(far.world_from_display, moved)

    def test_vertex_colors_multiply_the_materials(self):
        scene = lippmann.Scene()
        colors = np.full((4, 3), (1.0, 0.5, 0.0))
        scene.add_mesh(QUAD, FACES, colors=colors, material=lippmann.Material((0.5, 0.5, 0.5), unlit=True))
        np.testing.assert_allclose(front(scene)[16, 16], (0.5, 0.25, 0), rtol=1e-5, atol=1e-6)

    def test_a_lamp_lights_its_target(self):
        def brightness(**lamp):
            scene = lippmann.Scene()
            scene.add_mesh(QUAD, FACES, material=lippmann.Material((1, 1, 1), roughness=1))
            scene.add_light(**lamp)
            return float(front(scene, integrator="path", max_depth=2)[16, 16].mean())

        towards = brightness(kind="directional", direction=(0, 0, -1))
        self.assertGreater(towards, 0.1)
        self.assertAlmostEqual(brightness(kind="directional", direction=(0, 0, -1), intensity=2), 2 * towards, places=5)
        self.assertAlmostEqual(brightness(kind="point", position=(0, 0, 2)), towards / 4, delta=0.02 * towards)
        self.assertAlmostEqual(brightness(kind="spot", position=(0, 0, 2), target=(0, 0, 0)), towards / 4, delta=0.02 * towards)
        self.assertLess(brightness(kind="spot", position=(0, 0, 2), target=(0, 0, 4)), 1e-6)

    def test_lamps_with_size_have_soft_shadows(self):
        # A plate at z = 0.5 covers the half x < 0. The lamp at z = 2 is a sphere of radius 0.5. Seen from (x, 0, 0),
        # the plate hides the part of the lamp that is left of -3 x. At the first pixel, x = 1/32, 62 % of the lamp's
        # disc is visible. For x > 1/6, the whole disc is visible.
        def row(**size):
            scene = lippmann.Scene()
            scene.add_mesh(QUAD, FACES, material=lippmann.Material((1, 1, 1), roughness=1))
            scene.add_box((-3, -3, 0.5), (0, 3, 0.501))
            scene.add_light("point", position=(0, 0, 2), intensity=2, **size)
            return front(scene, integrator="path", max_depth=1, spp=256)[16, :, 1]

        ratio = row(radius=0.5)[16:] / row()[16:]
        self.assertAlmostEqual(float(ratio[0]), 0.62, delta=0.06)
        np.testing.assert_allclose(ratio[4:], 1.0, atol=0.03)

    def test_a_white_wall_matches_a_uniform_background(self):
        scene = lippmann.Scene()
        scene.set_background((0.5, 0.5, 0.5))
        scene.add_mesh(QUAD, FACES, material=lippmann.Material((1, 1, 1), roughness=1, metallic=0))
        self.assertAlmostEqual(float(front(scene, integrator="path", spp=64)[8:24, 8:24].mean()), 0.5, delta=0.02)

    def test_a_panorama_is_the_background(self):
        scene = lippmann.Scene()
        scene.add_sphere((0, 0, 0), 0.2)
        scene.set_environment(np.full((8, 16, 3), 0.25), strength=2)
        np.testing.assert_allclose(front(scene)[0, 0], 0.5, rtol=1e-5)

    def test_matrices_equal_their_parts(self):
        angles = np.linspace(0, 1.2, 4)
        matrices = np.zeros((4, 4, 4))
        for matrix, angle in zip(matrices, angles):
            c, s = np.cos(angle), np.sin(angle)
            matrix[:] = [[2 * c, -s / 2, 0, angle], [2 * s, c / 2, 0, -angle], [0, 0, 1, 0], [0, 0, 0, 1]]
        rotation = np.stack([0 * angles, 0 * angles, np.sin(angles / 2), np.cos(angles / 2)], axis=1)
        translation = np.stack([angles, -angles, 0 * angles], axis=1)
        scale = np.broadcast_to((2, 0.5, 1), (4, 3))

        def bounds(**moves):
            scene = lippmann.Scene(frames=4)
            scene.add_box(name="box").animate(**moves)
            return [scene.bounds(frame) for frame in range(4)]

        one, other = bounds(matrices=matrices), bounds(translation=translation, rotation=rotation, scale=scale)
        np.testing.assert_allclose(one, other, atol=1e-5)
        np.testing.assert_allclose(one[0], [[-2, -0.5, -1], [2, 0.5, 1]], atol=1e-6)
        corner = matrices[3] @ np.array([[x, y, z, 1] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]).T
        np.testing.assert_allclose(one[3], [corner[:3].min(axis=1), corner[:3].max(axis=1)], atol=1e-5)

    def test_rotations_round_trip_through_matrices(self):
        from lippmann import _scene

        rng = np.random.default_rng(3)
        for q in [*np.eye(4), *rng.normal(size=(50, 4))]:
            x, y, z, w = q / np.linalg.norm(q)
            matrix = np.array([
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ])
            found = _scene._quaternions(matrix[None])[0]
            self.assertAlmostEqual(abs(float(found @ (x, y, z, w))), 1, places=9)

    def test_cameras_set_the_view(self):
        scene = lippmann.Scene()
        scene.add_sphere((5, 0, 0), 0.5, material=lippmann.Material((1, 1, 1), unlit=True))
        scene.add_camera((5, 0, 10), target=(5, 0, 0), vertical_fov_deg=20)
        views = lippmann.render(scene, small_grid(1, 1, (32, 32)), light="none", spp=1).views[0, 0]
        self.assertGreater(views[16, 16, 0], 0.9)
        self.assertEqual(views[2, 2, 0], 0)

    def test_scenes_of_files_list_their_content(self):
        scene = lippmann.load(DESK)
        self.assertGreater(len(scene.objects), 1)
        self.assertGreater(scene.frame_count, 1)
        self.assertEqual(scene.bounds().shape, (2, 3))
        self.assertIn("room", lippmann.scenes())
        copy = scene.copy()
        copy.add_sphere()
        self.assertEqual(len(copy.objects), len(scene.objects) + 1)
