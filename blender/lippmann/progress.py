"""Formats progress as text, for Blender's status bar and for the terminal."""

import sys
import time

EVERY = 5.0  # minimum time between two lines about the same step, in seconds


def clock(seconds):
    """Formats a duration, as 7 s, 2:05 or 1:00:30."""
    whole = max(0, round(seconds))
    if whole < 60:
        return f"{whole} s"
    hours, minutes = divmod(whole // 60, 60)
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"


def sentence(step, share, seconds_left):
    words = [step] + ([f"{100.0 * share:.0f} %"] if share > 0.0 else [])
    if seconds_left is not None and share < 1.0:
        words.append(f"about {clock(seconds_left)} left")
    return ", ".join(words)


class Terminal:
    """Prints a line when a step begins, and then at most one every EVERY seconds."""

    def __init__(self, now=time.monotonic, file=None):
        self._now, self._file = now, file or sys.stderr
        self._step, self._due, self._line = "", 0.0, ""

    def say(self, step, share, seconds_left):
        now = self._now()
        line = sentence(step, share, seconds_left)
        if step == self._step and (now < self._due or line == self._line):
            return
        self._step, self._due, self._line = step, now + EVERY, line
        print(f"lippmann: {line}", file=self._file, flush=True)
