"""Builds the wheel for `pip install .` (PEP 517) without packages from a network.

CMake and Ninja build the module in build/pip, linked with the system's libraries; scripts/wheel makes wheels for other machines.
Set LIPPMANN_BUILD in the environment to use a finished build instead.
"""

import base64
import hashlib
import os
import pathlib
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = pathlib.Path(os.environ["LIPPMANN_BUILD"]) if "LIPPMANN_BUILD" in os.environ else _built()
    version = _cached(build, "CMAKE_PROJECT_VERSION")
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    info = f"lippmann-{version}.dist-info"
    with tempfile.TemporaryDirectory() as prefix:
        files = dict(_package_files(build, pathlib.Path(prefix)))
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: lippmann\nVersion: {version}\nSummary: Renders 3D integral images and their animation\n"
        f"License: Apache-2.0\nRequires-Python: =={sys.version_info[0]}.{sys.version_info[1]}.*\nRequires-Dist: numpy\n"
    ).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: pip_backend\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/LICENSE"] = (SOURCE / "LICENSE").read_bytes()
    record = "".join(f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in files.items()) + f"{info}/RECORD,,\n"
    name = f"lippmann-{version}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in {**files, f"{info}/RECORD": record.encode()}.items():
            wheel.writestr(path, data)
    return name


def _built():
    """Builds the module for this Python, and returns the build folder."""
    build = SOURCE / "build/pip"
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}  # pip sets variables
                                                                                                        # that hide NumPy
    options = ["-DLIPPMANN_TESTS=OFF", "-DLIPPMANN_UNITY=ON", f"-DLIPPMANN_PYTHON={sys.executable}"]
    configure = ["cmake", "--preset", "release", "-B", build, *options]
    for command in (configure, ["cmake", "--build", build, "--target", "lippmann_python"]):
        try:
            subprocess.run(command, cwd=SOURCE, env=environment, check=True)
        except FileNotFoundError:
            sys.exit("cmake is missing: scripts/bootstrap build installs what building needs")
        except subprocess.CalledProcessError:
            sys.exit("the module cannot be built: pip install -v shows why; scripts/bootstrap installs what building needs")
    return build


def _package_files(build, prefix):
    """Yields names and contents of the installed package. The module is stripped."""
    install = ["cmake", "--install", build, "--component", "python3", "--strip", "--prefix", prefix]
    subprocess.run(install, check=True, stdout=subprocess.DEVNULL)
    packages = list(prefix.rglob("lippmann/__init__.py"))
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    if not packages or not (packages[0].parent / f"_core{suffix}").exists():
        sys.exit(f"{build} has no module _core{suffix} for {sys.executable}: python3-dev and pybind11-dev are needed")
    root = packages[0].parent.parent
    for file in sorted(packages[0].parent.iterdir()):
        yield str(file.relative_to(root)), file.read_bytes()


def _cached(build, name):
    lines = (build / "CMakeCache.txt").read_text().splitlines()
    return next(line.partition("=")[2] for line in lines if line.startswith(f"{name}:"))


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
