"""Writes an HTML page with each renderer's pictures and their differences from the median of the others."""

import base64
import html

import numpy as np
import pictures

HEAD = """<!doctype html><html lang="en"><meta charset="utf-8"><title>glTF fidelity</title><style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em; background: #fff; color: #222 }
table { border-collapse: collapse } td, th { padding: .2em .8em; text-align: right } td:first-child, th:first-child { text-align: left }
tr:nth-child(even) { background: #f2f2f2 } .row { display: flex; flex-wrap: wrap; gap: 12px } figure { margin: 0 }
figcaption { max-width: 20em; margin-bottom: .3em } img { image-rendering: pixelated; width: 256px; display: block; margin-bottom: 4px }
</style><h1>glTF fidelity</h1>
<p>Each renderer against the median of the others: PSNR of 8-bit codes and the mean of FLIP (0: equal), over the pixels that any picture
covers. Below each picture: FLIP per pixel, black where both look equal, white at 0.5 and above. Not read: features of a file that
Blender's importer, or the surfaces that replace its own, leave out; such rows are no measure of the others.</p>
"""
STEEPNESS = 2.0  # FLIP is multiplied by this factor for display, so that 0.5 is white (HEAD states this value)


def shown(codes):
    return '<img alt="" src="data:image/png;base64,' + base64.b64encode(pictures.png(codes)).decode() + '">'


def heat(difference):
    grey = np.clip(255 * STEEPNESS * difference, 0, 255).astype(np.uint8)
    return np.repeat(grey[..., None], 3, axis=-1)


def decibels(value):
    return "same" if np.isinf(value) else f"{value:.2f}"


def has_both(row):
    return "cycles_speed" in row and "lippmann_speed" in row


def speed(row):
    if not has_both(row):
        return ""
    return "{lippmann_speed:.2f} : {cycles_speed:.2f} = {ratio:.2f} x".format(**row, ratio=row["lippmann_speed"] / row["cycles_speed"])


def not_read(row):
    return "; ".join(f"{name}: {', '.join(what)}" for name, what in row["unread"].items() if what)


def table(rows):
    renderers = sorted({name for row in rows for name in row["renderers"]}, key=lambda name: (name != "lippmann", name))
    lines = ["<table><tr><th>scenario" + "".join(f"<th>{html.escape(r)}, dB<th>FLIP" for r in renderers) + "<th>the others among each other, dB<th>noise alone, dB<th>million samples per CPU second<th>without a picture<th>not read"]
    for row in rows:
        cells = [row["renderers"].get(r) for r in renderers]
        lines.append(f'<tr><td><a href="#{html.escape(row["scenario"])}">{html.escape(row["scenario"])}</a>' +
                     "".join(f"<td>{decibels(c['psnr_db'])}<td>{c['flip']:.4f}" if c else "<td><td>" for c in cells) +
                     f"<td>{decibels(row['among_others_db']) if row['among_others_db'] is not None else ''}" + f"<td>{decibels(row['noise_db']) if has_both(row) else ''}<td>{speed(row)}<td>{html.escape(', '.join(row['failed']))}<td>{html.escape(not_read(row))}")
    return "\n".join(lines) + "</table>\n"


def figure(name, judged, picture):
    if judged is None:
        return f"<figure><figcaption><b>{html.escape(name)}</b></figcaption>{shown(pictures.before_grey(picture))}</figure>"
    return (f"<figure><figcaption><b>{html.escape(name)}</b> {decibels(judged['psnr_db'])} dB, FLIP {judged['flip']:.4f}</figcaption>" +
            shown(pictures.before_grey(picture)) + shown(heat(judged["map"])) + "</figure>")


class Page:
    """Builds the page from one scenario after another, so that the pictures of a scenario can be discarded after add()."""

    def __init__(self):
        self.rows, self.sections = [], []

    def add(self, row, judged, named):
        self.rows.append(row)
        notes = "".join(f"<p>{html.escape(note)}</p>" for note in row["notes"])
        figures = "".join(figure(name, judged.get(name), named[name]) for name in named)
        self.sections.append(f'<h2 id="{html.escape(row["scenario"])}">{html.escape(row["scenario"])}</h2>{notes}<div class="row">{figures}</div>\n')

    def write(self, path):
        path.write_text(HEAD + table(self.rows) + "".join(self.sections) + "</html>\n")
