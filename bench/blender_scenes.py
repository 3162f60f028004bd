#!/usr/bin/python3
"""Renders .blend files with Blender's Cycles and with the add-on. Prints the PSNR of 8-bit codes,
FLIP, and the add-on's warnings.

  bench/blender_scenes.py FILE_OR_FOLDER ... [--out DIR] [--size N] [--samples N] [--tool FILE] [--json]

Both renderers get the same file, frame, eye, number of samples and view transform. Writes
DIR/scenes.html with the pictures side by side. Needs python3-numpy and Blender. The environment
variable BLENDER names another version of Blender.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
for part in ("cycles", "fidelity"):
    sys.path.insert(0, str(HERE / part))
import judge  # noqa: E402
import page  # noqa: E402
import peers  # noqa: E402
import pictures  # noqa: E402


def files_of(paths):
    for path in paths:
        if not path.exists():
            raise SystemExit(f"{path}: there is no such file or folder")
        yield from sorted(path.rglob("*.blend")) if path.is_dir() else [path]


def rendered(file, options):
    """Returns a dictionary with "scene", "warnings" and "refused", and with "cycles" and "lippmann" if both pictures
    exist."""
    folder = (options.out / file.stem).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("cycles.png", "ours.png", "result.json"):
        (folder / name).unlink(missing_ok=True)
    job = folder / "job.json"
    job.write_text(json.dumps({"folder": str(folder), "size": options.size, "samples": options.samples, "addon": str(HERE.parent / "blender")}))
    command = [peers.BLENDER, "-b", "--factory-startup", "-noaudio", file, "--python", HERE / "cycles/blend_inside_blender.py", "--", job]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace", env={**os.environ, "PATH": peers.PATH, "LIPPMANN_TOOL": str(options.tool.resolve())})
    if not (folder / "result.json").exists():
        return {"scene": file.stem, "warnings": [], "refused": "Blender: " + (done.stderr or done.stdout).strip().splitlines()[-1]}
    row = {"scene": file.stem, **json.loads((folder / "result.json").read_text())}
    if not row["refused"]:
        row |= {"cycles": pictures.read(folder / "cycles.png"), "lippmann": pictures.read(folder / "ours.png")}
    return row


def judged(row):
    if "cycles" not in row:
        return row
    ours = judge.judged({"cycles": row["cycles"], "lippmann": row["lippmann"]})["lippmann"]
    light = [float(row[name][..., :3].mean()) for name in ("lippmann", "cycles")]
    return row | {"psnr_db": ours["psnr_db"], "flip": ours["flip"], "light": light[0] / max(light[1], 1e-3), "map": ours["map"]}


def figures(row):
    return f'{page.decibels(row["psnr_db"])} dB, FLIP {row["flip"]:.3f}, mean code {row["light"]:.2f} of Cycles\'' if "map" in row else row["refused"]


def html_page(rows):
    parts = [page.HEAD.replace("glTF fidelity", "Blender scenes")]
    for row in rows:
        parts.append(f'<h2>{page.html.escape(row["scene"])}</h2><p>{page.html.escape(figures(row))}</p>')
        if "map" in row:
            shown = ((name, row[name]) for name in ("cycles", "lippmann"))
            parts.append('<div class="row">' + "".join(f"<figure><figcaption>{name}</figcaption>{page.shown(codes)}</figure>" for name, codes in shown) +
                         f'<figure><figcaption>FLIP</figcaption>{page.shown(page.heat(row["map"]))}</figure></div>')
        parts.append("<ul>" + "".join(f"<li>{page.html.escape(text)}" for text in row["warnings"]) + "</ul>")
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("blender-scenes"))
    parser.add_argument("--size", type=int, default=192, help="longer side in pixels")
    parser.add_argument("--samples", type=int, default=256, help="paths per pixel, for both")
    parser.add_argument("--tool", type=pathlib.Path, default=HERE.parent / "build/release/lippmann")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    if not peers.has_blender():
        return 0
    rows = []
    for file in files_of(options.files):
        rows.append(judged(rendered(file, options)))
        print(f'{rows[-1]["scene"]:32} {figures(rows[-1])}', file=sys.stderr if options.json else sys.stdout, flush=True)
        (options.out / "scenes.html").write_text(html_page(rows))
    if options.json:
        print(json.dumps([{key: value for key, value in row.items() if key not in ("cycles", "lippmann", "map")} for row in rows], indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
