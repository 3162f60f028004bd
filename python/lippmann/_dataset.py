"""Training sets of random scenes as NumPy files, as `lippmann dataset` writes them."""

from __future__ import annotations

import os
from typing import Iterable, NamedTuple, Optional, Union

from . import _core
from ._arguments import integer, path, path_bytes, text
from ._errors import Error, Naming
from ._options import Progress

_MOST_SAMPLES = 1_000_000


class DatasetReport(NamedTuple):
    """The result of lippmann.dataset."""

    samples: int
    """Number of samples in the requested part of the data set (argument `unit`)."""
    kept: int
    """Number of samples that were complete before the call."""
    made: int
    """Number of samples rendered."""
    seconds: float
    """Time spent rendering and writing."""
    bytes: int
    """Number of bytes written."""
    complete: bool
    """Whether manifest.json and all samples of the whole data set exist."""
    remade: int = 0
    """Number of rendered samples that replace damaged ones."""


def dataset(
    scenes: Union[str, "os.PathLike[str]", Iterable[Union[str, "os.PathLike[str]"]]],
    folder: Union[str, "os.PathLike[str]"],
    count: int,
    *,
    seed: int = 0,
    rows: int = 9,
    columns: int = 9,
    size: int = 128,
    spp: int = 16,
    unit: Optional[str] = None,
    threads: int = 0,
    progress: Optional[Progress] = None,
) -> DatasetReport:
    """Writes `count` light fields of random scenes, with depth, disparity, normals, motion and ids, into a folder. The files have the
    same bytes as those of `lippmann dataset`. Intact samples in the folder are kept, so that a stopped call can be repeated.

    scenes: names of built-in scenes and files, or one of them; their meshes become objects, beside spheres and boxes.
    rows, columns: the grid of cameras. size: width and height of a view in pixels. spp: samples per pixel.
    unit: "I/N": make only the I-th of N parts; other calls, also at the same time, make the rest. None: all samples.
    threads: number of threads. 0: one per processor.
    progress: called as progress(made, share) about every 50 ms, in this thread, with the number of samples made so far and the share
        of the current one; an exception stops the call, and so does Ctrl-C.
    """
    if isinstance(scenes, (str, bytes, os.PathLike)):
        scenes = [scenes]
    if not isinstance(scenes, Iterable):
        raise Error("scenes", f"is {scenes!r}", "names of built-in scenes and files")
    params = _core.DatasetParams()
    params.scenes = [path_bytes(scene, "scenes") for scene in scenes]
    if not params.scenes:
        raise Error("scenes", "is empty", "names of built-in scenes and files")
    params.folder = path(folder, "folder")
    params.count = integer(count, "count", 1, _MOST_SAMPLES)
    params.seed = integer(seed, "seed", 0, 1 << 30)
    side = integer(size, "size", 8, 4096)
    params.set_views((integer(rows, "rows", 1, 1024), integer(columns, "columns", 1, 1024)), (side, side))
    params.spp = integer(spp, "spp", 1, 4096)
    params.unit = "" if unit is None else text(unit, "unit")
    workers = integer(threads, "threads", 0, 4096)
    if progress is not None and not callable(progress):
        raise Error("progress", f"is {progress!r}", "a function of the number of samples and the share of the current one")
    with Naming():
        report = _core.make_dataset(params, workers, progress)
    return DatasetReport(report.wanted, report.kept, report.made, report.seconds, report.bytes, report.is_complete, report.remade)
