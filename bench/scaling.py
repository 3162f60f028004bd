#!/usr/bin/env python3
"""How a film renders on many nodes: a model of units, their start-up, stragglers, key frames and disks, with measured constants.

python3 bench/scaling.py prints the table of docs/lab/scaling.md; --help says what can be told of another film and other machines.

All times are wall times in seconds, on nodes that are alike. A node is what runs one unit at a time.
"""

import argparse
import dataclasses
import heapq
import math
import random

NODES = [1, 10, 100, 300, 1000, 3000, 10000]
UNITS_PER_NODE = 8  # as ranks of MPI have


@dataclasses.dataclass(frozen=True)
class Film:
    """A job and the machines that render it; docs/lab/scaling.md says where the default values come from."""

    frames: int = 10_000
    segment: int = 1  # frames that are made together: a key frame interval where frames are reused
    frame_s: float = 60.0  # to render a frame, on one node
    first_s: float = 0.0  # what the first frame of a segment takes more
    startup_s: float = 25.0  # to start a process and load the scene, which every unit pays
    spread: float = 0.1  # standard deviation of what a unit takes, as a share of it
    frame_bytes: float = 30e6  # of a frame's files
    disk_bytes_s: float = 1e9  # that the common folder takes of all nodes together
    syncs: int = 3  # waits for the disk a frame
    disk_syncs_s: float = 250.0  # that the common folder does for all nodes together


def segments_of(film):
    return math.ceil(film.frames / film.segment)


def unit_sizes(film, units):
    """Frames of every unit: as src/distribute/units.cpp cuts them, in whole segments."""
    segments = segments_of(film)
    parts = min(units, segments)
    sizes = [0] * parts
    for i in range(segments):
        sizes[i * parts // segments] += min(film.segment, film.frames - i * film.segment)
    return sizes


def unit_seconds(film, frames):
    return film.startup_s + frames * film.frame_s + math.ceil(frames / film.segment) * film.first_s


def whole_seconds(film):
    """On one node, in one process."""
    return unit_seconds(film, film.frames)


def disk_seconds(film):
    """Below which no number of nodes comes: the folder's bandwidth and its syncs."""
    return film.frames * max(film.frame_bytes / film.disk_bytes_s, film.syncs / film.disk_syncs_s)


def longest_seconds(film, units):
    """The longest of so many units: of a normal spread, about sqrt(2 ln n) deviations above the mean."""
    sizes = unit_sizes(film, units)
    rendering = unit_seconds(film, max(sizes)) - film.startup_s
    return film.startup_s + rendering * (1.0 + film.spread * math.sqrt(2.0 * math.log(len(sizes))))


def bounds_seconds(film, nodes, units):
    """(least, most). Nodes take the next unit as they are done with the last, so that none waits while there are units: all end
    within the longest unit of each other (Graham, Bounds on multiprocessing timing anomalies, 1969, theorem 1).

    least = max(work / nodes, disk), most = max(work / nodes + (1 - 1 / nodes) longest, disk).
    """
    work = sum(unit_seconds(film, size) for size in unit_sizes(film, units))
    even = work / nodes
    disk = disk_seconds(film)
    return max(even, disk), max(even + (1.0 - 1.0 / nodes) * longest_seconds(film, units), disk)


def drawn_seconds(film, units, draw):
    """What each unit takes, log-normal: none takes less than nothing, and a few take much longer."""
    sigma = math.sqrt(math.log(1.0 + film.spread**2))
    return [
        film.startup_s + (unit_seconds(film, size) - film.startup_s) * math.exp(draw.gauss(-0.5 * sigma**2, sigma))
        for size in unit_sizes(film, units)
    ]


def scheduled_seconds(durations, nodes):
    """When the last unit ends, where each node takes the next as it is done."""
    ends = [0.0] * nodes
    for duration in durations:
        heapq.heappush(ends, heapq.heappop(ends) + duration)
    return max(ends)


def simulated_seconds(film, nodes, units, seed):
    return max(scheduled_seconds(drawn_seconds(film, units, random.Random(seed)), nodes), disk_seconds(film))


def median_seconds(film, nodes, units, seeds=9):
    return sorted(simulated_seconds(film, nodes, units, seed) for seed in range(seeds))[seeds // 2]


def table(film, nodes_list, units_per_node):
    """Lines of the table: for each number of nodes its units, hours, and shares of what all nodes could do."""
    yield "| nodes | units | hours, simulated | efficiency, simulated | efficiency at least | disk busy |"
    yield "|---|---|---|---|---|---|"
    for nodes in nodes_list:
        units = len(unit_sizes(film, nodes * units_per_node))
        seconds, (_, most) = median_seconds(film, nodes, units), bounds_seconds(film, nodes, units)
        whole = whole_seconds(film)
        yield (
            f"| {nodes} | {units} | {seconds / 3600:.2f} | {whole / nodes / seconds:.1%} | {whole / nodes / most:.1%} "
            f"| {disk_seconds(film) / seconds:.1%} |"
        )


def read_film(parser):
    for field in dataclasses.fields(Film):
        parser.add_argument("--" + field.name.replace("_", "-"), type=field.type, default=field.default)
    parser.add_argument("--nodes", type=int, nargs="+", default=NODES)
    parser.add_argument("--units-per-node", type=int, default=UNITS_PER_NODE)
    given = parser.parse_args()
    return given, Film(**{field.name: getattr(given, field.name) for field in dataclasses.fields(Film)})


def main():
    given, film = read_film(argparse.ArgumentParser(description=__doc__.splitlines()[0]))
    for line in table(film, given.nodes, given.units_per_node):
        print(line)


if __name__ == "__main__":
    main()
