"""The program lippmann: where it is, what it says, and a render of it as a child process that can be stopped.

Nothing here knows Blender, so that every failure is a ToolError with one sentence that can be shown to the user.
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import threading

STOP_SECONDS = 20.0  # the tool finishes the tiles under way and writes its report; then it is killed


class ToolError(Exception):
    """One sentence for the user."""


def find(preferred=""):
    """The path of the tool: the preferred one, else LIPPMANN_TOOL of the environment, else that of PATH."""
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
    """The JSON that a command prints."""
    try:
        done = subprocess.run([tool, *words, "--json"], capture_output=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ToolError(f"The tool lippmann does not answer: {error}") from error
    if done.returncode:
        raise ToolError(last_message(done.stderr.decode(errors="replace")))
    return json.loads(done.stdout)


def last_message(text, silent="The tool lippmann failed without a word."):
    """The error among what a program wrote, without its prefix; `silent` where it wrote nothing."""
    lines = [line.strip() for line in text.splitlines() if line.strip() and not line.startswith("{")]
    errors = [line for line in lines if re.match(r"(lippmann: )?error", line)]
    return re.sub(r"^(lippmann: )?(error: )?", "", (errors or lines or [silent])[-1])


class Child:
    """A running command. Its JSON lines of progress and all other lines of stderr are gathered by a thread."""

    def __init__(self, words, log, environment=None):
        self.finished_frames = set()
        self.share, self.seconds_left = 0.0, None
        self.step = ""  # the current step in words
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
        """Asks the child to stop as Ctrl-C does, so that what is finished stays; kills it where it does not."""
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
        """Raises what went wrong; to be called once it no longer runs."""
        self._close()
        if self._process.returncode:
            raise ToolError(last_message("\n".join(self.lines), f"{pathlib.Path(self._words[0]).name} ended with code {self._process.returncode} and without a word; see {self._log.name}."))


def pictures(folder, frame):
    """The finished pictures of a frame: one, or those of a folder of views. Names are those of docs/reference/formats.md."""
    folder = pathlib.Path(folder)
    stem = f"frame_{frame:04d}"
    found = sorted(path for path in folder.glob(stem + "*") if path.suffix in (".png", ".exr", ".tif", ".tiff"))
    inside = folder / stem
    return found or (sorted(path for path in inside.rglob("*") if path.suffix in (".png", ".exr")) if inside.is_dir() else [])
