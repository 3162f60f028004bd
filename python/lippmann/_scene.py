"""Scenes: built-in ones, files, and scenes made of arrays.

World space is right-handed, in any unit, with +y up as in glTF. Methods that add something return a handle (Object), which moves
and animates it.
"""

from __future__ import annotations

import hashlib
import math
import os
from dataclasses import dataclass
from typing import Any, Dict, Literal, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import array, choice, file_path, indices, integer, number, path_bytes, positive, text, vector
from ._errors import Error, Reading, warn, warn_of_ignored
from ._meshes import arrays_of, texture_of
from ._options import UpAxis

_UP = np.array([0.0, 1.0, 0.0])
_UP_AXES = ("y", "x", "z", "-x", "-y", "-z")  # in the order of the C++ enumeration


def scenes() -> Dict[str, str]:
    """Returns the built-in scenes, as a dict from names to one-line descriptions."""
    return dict(_core.builtin_scenes())


@dataclass
class Material:
    """A surface of glTF's metallic-roughness model.

    color: linear red, green, blue from 0 to 1.
    roughness: from 0 (mirror) to 1 (chalk).
    metallic: 0 or 1.
    emission: emitted linear light, without an upper limit.
    transmission: share of light that passes, as through glass, refracted by the index of refraction `ior`.
    alpha: coverage, from 0 to 1.
    texture: (y, x, 3 or 4) of uint8 sRGB codes, multiplied by color. It is mapped by the uvs of a mesh. Other shapes, and meshes without
        uvs, ignore it with a LippmannWarning.

    Adding an object copies its material. Later changes of the material or of the texture's pixels affect only objects added later.
    """

    color: Sequence[float] = (0.8, 0.8, 0.8)
    roughness: float = 0.5
    metallic: float = 0.0
    emission: Sequence[float] = (0.0, 0.0, 0.0)
    transmission: float = 0.0
    ior: float = 1.5
    clearcoat: float = 0.0
    alpha: float = 1.0
    double_sided: bool = True
    unlit: bool = False
    texture: Optional[NDArray[Any]] = None


@dataclass
class Skin:
    """Joints that deform a mesh (Scene.add_mesh). The poses of the joints when the mesh is added are the rest pose: they do not deform it.

    joints: handles returned by Scene.add_joint.
    indices: (vertices, n): the n joints of each vertex, as indices into `joints`.
    weights: (vertices, n): influence of each of these joints, 0 or more. The weights of a vertex are normalised to sum 1.
    """

    joints: Sequence["Object"]
    indices: Any
    weights: Any


class Object:
    """A handle of something in a scene: a mesh, a shape, a lamp, a camera, a joint. The scene's add_ functions return it."""

    def __init__(self, scene: "Scene", node: int, name: str) -> None:
        self._scene, self._node = scene, node
        self._targets, self._has_skin = 0, False
        self.name = name

    def animate(
        self,
        matrices: Any = None,
        *,
        translation: Any = None,
        rotation: Any = None,
        scale: Any = None,
        weights: Any = None,
    ) -> "Object":
        """Animates the object with one value per frame of the scene. The values replace the object's initial placement.

        matrices: (frames, 4, 4), with the columns x axis, y axis, z axis, origin. Each matrix is a scale, then a rotation, then a
            translation, without shear.
        translation, rotation, scale: (frames, 3), (frames, 4) as quaternions x, y, z, w, and (frames, 3), instead of matrices.
        weights: (frames, targets), for a mesh with morph targets.

        Children move with their parents. A mesh with a skin cannot be moved: animate its joints. Returns the object.
        """
        count = self._scene.frame_count
        moves = {"matrices": matrices, "translation": translation, "rotation": rotation, "scale": scale}
        for argument, value in moves.items():
            if self._has_skin and value is not None:
                raise Error(argument, "has no effect on a mesh with a skin", "weights, or animate() of its joints")
        if weights is not None:
            if not self._targets:
                raise Error("weights", "need morph targets, but the mesh has none", "a mesh that was added with targets")
            weights = array(weights, "weights", (count, self._targets))
        if matrices is not None:
            if translation is not None or rotation is not None or scale is not None:
                raise Error("matrices", "is given, and so are parts of it", "one of the two")
            translation, rotation, scale = _parts_of(array(matrices, "matrices", (count, 4, 4)))
        if translation is not None:
            translation = array(translation, "translation", (count, 3))
        if rotation is not None:
            rotation = _unit(array(rotation, "rotation", (count, 4)), "rotation")
        if scale is not None:
            scale = array(scale, "scale", (count, 3))
        self._scene._core.animate(self._node, translation, rotation, scale, weights)
        return self

    def __repr__(self) -> str:
        return f"<lippmann.Object {self.name!r}>"


class Scene:
    """A scene made in memory. Add objects to it, and render it with `lippmann.render` or `lippmann.frames`.

    name: the scene's name in reports.
    frames: number of frames of the animation.
    frames_per_second: frame rate of the animation.
    """

    def __init__(self, name: str = "scene", *, frames: int = 1, frames_per_second: float = 25.0) -> None:
        count = integer(frames, "frames", 1, 1 << 20)
        self._core = _core.Scene(text(name, "name"), count, positive(frames_per_second, "frames_per_second", 1e4))
        self._is_file = False
        self._start()

    @classmethod
    def _of(cls, core: Any, is_file: bool) -> "Scene":
        scene = cls.__new__(cls)
        scene._core, scene._is_file = core, is_file
        scene._start()
        return scene

    def _start(self) -> None:
        self._materials: Dict[Any, int] = {}  # values of a material -> its index
        self._textures: Dict[Any, int] = {}  # hash of a texture's pixels -> its index

    @property
    def name(self) -> str:
        """The name in reports."""
        return self._core.name

    @property
    def frame_count(self) -> int:
        """The number of frames of the animation; frames are counted from 0."""
        return self._core.frame_count

    @property
    def frames_per_second(self) -> float:
        """The frame rate. Frame f shows the scene at f / frames_per_second seconds."""
        return self._core.frames_per_second

    @property
    def objects(self) -> Tuple[str, ...]:
        """The names of the objects. The index is the object's id, as in the layer "id"."""
        return tuple(self._core.instance_names)

    @property
    def cameras(self) -> Tuple[str, ...]:
        """The names of the cameras, by index. The first one sets the view by default."""
        return tuple(self._core.camera_names)

    def bounds(self, frame: int = 0) -> Optional[NDArray[Any]]:
        """Returns (2, 3): the lowest and the highest coordinates of all finite shapes. Returns None if there are no finite shapes."""
        return self._core.bounds(integer(frame, "frame", 0, self.frame_count - 1))

    def copy(self) -> "Scene":
        """Returns an independent copy of the scene. Handles of objects still refer to the original scene."""
        return Scene._of(self._core.copy(), self._is_file)

    __copy__ = copy

    def __repr__(self) -> str:
        count = self.frame_count
        return f"<lippmann.Scene {self.name!r}: {len(self.objects)} objects, {count} frame{'' if count == 1 else 's'}>"

    def add_mesh(
        self,
        positions: Any,
        triangles: Any = None,
        *,
        normals: Any = None,
        uvs: Any = None,
        colors: Any = None,
        targets: Any = None,
        target_normals: Any = None,
        weights: Any = None,
        skin: Optional[Skin] = None,
        material: Optional[Material] = None,
        name: str = "",
        translation: Any = (0, 0, 0),
        rotation: Any = (0, 0, 0, 1),
        scale: Any = (1, 1, 1),
    ) -> Object:
        """Adds a mesh.

        positions: (vertices, 3). Or a mesh of trimesh or Open3D, without `triangles`: `add_mesh(mesh)`. Its uvs, its vertex colours (as
            linear light), its stored normals and its texture are used, unless arguments replace them. `material` replaces the texture.
        triangles: (triangles, 3) indices of vertices, counter-clockwise seen from the front.
        normals: (vertices, 3). None: the mesh is faceted.
        uvs: (vertices, 2), with v downwards.
        colors: (vertices, 3), linear, multiplied by the colour of the material.
        translation, rotation, scale: placement of the mesh. The rotation is a quaternion x, y, z, w.
        targets: (targets, vertices, 3): morph targets. A target holds offsets of positions, in units of the mesh.
        target_normals: offsets of normals, of the same shape.
        weights: (targets): factors of the targets. Default: 0.
        skin: joints that deform the mesh.
        """
        if triangles is None:
            held = arrays_of(positions)
            if material is None and "uvs" in held:
                material = Material((1.0, 1.0, 1.0), texture=texture_of(positions))
            normals, uvs, colors = (
                held.get(name) if value is None else value
                for name, value in (("normals", normals), ("uvs", uvs), ("colors", colors))
            )
            positions, triangles = held["positions"], held["triangles"]
        points = array(positions, "positions", (None, 3))
        count = len(points)
        faces = indices(triangles, "triangles", 3, count)
        if normals is not None:
            normals = _unit(array(normals, "normals", (count, 3)), "normals")
        if uvs is not None:
            uvs = array(uvs, "uvs", (count, 2))
        if colors is not None:
            colors = array(colors, "colors", (count, 3))
        morphs = _morphs(targets, target_normals, weights, count, normals is not None)
        carried = None if skin is None else self._carried(skin, count)
        surface = self._material(material, uvs is not None)
        shape = self._core.add_mesh(points, faces, normals, uvs, colors)
        mesh = self._instance(shape, surface, name or "mesh", translation, rotation, scale)
        if morphs is not None:
            _core.set_targets(self._core, shape, *morphs)
            mesh._targets = len(morphs[0])
        if carried is not None:
            _core.set_skin(self._core, shape, *carried)
            mesh._has_skin = True
        return mesh

    def add_joint(
        self,
        translation: Any = (0, 0, 0),
        *,
        rotation: Any = (0, 0, 0, 1),
        scale: Any = (1, 1, 1),
        parent: Optional[Object] = None,
        name: str = "",
    ) -> Object:
        """Adds a joint of a skeleton, placed relative to its parent. parent: None is the world.

        Joints are invisible. They deform meshes that have a Skin. animate() moves a joint together with its children.
        """
        if parent is not None and (not isinstance(parent, Object) or parent._scene is not self):
            raise Error("parent", f"is {parent!r}", "a handle of this scene's")
        above = -1 if parent is None else parent._node
        size = vector(scale, "scale")
        if 0 in size:
            raise Error("scale", f"is {size}", "numbers other than 0")
        turn = _unit(array(rotation, "rotation", (4,))[None], "rotation")[0]
        place = vector(translation, "translation"), tuple(float(q) for q in turn), size
        node = self._core.add_node(text(name, "name") or "joint", above, *place)
        return Object(self, node, name or "joint")

    def add_sphere(
        self, center: Any = (0, 0, 0), radius: float = 1.0, *, material: Optional[Material] = None, name: str = ""
    ) -> Object:
        """Adds a sphere, which is not approximated by triangles. The origin of its handle is its centre."""
        at, size, surface = vector(center, "center"), positive(radius, "radius"), self._material(material)
        return self._instance(self._core.add_sphere((0.0, 0.0, 0.0), size), surface, name or "sphere", at)

    def add_box(
        self,
        lower: Any = (-1, -1, -1),
        upper: Any = (1, 1, 1),
        *,
        material: Optional[Material] = None,
        name: str = "",
        rotation: Any = (0, 0, 0, 1),
    ) -> Object:
        """Adds a box between two corners. The origin of its handle is its centre. rotation: a quaternion x, y, z, w about the centre."""
        low, high = np.array(vector(lower, "lower")), np.array(vector(upper, "upper"))
        if not (low < high).all():
            raise Error("upper", f"{tuple(high)} is not above lower, {tuple(low)}", "larger coordinates on every axis")
        half, surface = (high - low) / 2, self._material(material)
        shape = self._core.add_box(tuple(-half), tuple(half))
        return self._instance(shape, surface, name or "box", tuple((low + high) / 2), rotation)

    def add_cylinder(
        self, base: Any, apex: Any, radius: float, *, material: Optional[Material] = None, name: str = ""
    ) -> Object:
        """Adds the side of a cylinder from base to apex, without caps. The origin of its handle is the origin of the world."""
        ends = vector(base, "base"), vector(apex, "apex")
        if ends[0] == ends[1]:
            raise Error("apex", "is the base", "another point")
        surface = self._material(material)
        return self._instance(self._core.add_cylinder(*ends, positive(radius, "radius")), surface, name or "cylinder")

    def add_plane(
        self, point: Any = (0, 0, 0), normal: Any = (0, 1, 0), *, material: Optional[Material] = None, name: str = ""
    ) -> Object:
        """Adds an infinite plane, visible from both sides."""
        at, direction = vector(point, "point"), _direction(normal, "normal")
        surface = self._material(material)
        return self._instance(self._core.add_plane(at, tuple(direction)), surface, name or "plane")

    def add_light(
        self,
        kind: str = "point",
        *,
        position: Any = (0, 0, 0),
        target: Any = None,
        direction: Any = None,
        color: Any = (1, 1, 1),
        intensity: float = 1.0,
        range: float = math.inf,
        inner_cone_deg: float = 0.0,
        outer_cone_deg: float = 45.0,
        radius: float = 0.0,
        angular_diameter_deg: float = 0.0,
        name: str = "",
    ) -> Object:
        """Adds a lamp.

        kind: "point", "spot" or "directional". Point and spot lamps fall off with the squared distance.
        target, direction: a point towards which, or a vector along which, a spot or directional lamp shines. Default: downwards.
        color, intensity: linear colour and its factor. A white surface that faces the lamp at distance 1 reflects color * intensity / pi.
        range: distance beyond which a point or spot lamp has no effect.
        inner_cone_deg, outer_cone_deg: half angles of a spot lamp.
        radius: makes a point or spot lamp a sphere of the same total brightness. Its shadows are soft in path-traced pictures.
        angular_diameter_deg: makes a directional lamp a disc of the same total brightness, such as the sun (0.53).

        Arguments that a kind does not use are ignored with a LippmannWarning: the direction of a point lamp, the cones of all lamps but
        spots, the range of a directional lamp.
        """
        if kind not in ("point", "directional", "spot"):
            raise Error("kind", f"is {kind!r}", "point, directional, spot")
        at = vector(position, "position")
        along = _along(at, target, direction, (0.0, -1.0, 0.0))
        tint = np.array(vector(color, "color")) * number(intensity, "intensity", 0.0, 1e9)
        if (tint < 0).any():
            raise Error("color", f"is {tuple(tint)}", "numbers of 0 or more")
        outer = number(outer_cone_deg, "outer_cone_deg", 0.01, 90.0)
        inner = number(inner_cone_deg, "inner_cone_deg", 0.0, outer)
        reach = number(range, "range", 1e-9, math.inf, finite=False)
        is_sun = kind == "directional"
        ball = number(radius, "radius", 0.0, 0.0 if is_sun else 1e9)
        disc = math.radians(number(angular_diameter_deg, "angular_diameter_deg", 0.0, 180.0 if is_sun else 0.0))
        for argument, is_given in (("target", target is not None), ("direction", direction is not None)):
            if is_given and kind == "point":
                warn_of_ignored(argument, "a point lamp shines in all directions")
        for argument, is_given in (("inner_cone_deg", inner != 0.0), ("outer_cone_deg", outer != 45.0)):
            if is_given and kind != "spot":
                warn_of_ignored(argument, "only spots have cones")
        if is_sun and reach != math.inf:
            warn_of_ignored("range", "a directional lamp does not fade")
        node = self._core.add_node(text(name, "name") or kind, -1, at, _rotation_towards(along), (1.0, 1.0, 1.0))
        light = _core.Light(name, kind, node, tuple(tint))
        light.inner_cone, light.outer_cone = math.radians(inner), math.radians(outer)
        light.range, light.radius, light.angular_diameter = reach, ball, disc
        self._core.add_light(light)
        return Object(self, node, name or kind)

    def set_background(self, horizon: Any = (0, 0, 0), zenith: Any = None) -> None:
        """Sets the background, which also lights the scene. horizon, zenith: linear colours, 0 or more. zenith: None is the colour of the
        horizon.
        """
        low = _light(horizon, "horizon")
        self._core.set_background(low, low if zenith is None else _light(zenith, "zenith"))

    def set_environment(self, radiance: Any, *, strength: float = 1.0, rotation_deg: float = 0.0) -> None:
        """Sets a panorama that surrounds and lights the scene.

        radiance: an equirectangular panorama with the zenith on top, as an array (y, x, 3) of linear light or a file (.hdr, .exr, .pfm or
            .tif). Or one linear colour. Or "studio", a built-in panorama, which is turned towards the first camera in the scene at the
            time of this call.
        strength: factor of the light.
        rotation_deg: rotation about +y.
        """
        surround(self._core, radiance, *strength_and_turn(strength, rotation_deg), "radiance")

    def choose_camera(self, camera: Union[str, int]) -> None:
        """Selects the camera that sets the view, by name or index in `cameras`. It becomes the first camera, and replaces the placement of
        a display that the scene contains.
        """
        choose_camera(self._core, camera)

    def add_camera(
        self,
        position: Any,
        target: Any = (0, 0, 0),
        *,
        vertical_fov_deg: float = 40.0,
        focus_distance: Optional[float] = None,
        name: str = "",
    ) -> Object:
        """Adds a camera at `position` that looks at `target`, in scene units.

        The first camera places the display in the scene. The display is perpendicular to the camera's axis, at the distance
        `focus_distance` (None: at the target), and as high as the camera's view there.
        """
        at, to = vector(position, "position"), vector(target, "target")
        along = _along(at, to, None, (0.0, 0.0, -1.0))
        distance = float(np.linalg.norm(np.subtract(to, at))) if focus_distance is None else focus_distance
        focus = positive(distance, "focus_distance", 1e9)
        fov = number(vertical_fov_deg, "vertical_fov_deg", 0.01, 179.0)
        node = self._core.add_node(text(name, "name") or "camera", -1, at, _rotation_towards(along), (1.0, 1.0, 1.0))
        self._core.add_camera(name, node, math.radians(fov), 0.0, focus)
        return Object(self, node, name or "camera")

    def place_display(
        self, center: Any = (0, 0, 0), *, facing: Any = (0, 0, 1), height: float = 1.0, viewing_distance: float = math.inf
    ) -> Object:
        """Places the display in the scene. Takes precedence over cameras. Lengths are in scene units.

        center: centre of the display's plane.
        facing: direction from the display to the viewer.
        height: height of the display.
        viewing_distance: distance from the display to the viewer.
        """
        at, towards = vector(center, "center"), _direction(facing, "facing")
        size = positive(height, "height", 1e9)
        distance = number(viewing_distance, "viewing_distance", 1e-9, math.inf, finite=False)
        node = self._core.add_node("display", -1, at, _rotation_towards(-towards), (1.0, 1.0, 1.0))
        self._core.set_display(node, size, distance)
        return Object(self, node, "display")

    def _material(self, material: Optional[Material], has_uvs: bool = False) -> int:
        if material is None:
            material = Material()
        if not isinstance(material, Material):
            raise Error("material", f"is {material!r}", "a lippmann.Material")
        color = vector(material.color, "material.color")
        if min(color) < 0 or max(color) > 1:
            raise Error("material.color", f"is {color}", "linear light, 0 to 1")
        emission = vector(material.emission, "material.emission")
        if min(emission) < 0:
            raise Error("material.emission", f"is {emission}", "linear light, 0 or more")
        parts = {
            part: number(getattr(material, part), f"material.{part}", lowest, highest)
            for part, lowest, highest in (
                ("alpha", 0, 1),
                ("metallic", 0, 1),
                ("roughness", 0, 1),
                ("transmission", 0, 1),
                ("ior", 1, 4),
                ("clearcoat", 0, 1),
            )
        }
        flags = bool(material.double_sided), bool(material.unlit)
        if material.texture is not None and not has_uvs:
            warn("The texture of a material is not shown: only meshes with uvs can have textures.")
        texture = -1 if material.texture is None else self._texture(_rgba(material.texture))
        key = (color, emission, tuple(parts.values()), flags, texture)
        if key in self._materials:
            return self._materials[key]
        surface = _core.Surface()
        surface.set_base_color((*color, parts["alpha"]), texture)
        surface.set_emissive(emission)
        surface.metallic, surface.roughness = parts["metallic"], parts["roughness"]
        surface.transmission, surface.ior, surface.clearcoat = parts["transmission"], parts["ior"], parts["clearcoat"]
        surface.double_sided, surface.unlit = flags
        return self._materials.setdefault(key, self._core.add_material(surface))

    def _texture(self, rgba: NDArray[Any]) -> int:
        """Returns the index of a texture (y, x, 4). Textures with equal pixels share an index. The pixels are compared, not the arrays,
        because the caller may change an array between two calls.
        """
        key = rgba.shape, hashlib.blake2b(rgba.data, digest_size=32).digest()
        if key not in self._textures:
            self._textures[key] = self._core.add_texture(rgba, True)
        return self._textures[key]

    def _carried(self, skin: Skin, vertices: int) -> Tuple[Sequence[int], NDArray[Any], NDArray[Any]]:
        """Checks a skin. Returns the nodes of its joints, its indices, and its weights normalised to sum 1."""
        if not isinstance(skin, Skin):
            raise Error("skin", f"is {skin!r}", "a lippmann.Skin")
        joints = list(skin.joints) if isinstance(skin.joints, (list, tuple)) else []
        if not joints or not all(isinstance(joint, Object) and joint._scene is self for joint in joints):
            raise Error("skin.joints", f"is {skin.joints!r}", "a list of handles of this scene's add_joint")
        weights = array(skin.weights, "skin.weights", (vertices, None))
        carriers = indices(skin.indices, "skin.indices", weights.shape[1], len(joints))
        if len(carriers) != vertices:
            raise Error("skin.indices", f"has the shape {carriers.shape}", f"the shape {weights.shape}")
        sums = weights.sum(axis=1, keepdims=True)
        if (weights < 0).any() or not (sums > 0).all():
            raise Error("skin.weights", "are below 0, or all 0 at a vertex", "numbers of 0 or more, not all 0")
        return [joint._node for joint in joints], carriers, weights / sums

    def _instance(
        self,
        shape: int,
        material: int,
        name: str,
        translation: Any = (0, 0, 0),
        rotation: Any = (0, 0, 0, 1),
        scale: Any = (1, 1, 1),
    ) -> Object:
        turn = _unit(array(rotation, "rotation", (4,))[None], "rotation")[0]
        place = vector(translation, "translation"), tuple(float(q) for q in turn), vector(scale, "scale")
        node = self._core.add_node(text(name, "name"), -1, *place)
        self._core.add_instance(name, shape, material, node)
        return Object(self, node, name)


def load(
    name: Any,
    *,
    frames_per_second: float = 0.0,
    animation: str = "",
    camera_path: Any = None,
    asset_root: Any = None,
    texture_memory_mb: int = 1024,
    variant: str = "",
    up: UpAxis = "y",
    light_scale: float = 1.0,
    points: Union[float, Literal["auto"]] = "auto",
) -> Scene:
    """Opens a built-in scene by name, or a file: .gltf, .glb, .dat, .nff, .obj, .ply. A missing file raises an Error that is also a
    FileNotFoundError.

    frames_per_second: frame rate of the animation. 0: the default of the format.
    animation: the animation to use, by name or index, for files with several animations.
    camera_path: a Tachyon .cam file.
    asset_root: the folder below which the scene may read textures and other files. None: the folder of the scene file.
    texture_memory_mb: upper bound for the decoded textures of glTF and OBJ files. The largest textures are halved until all fit, with a
        LippmannWarning. A single texture above the bound is an Error.
    variant: the material variant of a glTF file, by name or index.
    up: the axis of the file that points up.
    light_scale: factor of the light of all lamps.
    points: diameter of the points of a .ply point cloud, in its units. "auto": chosen from their spacing.
    """
    where = path_bytes(name, "name")
    options = _core.LoadOptions()
    if camera_path is not None:
        options.camera_path = path_bytes(camera_path, "camera_path")
    options.frames_per_second = number(frames_per_second, "frames_per_second", 0.0, 1e4)
    if asset_root is not None:
        options.asset_root = path_bytes(asset_root, "asset_root")
    options.animation, options.variant = text(animation, "animation"), text(variant, "variant")
    options.texture_bytes = integer(texture_memory_mb, "texture_memory_mb", 1, 1 << 20) << 20
    options.point_size = 0.0 if points == "auto" else number(points, "points", 1e-12, 1e12)
    axis = _UP_AXES.index(choice(up, "up", _UP_AXES))
    factor = number(light_scale, "light_scale", 0.0, 1e6)
    with Reading(os.fsdecode(where)):
        core = _core.load_scene(where, options)
    core.turn_upright(axis)
    core.scale_lamps(factor)
    return Scene._of(core, True)



def choose_camera(core: Any, camera: Union[str, int, None]) -> None:
    if isinstance(camera, str):
        core.choose_camera(text(camera, "camera"))
    elif camera is not None:
        count = len(core.camera_names)
        if not count:
            raise Error("camera", "the scene has no cameras", "no camera argument")
        core.choose_camera_at(integer(camera, "camera", 0, count - 1))


def strength_and_turn(strength: Any, rotation_deg: Any, prefix: str = "") -> Tuple[float, float]:
    return number(strength, prefix + "strength", 0.0, 1e6), number(rotation_deg, prefix + "rotation_deg", -1e6, 1e6)


def surround(core: _core.Scene, light: Any, factor: float, turn: float, name: str) -> None:
    """Sets the environment of a scene. light: "studio", a panorama (a file or an array (y, x, 3)), or one colour (3 numbers). name: name
    of the argument, for errors.
    """
    if isinstance(light, str) and light == "studio":
        return core.surround_with_studio(factor, turn)
    if isinstance(light, (str, bytes, os.PathLike)):
        return core.read_environment(file_path(light, name), factor, turn)
    radiance = array(light, name, (3,) if _is_color(light) else (None, None, 3))
    if (radiance < 0).any():
        raise Error(name, "has numbers below 0", "linear light")
    if radiance.ndim == 3:
        return core.set_environment(radiance, factor, turn)
    color = tuple(float(c) * factor for c in radiance)
    core.set_background(color, color)


def _is_color(light: Any) -> bool:
    try:
        return np.asarray(light).shape == (3,)
    except (TypeError, ValueError):  # rows of unequal lengths, for which array() raises an Error later
        return False



def _morphs(targets: Any, normals: Any, weights: Any, vertices: int, has_normals: bool) -> Any:
    """Checks morph targets. Returns targets (n, vertices, 3), target normals and weights, or None without targets."""
    if targets is None:
        for value, name in ((normals, "target_normals"), (weights, "weights")):
            if value is not None:
                raise Error(name, "is given without targets", "targets")
        return None
    offsets = array(targets, "targets", (None, vertices, 3))
    if normals is not None:
        if not has_normals:
            raise Error("target_normals", "need normals, but none are given", "normals")
        normals = array(normals, "target_normals", offsets.shape)
    rest = np.zeros(len(offsets)) if weights is None else array(weights, "weights", (len(offsets),))
    return offsets, normals, [float(weight) for weight in rest]


def _light(value: Any, name: str) -> Tuple[float, ...]:
    color = vector(value, name)
    if min(color) < 0:
        raise Error(name, "has numbers below 0", "linear light")
    return color



def _direction(value: Any, name: str) -> NDArray[Any]:
    direction = np.array(vector(value, name))
    length = np.linalg.norm(direction)
    if not length > 0:
        raise Error(name, "has no length", "a direction")
    direction /= length
    return direction


def _along(position: Sequence[float], target: Any, direction: Any, default: Sequence[float]) -> NDArray[Any]:
    if target is not None and direction is not None:
        raise Error("direction", "is given, and so is target", "one of the two")
    if target is None:
        return _direction(default if direction is None else direction, "direction")
    along = np.subtract(vector(target, "target"), position)
    length = np.linalg.norm(along)
    if not length > 0:
        raise Error("target", "is the position", "another point")
    along /= length
    return along


def _rotation_towards(along: NDArray[Any]) -> Tuple[float, float, float, float]:
    """Returns the quaternion x, y, z, w that rotates -z to `along` and keeps +y upwards."""
    back = -along
    right = np.cross(_UP, back)
    if np.linalg.norm(right) < 1e-6:
        right = np.array([1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    return tuple(float(q) for q in _quaternions(np.stack([right, np.cross(back, right), back], axis=1)[None])[0])  # type: ignore


def _unit(vectors: NDArray[Any], name: str) -> NDArray[Any]:
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    if not (lengths > 0).all():
        raise Error(name, f"has no length at {int(np.argmin(lengths))}", "vectors with a length")
    unit: NDArray[Any] = (vectors / lengths).astype(np.float32)
    return unit


def _quaternions(rotations: NDArray[Any]) -> NDArray[Any]:
    """Converts rotation matrices (n, 3, 3) to quaternions x, y, z, w. Computes the largest component first, for accuracy (Shepperd,
    "Quaternion from rotation matrix", 1978).
    """
    result = np.empty((len(rotations), 4))
    for q, m in zip(result, rotations):
        trace = np.trace(m)
        squares = np.array([m[0, 0], m[1, 1], m[2, 2], trace])
        k = int(np.argmax(squares))
        if k == 3:
            q[:] = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1 + trace
        else:
            i, j = (k + 1) % 3, (k + 2) % 3
            q[k] = 1 + m[k, k] - m[i, i] - m[j, j]
            q[i], q[j], q[3] = m[i, k] + m[k, i], m[j, k] + m[k, j], m[j, i] - m[i, j]
        q /= np.linalg.norm(q)
    return result


def _parts_of(matrices: NDArray[Any]) -> Tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Decomposes matrices (n, 4, 4) into translations, quaternions and scales. Raises Error for other transforms, such as shear."""
    wanted = "a scale, then a rotation, then a translation"
    if np.abs(matrices[:, 3] - (0, 0, 0, 1)).max() > 1e-6:
        raise Error("matrices", "have a last row that is not 0, 0, 0, 1", wanted)
    axes = matrices[:, :3, :3].astype(np.float64)
    scales = np.linalg.norm(axes, axis=1)
    if not (scales > 0).all():
        raise Error("matrices", f"have an axis without length at {int(np.argmin(scales.min(axis=1)))}", wanted)
    rotations = axes / scales[:, None, :]
    mirrored = np.linalg.det(rotations) < 0
    scales[mirrored, 0] *= -1
    rotations[mirrored, :, 0] *= -1
    off = np.abs(np.einsum("nki,nkj->nij", rotations, rotations) - np.eye(3)).max(axis=(1, 2))
    if off.max() > 1e-4:
        raise Error("matrices", f"are sheared at frame {int(np.argmax(off))}", wanted)
    return matrices[:, :3, 3], _quaternions(rotations), scales


def _rgba(texture: Any) -> NDArray[Any]:
    wanted = "uint8 of the shape (y, x, 3) or (y, x, 4)"
    given = np.asarray(texture)
    if given.dtype != np.uint8:
        raise Error("material.texture", f"has the type {given.dtype}", wanted)
    if given.ndim != 3 or given.shape[2] not in (3, 4) or given.size == 0:
        raise Error("material.texture", f"has the shape {given.shape}", wanted)
    if given.shape[2] == 4:
        return np.ascontiguousarray(given)
    return np.concatenate([given, np.full((*given.shape[:2], 1), 255, np.uint8)], axis=2)
