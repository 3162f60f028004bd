"""The exception for bad input, and the category of warnings."""

from __future__ import annotations

import sys
import warnings
from typing import Union


class Error(ValueError):
    """Bad input: an argument, a file, a size.

    where: the argument or file. problem: what is wrong with it. accepted: what would be accepted; empty where that is plain.
    """

    def __init__(self, where: str, problem: str, accepted: str = "") -> None:
        super().__init__(where, problem, accepted)
        self.where = where
        self.problem = problem
        self.accepted = accepted

    def __str__(self) -> str:
        return f"{self.where}: {self.problem}" + (f" (accepted: {self.accepted})" if self.accepted else "")


class LippmannWarning(UserWarning):
    """What is read but not supported, or chosen where nothing is said."""


def warn(text: Union[str, bytes]) -> None:
    """A warning for whoever called the package, through however many functions of it. bytes: a sentence of the library."""
    said = text if isinstance(text, str) else text.decode("utf-8", "replace")
    level, caller = 1, sys._getframe()
    while caller.f_back is not None and caller.f_globals.get("__package__") == __package__:
        level, caller = level + 1, caller.f_back
    warnings.warn(said, LippmannWarning, stacklevel=level)


def warn_of_ignored(argument: str, why: str) -> None:
    """An argument that changes nothing beside the others."""
    warn(f"`{argument}` is ignored: {why}.")
