"""Tests pickles and deep copies of all public classes."""

import copy
import inspect
import multiprocessing
import pickle

import numpy as np

import lippmann
from support import Case, DESK, SMALL_PANEL, small_grid


def figure():
    scene = lippmann.Scene("figure", frames=2)
    texture = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)
    joint = scene.add_joint(name="joint")
    skin = lippmann.Skin([joint], np.zeros((3, 1), int), np.ones((3, 1)))
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
    scene.add_mesh(corners, [[0, 1, 2]], uvs=corners[:, :2], material=lippmann.Material(texture=texture), skin=skin)
    ball = scene.add_sphere((0, 0, 0), 0.4, name="ball")
    ball.animate(translation=[[0, 0, 0], [0.5, 0, 0]])
    scene.add_light("point", position=(1, 2, 3))
    return scene, ball, skin


def rendered(scene, **more):
    return lippmann.render(scene, small_grid(), integrator="whitted", **more)


def own_optics():
    def rays(points):
        origins = np.zeros((len(points), 3))
        origins[:, :2] = points
        return origins, np.tile([0.0, 0.0, -1.0], (len(points), 1))

    return lippmann.own_optics(rays, (8, 8))


def examples():
    """Returns objects of each public class except Animation."""
    scene, ball, skin = figure()
    viewless = lippmann.render(DESK, own_optics(), integrator="whitted", spp=1)
    return {
        lippmann.DatasetReport: [lippmann.DatasetReport(samples=8, kept=1, made=7, seconds=2.5, bytes=4096, complete=True, remade=2)],
        lippmann.Display: [lippmann.display("looking-glass-portrait"), lippmann.display(SMALL_PANEL)],
        lippmann.Error: [lippmann.Error("size", "is 0", "1 or more")],
        lippmann.LightField: [
            rendered(scene),
            rendered(scene, layers=["depth", "normal", "motion"], transparent=True),
            viewless,
            lippmann.LightField(np.zeros((1, 2, 3, 4, 3), np.uint8)),
            lippmann.LightField(np.zeros((1, 1, 3, 4, 3)), np.zeros((1, 1, 3, 4)), distance_mm=5, baseline_mm=1, pixel_mm=1),
        ],
        lippmann.LippmannWarning: [lippmann.LippmannWarning("ignored")],
        lippmann.Material: [lippmann.Material((1, 0, 0), texture=np.zeros((2, 2, 3), np.uint8))],
        lippmann.Object: [ball],
        lippmann.Optics: [
            small_grid(), lippmann.quilt(), lippmann.lenticular_sheet(), lippmann.microlens_array(), lippmann.single_view(),
            own_optics(),
        ],
        lippmann.Scene: [scene, lippmann.load(DESK), lippmann.load("room")],
        lippmann.Skin: [skin],
    }


def returned_by_process(value):
    return repr(value), value


class Pickling(Case):
    def copies_of(self, value):
        yield pickle.loads(pickle.dumps(value))
        yield pickle.loads(pickle.dumps(value, 2))
        yield copy.deepcopy(value)

    def test_every_public_class_is_copied(self):
        classes = {value for name, value in vars(lippmann).items() if inspect.isclass(value) and not name.startswith("_")}
        self.assertEqual(classes - {lippmann.Animation}, set(examples()))
        for kind, values in examples().items():
            for value in values:
                for same in self.copies_of(value):
                    self.assertIs(type(same), kind)
                    if kind is not lippmann.Skin:
                        self.assertEqual(repr(same), repr(value))

    def test_copied_animations_render_independently(self):
        scene, _, _ = figure()
        animation = lippmann.frames(scene, small_grid(), integrator="whitted", layers=["depth"], seed=3)
        first = animation[0]
        for same in (*self.copies_of(animation), copy.copy(animation), pickle.loads(pickle.dumps(animation[1:]))):
            self.assertIs(type(same), lippmann.Animation)
            self.assertSame(same[-1].views, animation[1].views)
            self.assertSame(same[-1].depth, animation[1].depth)
        self.assertEqual(first.report["frame"], 0)
        self.assertEqual(len(pickle.loads(pickle.dumps(animation[1:]))), 1)

    def test_values_travel_to_another_process(self):
        scene, _, _ = figure()
        field = rendered(scene, layers=["depth"])
        values = [scene, field, small_grid(), lippmann.display(SMALL_PANEL), lippmann.frames(scene, small_grid(), integrator="whitted")]
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            returned = pool.map(returned_by_process, values)
        for value, (text, back) in zip(values, returned):
            self.assertEqual((text, repr(back)), (repr(value), repr(value)))
        self.assertSame(returned[1][1].views, field.views)
        self.assertSame(returned[4][1][1].views, rendered(scene, frame=1).views)

    def test_copied_scenes_are_independent(self):
        scene, ball, _ = figure()
        views = rendered(scene, frame=1).views
        for same in self.copies_of(scene):
            self.assertSame(rendered(same, frame=1).views, views)
            same.add_sphere((0, 0, 0), 1)
            self.assertEqual(len(same.objects), len(scene.objects) + 1)
        self.assertSame(rendered(copy.copy(scene), frame=1).views, views)
        kept, handle = copy.deepcopy((scene, ball))
        handle.animate(translation=[[0, 0, 0], [0, 0, 0]])
        self.assertFalse((rendered(kept, frame=1).views == views).all(), "a handle moves its object in the copy")
        self.assertSame(rendered(scene, frame=1).views, views)

    def test_copied_light_fields_have_all_arrays(self):
        field = rendered(figure()[0], layers=["depth", "normal", "motion"])
        for same in self.copies_of(field):
            for name in ("views", "depth", "disparity", "normals", "motion", "picture", "codes", "world_from_display"):
                self.assertSame(getattr(same, name), getattr(field, name))
            self.assertEqual(same.report, field.report)
            self.assertSame(same.eye(), field.eye())
            same.save(self.folder / "same.png", "quilt")

    def test_copied_optics_have_the_same_rays(self):
        points = np.array([[0.5, 0.5], [7.5, 3.5]], np.float32)
        for optics in examples()[lippmann.Optics]:
            for same in self.copies_of(optics):
                for one, other in zip(same.rays(points), optics.rays(points)):
                    self.assertSame(one, other)

    def test_damaged_pickles_are_refused(self):
        optics = small_grid()
        for state in (b"", optics.__getstate__()[:-1], optics.__getstate__() + b"x", bytes(200)):
            with self.assertRaisesRegex(lippmann.Error, "pickle: is damaged"):
                lippmann.Optics.__new__(lippmann.Optics).__setstate__(state)

    def test_hasattr_and_getattr_answer_for_every_property(self):
        absent = set()
        for values in examples().values():
            for value in values:
                for name in (name for name in dir(type(value)) if not name.startswith("_")):
                    if not hasattr(value, name):
                        absent.add(name)
                        self.assertEqual(getattr(value, name, 7), 7)
                        with self.assertRaises(lippmann.Error):
                            getattr(value, name)
        self.assertLessEqual({"depth", "disparity", "normals", "motion", "alpha", "rgba", "views", "eyes_mm", "units_per_mm"}, absent)
