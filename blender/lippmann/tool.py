"""Finds the program lippmann and runs it as a child process. Does not use Blender. Every failure is a ToolError."""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import threading

STOP_SECONDS = 20.0  # time for the child process to end before it is killed


class ToolError(Exception):
    """An error whose message is shown to the user."""


def find(preferred=""):
    """Returns the path of the tool: `preferred`, else the environment variable LIPPMANN_TOOL, else `lippmann` in PATH. Raises
    ToolError."""
    for wanted in (preferred, os.environ.get("LIPPMANN_TOOL", "")):
        if wanted:
            found = shutil.which(os.path.expanduser(wanted))
            if not found:
                raise ToolError(f"The tool lippmann is not at {wanted}. Correct its path in the add-on's preferences.")
            return found
    found = shutil.which("lippmann")
    if not found:
        raise ToolError("The tool lippmann was not found. Install it, or set its path in the add-on's preferences.")
    return found


def ask(tool, *words):
    """Runs a command with --json, and returns the JSON that it prints. Raises ToolError."""
    try:
        done = subprocess.run([tool, *words, "--json"], capture_output=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ToolError(f"The tool lippmann does not answer: {error}") from error
    if done.returncode:
        raise ToolError(last_message(done.stderr.decode(errors="replace")))
    return json.loads(done.stdout)


def last_message(text, silent="The tool lippmann failed without a word."):
    """Returns the last error message in a program's output, without its prefix, or `silent` if there is no output."""
    lines = [line.strip() for line in text.splitlines() if line.strip() and not line.startswith("{")]
    errors = [line for line in lines if re.match(r"(lippmann: )?error", line)]
    return re.sub(r"^(lippmann: )?(error: )?", "", (errors or lines or [silent])[-1])


class Child:
    """A child process. A thread reads its stderr, which mixes lines of JSON (progress) and other lines."""

    def __init__(self, words, log, environment=None):
        self.finished_frames = set()
        self.share, self.seconds_left = 0.0, None
        self.step = ""
        self.lines = []
        self._log = open(log, "ab")
        self._words = words
        try:
            self._process = subprocess.Popen([os.fspath(word) for word in words], stdin=subprocess.DEVNULL, stdout=self._log,
                                             stderr=subprocess.PIPE, env=environment)
        except OSError as error:
            self._log.close()
            raise ToolError(f"{words[0]} cannot be started: {error.strerror}") from error
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        for raw in self._process.stderr:
            self._log.write(raw)
            line = raw.decode(errors="replace").strip()
            if not line.startswith("{"):
                self.lines.append(line)
                continue
            try:
                told = json.loads(line)
            except ValueError:
                continue
            self.share, self.seconds_left = told.get("share", self.share), told.get("seconds_left")
            self.step = told.get("step", self.step)
            if told.get("frame") is not None and told.get("done"):
                self.finished_frames.add(told["frame"])
        self._log.flush()

    def running(self):
        return self._process.poll() is None

    def wait(self, seconds):
        try:
            self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            pass

    def stop(self):
        """Interrupts the child as Ctrl-C does, so that it keeps finished frames. Kills it after STOP_SECONDS."""
        if self.running():
            self._process.send_signal(signal.SIGINT if os.name != "nt" else signal.SIGTERM)
            self.wait(STOP_SECONDS)
        if self.running():
            self._process.kill()
            self._process.wait()
        self._close()

    def _close(self):
        self._reader.join(STOP_SECONDS)
        self._process.stderr.close()
        self._log.close()

    def check(self):
        """Raises ToolError if the child has failed. Call after the child has ended."""
        self._close()
        if self._process.returncode:
            raise ToolError(last_message("\n".join(self.lines), f"{pathlib.Path(self._words[0]).name} ended with code {self._process.returncode} and without a word; see {self._log.name}."))


def pictures(folder, frame):
    """Returns the paths of a frame's finished pictures: one picture, or the views in the frame's folder
    (docs/reference/formats.md)."""
    folder = pathlib.Path(folder)
    stem = f"frame_{frame:04d}"
    found = sorted(path for path in folder.glob(stem + "*") if path.suffix in (".png", ".exr", ".tif", ".tiff"))
    inside = folder / stem
    return found or (sorted(path for path in inside.rglob("*") if path.suffix in (".png", ".exr")) if inside.is_dir() else [])
