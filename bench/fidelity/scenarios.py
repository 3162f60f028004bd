"""Reads scenarios: a model, a camera that orbits a target, an environment and a size.

A configuration is a JSON file as in glTF Render Fidelity, with a list "scenarios". Each has a
"name" and a "model" (a path), and may have "lighting" (a panorama), "dimensions", "target",
"orbit" (theta and phi in degrees, radius), "verticalFoV" (degrees), "renderSkybox" and
"exclude" (renderers whose pictures do not count). Reference pictures are
goldens/NAME/RENDERER-golden.png beside the configuration.

In a folder without a configuration, each glTF file is a scenario with its own camera or the
tool's default view.
"""

import dataclasses
import json
import math
import pathlib

GOLDEN = "-golden.png"
DEFAULT_SIZE = 768


@dataclasses.dataclass
class Orbit:
    """Position of a camera around its target. theta: rotation about the vertical from the front, phi: angle from the
    zenith, both in degrees. radius: in scene units."""

    theta: float = 0.0
    phi: float = 90.0
    radius: float = 1.0


@dataclasses.dataclass
class Scenario:
    name: str
    model: pathlib.Path
    lighting: pathlib.Path = None  # None: the benchmark's own panorama
    width: int = DEFAULT_SIZE
    height: int = DEFAULT_SIZE
    orbit: Orbit = None  # None: the camera of the file, or the tool's default view
    target: tuple = (0.0, 0.0, 0.0)
    vertical_fov_deg: float = 45.0
    skybox: bool = False
    references: dict = dataclasses.field(default_factory=dict)

    def size(self, longest):
        """Returns the width and height in pixels, reduced to at most `longest`."""
        scale = min(1.0, longest / max(self.width, self.height))
        return max(1, round(self.width * scale)), max(1, round(self.height * scale))


def camera_place(orbit, target):
    """Returns the position of a camera on the orbit, and the quaternion (x, y, z, w) that rotates -z to its view
    direction."""
    theta, phi = math.radians(orbit.theta), math.radians(orbit.phi)
    away = (math.sin(phi) * math.sin(theta), math.cos(phi), math.sin(phi) * math.cos(theta))
    yaw, pitch = theta / 2, (phi - math.pi / 2) / 2
    turn = [math.cos(yaw) * math.sin(pitch), math.sin(yaw) * math.cos(pitch), -math.sin(yaw) * math.sin(pitch), math.cos(yaw) * math.cos(pitch)]
    return [t + orbit.radius * a for t, a in zip(target, away)], turn


def references_of(folder, name, excluded):
    found = sorted((folder / "goldens" / name).glob("*" + GOLDEN))
    pictures = {file.name.removesuffix(GOLDEN): file for file in found}
    return {renderer: file for renderer, file in pictures.items() if renderer not in excluded}


def scenario_of(entry, folder):
    """Raises SystemExit if a required key is missing."""
    missing = [key for key in ("name", "model") if not isinstance(entry.get(key), str)]
    if missing:
        raise SystemExit(f"{folder}: a scenario has no {missing[0]}: {json.dumps(entry)[:120]}")
    size, at = entry.get("dimensions", {}), entry.get("target", {})
    return Scenario(
        name=entry["name"], model=folder / entry["model"], lighting=folder / entry["lighting"] if entry.get("lighting") else None,
        width=size.get("width", DEFAULT_SIZE), height=size.get("height", DEFAULT_SIZE), orbit=Orbit(**entry.get("orbit", {})),
        target=tuple(at.get(axis, 0.0) for axis in "xyz"), vertical_fov_deg=entry.get("verticalFoV", 45.0),
        skybox=entry.get("renderSkybox", False), references=references_of(folder, entry["name"], entry.get("exclude", [])))


def files_below(folder):
    files = sorted(f for f in folder.rglob("*") if f.suffix.lower() in (".gltf", ".glb"))
    return [Scenario(name=f.stem, model=f, skybox=True, references=references_of(folder, f.stem, ())) for f in files]


def read(path):
    """Reads a configuration file or a folder."""
    config = path / "config.json" if path.is_dir() else path
    if path.is_dir() and not config.exists():
        found = files_below(path)
    else:
        try:
            found = [scenario_of(entry, config.parent) for entry in json.loads(config.read_text())["scenarios"]]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise SystemExit(f"{config}: not a configuration of scenarios: {error!r}")
    if not found:
        raise SystemExit(f"{path}: contains neither scenarios nor glTF files")
    return found
