"""Builds the wheel for `pip install .` (PEP 517) without packages from a network.

CMake and Ninja build the module in build/pip. If the environment variable LIPPMANN_BUILD names a finished build folder, its
module is used instead.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent
VERSION_HEADER = "include/lippmann/core/version.hpp"


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes the metadata files. Without this hook, pip would build the whole wheel to get them."""
    info = f"lippmann-{_version()}.dist-info"
    folder = pathlib.Path(metadata_directory) / info
    folder.mkdir()
    for name, data in _metadata().items():
        (folder / name).write_bytes(data)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = pathlib.Path(os.environ["LIPPMANN_BUILD"]) if "LIPPMANN_BUILD" in os.environ else _built()
    info = f"lippmann-{_version()}.dist-info"
    with tempfile.TemporaryDirectory() as prefix:
        files = dict(_package_files(build, pathlib.Path(prefix)))
    files |= {f"{info}/{name}": data for name, data in _metadata().items()}
    record = "".join(f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in files.items()) + f"{info}/RECORD,,\n"
    name = f"lippmann-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in {**files, f"{info}/RECORD": record.encode()}.items():
            wheel.writestr(path, data)
    return name


def _metadata():
    python = f"{sys.version_info[0]}.{sys.version_info[1]}"
    metadata = (
        f"Metadata-Version: 2.1\nName: lippmann\nVersion: {_version()}\nSummary: Renders 3D integral images and their animation\n"
        f"License: Apache-2.0\nRequires-Python: =={python}.*\nRequires-Dist: numpy\n"
    )
    wheel = f"Wheel-Version: 1.0\nGenerator: pip_backend\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    return {"METADATA": metadata.encode(), "WHEEL": wheel.encode(), "LICENSE": (SOURCE / "LICENSE").read_bytes()}


def _tag():
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _version():
    header = (SOURCE / VERSION_HEADER).read_text()
    return ".".join(re.search(rf"#define LIPPMANN_VERSION_{part} (\d+)", header)[1] for part in ("MAJOR", "MINOR", "PATCH"))


def _built():
    build = SOURCE / "build/pip"
    # pip sets PYTHON... variables that hide NumPy from the build.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
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
    for component in ("python3", "hdf5"):
        install = ["cmake", "--install", build, "--component", component, "--strip", "--prefix", prefix]
        subprocess.run(install, check=True, stdout=subprocess.DEVNULL)
    packages = list(prefix.rglob("lippmann/__init__.py"))
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    if not packages or not (packages[0].parent / f"_core{suffix}").exists():
        sys.exit(f"{build} has no module _core{suffix} for {sys.executable}: python3-dev and pybind11-dev are needed")
    root = packages[0].parent.parent
    for file in sorted(packages[0].parent.iterdir()):
        yield str(file.relative_to(root)), file.read_bytes()
    for file in prefix.glob("lib/lippmann/*.so"):
        yield f"lippmann/{file.name}", file.read_bytes()


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
