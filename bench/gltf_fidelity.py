#!/usr/bin/python3
"""Compares each renderer's pictures of glTF files with the median of the other renderers'
pictures.

  bench/gltf_fidelity.py FOLDER_OR_CONFIG [--out DIR] [--cycles] [--importer] [--three] [--only NAME ...] [--size N] [--spp N]
                         [--tone CURVE] [--json]

Scenarios come from a configuration as in glTF Render Fidelity, or from the glTF files of a
folder (bench/fidelity/scenarios.py). Each is rendered as one pinhole view.

  --cycles adds Cycles with the surfaces of bench/cycles/gltf_in_blender.py.
  --importer adds Cycles with Blender's own import of the file.
  --three adds three-gpu-pathtracer, which needs Chromium and `npm ci` in bench/fidelity/three.

Prints the PSNR and FLIP of each renderer, million samples per CPU second, and the PSNR that
noise alone would give. The CPU seconds of an eighth of the samples are subtracted from those of
all samples, which excludes the set-up.

Writes DIR/fidelity.html with the pictures side by side. Pictures of other renderers are kept in
DIR until their inputs change. Needs python3-numpy. --cycles and --importer need Debian's
blender.
"""

import argparse
import dataclasses
import json
import math
import pathlib
import struct
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
for part in ("cycles", "fidelity"):
    sys.path.insert(0, str(HERE / part))
import fixtures  # noqa: E402
import judge  # noqa: E402
import one_file  # noqa: E402
import others  # noqa: E402
import page  # noqa: E402
import peers  # noqa: E402
import pictures  # noqa: E402
import scenarios  # noqa: E402

VIEW = (25.0, 15.0)


@dataclasses.dataclass
class Shot:

    scenario: scenarios.Scenario
    file: pathlib.Path
    camera: str
    panorama: pathlib.Path
    width: int
    height: int
    folder: pathlib.Path


def has_lamps(doc):
    return bool(doc.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights"))


def place_camera(copy, scenario, options):
    """Adds the scenario's camera to the copy of the file. Without one, uses the file's own camera or the tool's default
    view."""
    if not scenario.orbit and copy.name_own_camera(scenario.width / scenario.height):
        return
    if scenario.orbit:
        place, turn = scenarios.camera_place(scenario.orbit, scenario.target)
        fov, reach = math.radians(scenario.vertical_fov_deg), max(scenario.orbit.radius, 1e-3)
    else:
        array = peers.info(options.tool, scenario.model)["array"]
        place, turn, fov = one_file.fitted(array, *VIEW)
        reach = array["viewing_distance"]
    copy.add_camera(place, turn, fov, scenario.width / scenario.height, reach)


def one_copy(model):
    try:
        return one_file.OneFile(model)
    except (OSError, ValueError, KeyError, struct.error) as error:  # the file is damaged, or a file that it refers to is missing
        raise peers.Failed(f"{model.name}: {error!r}") from error


def set_up(scenario, options):
    folder = options.out / scenario.name
    folder.mkdir(parents=True, exist_ok=True)
    copy = one_copy(scenario.model)
    place_camera(copy, scenario, options)
    file = folder / "scene.glb"
    copy.write(file)
    dark = options.dark and not scenario.lighting and has_lamps(copy.doc)
    panorama = None if dark else scenario.lighting or options.panorama
    return Shot(scenario, file, one_file.CAMERA, panorama, *scenario.size(options.size), folder)


def ours(shot, spp, options):
    out = shot.folder / f"lippmann-{spp}"
    command = [options.tool, "render", shot.file, "--camera", shot.camera, "--optics", "single", "--size", f"{shot.width}x{shot.height}", "--integrator", "path",
               "--denoise", "none", "--spp", spp, "--seed", spp, "--max-depth", options.vertices, "--threads", options.threads, "--frames", "0-0", "--environment",
               shot.panorama or "none", "--tone", options.tone, "-o", out, "--force", "-q"]
    if not shot.scenario.skybox:
        command.append("--transparent")
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        raise peers.Failed(peers.reason(done.stderr))
    return out / "frame_0000.png", json.loads((out / "report.json").read_text())["frames"][0]["cpu_seconds"]


def million_samples_per_second(shot, spp, seconds, few_seconds):
    return (spp - others.few(spp)) * shot.width * shot.height / max(seconds - few_seconds, 1e-9) * 1e-6


def few_and_all(shot, name, options):
    """Returns two pairs (file, CPU seconds): the picture with few samples, and the picture with all samples. The
    seconds are None if they include more than rendering."""
    if name != "lippmann":
        return [(pathlib.Path(r["out"]), r["cpu_seconds"]) for r in others.RENDERERS[name](shot, options)]
    return [ours(shot, spp, options) for spp in (others.few(options.spp), options.spp)]


def pictures_of(shot, name, options, facts):
    """Returns the picture of a renderer. Stores its speed, its noise and the features that it does not read in `facts`."""
    (less, few_seconds), (more, seconds) = few_and_all(shot, name, options)
    picture = pictures.read(more)
    if seconds is not None:
        facts[f"{name}_speed"] = million_samples_per_second(shot, options.spp, seconds, few_seconds)
    facts[f"{name}_noise"] = judge.noise(pictures.read(less), picture, options.spp / others.few(options.spp))
    return picture


def rendered(shot, options):
    """Returns {renderer: RGBA picture}, a dictionary of speeds and noise, notes, and {renderer: reason why its picture
    is missing}."""
    named, notes, facts, failed = {}, [], {}, {}
    for name in ["lippmann", *options.peers]:
        try:
            named[name] = pictures_of(shot, name, options, facts)
        except peers.Failed as failure:
            failed[name] = str(failure)
    for name, file in shot.scenario.references.items():
        reference = pictures.shrunk(pictures.read(file), shot.width, shot.height)
        if reference is None:
            notes.append(f"{name} is left out: the size of {file.name} is not a multiple of {shot.width} x {shot.height} pixels")
        else:
            named[name] = reference
    return named, facts, notes, failed


def row_of(scenario, named=None, facts=None, notes=(), failed=None, unread=None):
    """Returns the table row of a scenario. It has no figures if fewer than two renderers have a picture."""
    named, facts, failed, unread = named or {}, facts or {}, failed or {}, unread or {}
    judged = judge.judged(named) if len(named) > 1 else {}
    notes = [*notes, *(f"{name} has no picture: {why}" for name, why in failed.items()),
             *(f"{name} does not show {', '.join(what)}, which the file uses" for name, what in unread.items() if what)]
    among = judge.among_others(named, "lippmann") if judged else None
    return {"scenario": scenario.name, "notes": notes, "failed": failed, "unread": unread, "noise_db": judge.noise_together(facts), "among_others_db": among, **facts,
            "renderers": {name: {k: j[k] for k in ("psnr_db", "flip")} for name, j in judged.items()}}, judged


def measure(scenario, options, out):
    """Measures a scenario and adds it to the page. Returns its row, or None if there is nothing to compare with."""
    try:
        shot = set_up(scenario, options)
    except peers.Failed as failure:
        row, judged = row_of(scenario, failed={"lippmann": str(failure)})
        out.add(row, judged, {})
        return row
    named, facts, notes, failed = rendered(shot, options)
    if len(named) < 2 and not failed:
        print(f"{scenario.name}: no picture of another renderer; add goldens/{scenario.name}/RENDERER{scenarios.GOLDEN} or --cycles", file=sys.stderr)
        return None
    row, judged = row_of(scenario, named, facts, notes, failed, {name: others.unread(shot, name) for name in options.peers if name in named})
    out.add(row, judged, named)
    return row


def line(row):
    each = "  ".join(f"{name} {j['psnr_db']:.2f} dB, {j['flip']:.4f}" for name, j in row["renderers"].items())
    among = f"  the others among each other {row['among_others_db']:.2f} dB" if row["among_others_db"] is not None else ""
    noise = f"  noise alone {row['noise_db']:.2f} dB" if page.has_both(row) else ""
    notes = "".join(f"\n{'':24} {note}" for note in row["notes"])
    return f"{row['scenario']:24} {each}{among}{noise}  {page.speed(row)}".rstrip() + notes


def sentence(rows):
    """States in how many scenarios the PSNR of our picture against the median of the other pictures is at least the PSNR
    that the other pictures have among themselves. Returns "" if no scenario has two other renderers."""
    compared = [row for row in rows if row["among_others_db"] is not None and "lippmann" in row["renderers"]]
    near = sum(row["renderers"]["lippmann"]["psnr_db"] >= row["among_others_db"] for row in compared)
    return f"lippmann is as near to the median of the others as they are to one another in {near} of {len(compared)} scenarios" if compared else ""


def reservations(rows):
    failed = [row["scenario"] for row in rows if row["failed"]]
    unread = [row["scenario"] for row in rows if any(row["unread"].values())]
    return [f"{len(names)} of {len(rows)} scenarios {what}: {', '.join(names)}"
            for names, what in ((failed, "lack a renderer's picture"), (unread, "have something that a renderer does not read")) if names]


def without_infinity(value):
    """Replaces infinite numbers, the PSNRs of equal pictures, by null, because JSON has no infinity."""
    if isinstance(value, dict):
        return {key: without_infinity(item) for key, item in value.items()}
    if isinstance(value, list):
        return [without_infinity(item) for item in value]
    return None if value == math.inf else value


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenarios", type=pathlib.Path, metavar="FOLDER_OR_CONFIG")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("fidelity"), help="folder for pictures and the page")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="only these scenarios")
    parser.add_argument("--cycles", action="store_true")
    parser.add_argument("--importer", action="store_true")
    parser.add_argument("--three", action="store_true")
    parser.add_argument("--environment", type=pathlib.Path, dest="panorama", help="panorama for scenarios without lighting; default: a soft sky with a warm sun")
    parser.add_argument("--dark", action="store_true", help="use only a scenario's own panorama for files with lamps")
    parser.add_argument("--size", type=int, default=256, help="largest width or height of pictures, in pixels")
    parser.add_argument("--spp", type=int, default=256)
    parser.add_argument("--vertices", type=int, default=12, help="largest number of vertices of a path")
    parser.add_argument("--tone", default="none", help="our view transform, which must match the reference pictures: none, neutral or agx")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--tool", type=pathlib.Path, default=HERE.parent / "build" / "release" / "lippmann")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    options.out = options.out.resolve()
    options.peers = [name for name in others.RENDERERS if getattr(options, name)]
    if options.peers and options.tone != "none":
        parser.error("--tone: must be none beside renderers with plain sRGB pictures")
    return options


def chosen(options):
    found = scenarios.read(options.scenarios)
    unknown = set(options.only or []) - {s.name for s in found}
    if unknown:
        raise SystemExit(f"no such scenario: {', '.join(sorted(unknown))}; there are {', '.join(s.name for s in found)}")
    return [s for s in found if not options.only or s.name in options.only]


def main():
    options = parse()
    if {"cycles", "importer"} & set(options.peers) and not peers.has_blender() or "three" in options.peers and not others.has_three():
        return
    asked = chosen(options)
    options.out.mkdir(parents=True, exist_ok=True)
    if not options.panorama:
        options.panorama = options.out / "panorama.hdr"
        fixtures.write_panorama(options.panorama)
    out, rows = page.Page(), []
    for scenario in asked:
        row = measure(scenario, options, out)
        if row:
            rows.append(row)
            print(line(row), file=sys.stderr if options.json else sys.stdout, flush=True)
            out.write(options.out / "fidelity.html")
    for text in filter(None, [sentence(rows), *reservations(rows)]):
        print(text, file=sys.stderr if options.json else sys.stdout)
    if options.json:
        print(json.dumps(without_infinity({"bench": "fidelity", "rows": rows}), indent=2))
    if any("lippmann" in row["failed"] for row in rows):
        sys.exit(1)


if __name__ == "__main__":
    main()
