"""Finds the sources that scripts/check_includes and scripts/check_tidy check."""

import json
import os
import pathlib
import re
import subprocess

FOLDERS = ("src/", "apps/", "bench/")
SIX_HOURS_S = 6 * 3600
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def compile_commands(build, joined):
    """Configures a build in the folder `build`. Returns {source: entry of the compilation database}. joined: "ON" makes CMake
    join sources; the result then lists the joined files."""
    configure = ["cmake", "-S", ".", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DLIPPMANN_UNITY={joined}"]
    configure += ["-DLIPPMANN_PCH=OFF", "-DLIPPMANN_TESTS=OFF", "-DLIPPMANN_BENCH=ON", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"]
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    entries = json.loads(pathlib.Path(build, "compile_commands.json").read_text())
    return {os.path.relpath(entry["file"]): entry for entry in entries}


def of_checked_folders(commands):
    return {path: entry for path, entry in commands.items() if path.startswith(FOLDERS)}


def default_start():
    """Returns the last commit at least six hours older than HEAD, or the empty tree if history is shorter."""
    since = int(output("git", "log", "-1", "--format=%ct")) - SIX_HOURS_S
    base = output("git", "rev-list", "-1", f"--before={since}", "HEAD").strip()
    return base or output("git", "hash-object", "-t", "tree", "/dev/null").strip()


def changed_files(base):
    base = base or default_start()
    return set(output("git", "diff", "--name-only", "--diff-filter=d", base).split())


def by_last_change():
    """Returns {file: rank}. Files that changed later have lower ranks."""
    names = output("git", "log", "--format=", "--name-only").splitlines()
    return {name: place for place, name in reversed(list(enumerate(filter(None, names))))}


def includes(path):
    found = set()
    for name in INCLUDE.findall(pathlib.Path(path).read_text()):
        found.update(root + name for root in ("include/", "src/", "") if os.path.exists(root + name))
    return found


def affected(commands, changed):
    return {path for path in commands if path in changed or includes(path) & changed}
