"""The exception for bad input, and the category of warnings."""

from __future__ import annotations

import warnings


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


def warn(text: bytes) -> None:
    """A warning of the library, for whoever called the package."""
    warnings.warn(text.decode("utf-8", "replace"), LippmannWarning, stacklevel=2)
