"""Renders a shot with other path tracers: with Cycles in Blender, and with three-gpu-pathtracer in
a browser.

Each renderer makes two PNG files, one with an eighth of the samples and one with all samples, and
returns a list of {"out", "cpu_seconds"}. cpu_seconds is None if the time includes other work than
rendering. Pictures are kept in the shot's folder until their inputs change.
"""

import hashlib
import json
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import peers
import pictures

HERE = pathlib.Path(__file__).resolve().parent
THREE = HERE / "three"


def few(spp):
    return max(1, spp // 8)


def job_of(shot, options):
    return {"file": str(shot.file), "panorama": shot.panorama and str(shot.panorama), "width": shot.width, "height": shot.height, "vertices": options.vertices,
            "threads": options.threads, "skybox": shot.scenario.skybox, "camera": shot.camera}


def key_of(job, shot, programs):
    """Returns a hash of everything on which a picture depends."""
    parts = [json.dumps(job, sort_keys=True).encode(), shot.file.read_bytes(), shot.panorama.read_bytes() if shot.panorama else b""]
    parts += [file.read_bytes() for file in programs]
    return hashlib.sha256(b"".join(hashlib.sha256(part).digest() for part in parts)).hexdigest()


def kept(shot, name, job, programs, render):
    """Returns the stored result of an earlier run with the same inputs. Without one, calls render(), stores its result
    and returns it."""
    file, key = shot.folder / f"{name}.json", key_of(job, shot, programs)
    if file.exists() and json.loads(file.read_text())["key"] == key:
        return json.loads(file.read_text())["renders"]
    asked = shot.folder / f"{name}-job.json"
    asked.write_text(json.dumps(job))
    renders = render(asked.resolve())
    file.write_text(json.dumps({"key": key, "renders": renders}))
    return renders


def in_blender(name):
    """Returns a function that renders with Cycles. The surfaces follow the glTF specification, or Blender's own
    importer if the name is "importer"."""

    def pictures_of(shot, options):
        renders = [{"samples": n, "seed": n, "out": str(shot.folder / f"{name}-{n}.png")} for n in (few(options.spp), options.spp)]
        job = {**job_of(shot, options), "own_surfaces": name == "importer", "renders": renders}
        if peers.BLENDER != "blender":
            job["blender"] = peers.BLENDER
        render = lambda file: [json.loads(line) for line in peers.blender("scenario_inside_blender.py", [file], "RENDER")]
        return kept(shot, name, job, sorted((HERE.parent / "cycles").glob("*.py")), render)

    return pictures_of


def unread(shot, name):
    """Returns the features of the file that the renderer is known not to show."""
    file = shot.folder / f"{name}.json"
    renders = json.loads(file.read_text())["renders"] if file.exists() else []
    return renders[-1].get("unread", []) if renders else []


def has_three():
    if shutil.which("node") and (THREE / "node_modules").is_dir():
        return True
    print("skipped: three-gpu-pathtracer is not installed (apt-get install nodejs npm chromium; npm ci in bench/fidelity/three)", file=sys.stderr)
    return False


def as_picture(file, width, height):
    """Writes a PNG file beside the output of trace.mjs, which is linear RGBA as 32-bit floats, lowest row first."""
    light = np.frombuffer(file.read_bytes(), "<f4").reshape(height, width, 4)[::-1].astype(float)
    cover = np.clip(light[..., 3:], 0, 1)
    codes = np.concatenate([pictures.encode(light[..., :3] / np.maximum(cover, 1e-9)), np.round(255 * cover).astype(np.uint8)], axis=-1)
    out = file.with_suffix(".png")
    out.write_bytes(pictures.png(codes))
    file.unlink()
    return str(out)


def three(shot, options):
    renders = [{"samples": n, "out": str(shot.folder / f"three-{n}.f32")} for n in (few(options.spp), options.spp)]
    job = {**job_of(shot, options), "renders": renders}

    def render(file):
        done = subprocess.run(["node", THREE / "trace.mjs", file], capture_output=True, text=True)
        found = [json.loads(line.removeprefix("RENDER")) for line in done.stdout.splitlines() if line.startswith("RENDER")]
        if done.returncode or len(found) < len(renders):
            raise peers.Failed(f"three-gpu-pathtracer: {peers.reason(done.stderr)}")
        return [{"out": as_picture(pathlib.Path(one["out"]), shot.width, shot.height), "cpu_seconds": None} for one in found]

    return kept(shot, "three", job, sorted(THREE.glob("*.*")), render)


RENDERERS = {"cycles": in_blender("cycles"), "importer": in_blender("importer"), "three": three}
