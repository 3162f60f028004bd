#!/usr/bin/env python3
"""Models the rendering of a film on many nodes with measured constants.

python3 bench/scaling.py prints the table of docs/lab/scaling.md. --help lists the parameters
for other films and machines. All times are wall times in seconds. The film is divided into
units, which are groups of frames. All nodes are equally fast, and each renders one unit at a
time.
"""

import argparse
import dataclasses
import heapq
import math
import random

NODES = [1, 10, 100, 300, 1000, 3000, 10000]
UNITS_PER_NODE = 8


@dataclasses.dataclass(frozen=True)
class Film:
    """docs/lab/scaling.md states the sources of the default values."""

    frames: int = 10_000
    segment: int = 1  # frames rendered together: the key frame interval if frames are reused
    frame_s: float = 60.0
    first_s: float = 0.0  # extra time of the first frame of a segment
    startup_s: float = 25.0  # time to start a process and load the scene, for every unit
    spread: float = 0.1  # standard deviation of a unit's time relative to its mean
    frame_bytes: float = 30e6
    disk_bytes_s: float = 1e9  # write rate of the shared folder for all nodes together
    syncs: int = 3  # number of times that a frame waits until the disk has synced
    disk_syncs_s: float = 250.0  # syncs per second of the shared folder for all nodes together


def segments_of(film):
    return math.ceil(film.frames / film.segment)


def unit_sizes(film, units):
    """Returns the number of frames of every unit. A segment is never split between units (src/distribute/units.cpp)."""
    segments = segments_of(film)
    parts = min(units, segments)
    sizes = [0] * parts
    for i in range(segments):
        sizes[i * parts // segments] += min(film.segment, film.frames - i * film.segment)
    return sizes


def unit_seconds(film, frames):
    return film.startup_s + frames * film.frame_s + math.ceil(frames / film.segment) * film.first_s


def whole_seconds(film):
    """Returns the time of the whole film on one node."""
    return unit_seconds(film, film.frames)


def disk_seconds(film):
    """Returns a lower bound of the time for any number of nodes, from the write rate and the syncs of the shared folder."""
    return film.frames * max(film.frame_bytes / film.disk_bytes_s, film.syncs / film.disk_syncs_s)


def longest_seconds(film, units):
    """Returns the expected time of the longest unit. For a normal distribution of n units, it is about sqrt(2 ln n)
    standard deviations above the mean."""
    sizes = unit_sizes(film, units)
    rendering = unit_seconds(film, max(sizes)) - film.startup_s
    return film.startup_s + rendering * (1.0 + film.spread * math.sqrt(2.0 * math.log(len(sizes))))


def bounds_seconds(film, nodes, units):
    """Returns (least, most), bounds of the time of the film.

    least = max(work / nodes, disk), most = max(work / nodes + (1 - 1 / nodes) longest, disk).
    `work` is the time of all units, `longest` that of the longest unit, and `disk` that of the
    shared folder. No node waits while units are left (Graham, Bounds on multiprocessing timing
    anomalies, 1969, theorem 1).
    """
    work = sum(unit_seconds(film, size) for size in unit_sizes(film, units))
    even = work / nodes
    disk = disk_seconds(film)
    return max(even, disk), max(even + (1.0 - 1.0 / nodes) * longest_seconds(film, units), disk)


def drawn_seconds(film, units, draw):
    """Returns random times of the units with a log-normal distribution, of which a few are much longer than the mean."""
    sigma = math.sqrt(math.log(1.0 + film.spread**2))
    return [
        film.startup_s + (unit_seconds(film, size) - film.startup_s) * math.exp(draw.gauss(-0.5 * sigma**2, sigma))
        for size in unit_sizes(film, units)
    ]


def scheduled_seconds(durations, nodes):
    """Returns the time at which the last unit ends, if each node takes the next unit as soon as it is free."""
    ends = [0.0] * nodes
    for duration in durations:
        heapq.heappush(ends, heapq.heappop(ends) + duration)
    return max(ends)


def simulated_seconds(film, nodes, units, seed):
    return max(scheduled_seconds(drawn_seconds(film, units, random.Random(seed)), nodes), disk_seconds(film))


def median_seconds(film, nodes, units, seeds=9):
    return sorted(simulated_seconds(film, nodes, units, seed) for seed in range(seeds))[seeds // 2]


def table(film, nodes_list, units_per_node):
    """Yields the lines of the scaling table in Markdown."""
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
