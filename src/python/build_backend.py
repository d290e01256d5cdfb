"""What `pip install .` and `python3 -m build` call (PEP 517): CMake builds the module where the first command builds the
program, so that what is compiled is not compiled again, and the package is zipped as a wheel."""

import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/release"
VERSION = re.search(r"project\(coilwright VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
METADATA = f"""Metadata-Version: 2.1
Name: coilwright
Version: {VERSION}
Summary: Sizes soft electromagnetic bending actuators and identifies the effect that a model lacks
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
"""


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Before anything is compiled, so that pip resolves and says what it installs at once."""
    info = pathlib.Path(metadata_directory) / f"coilwright-{VERSION}.dist-info"
    info.mkdir(exist_ok=True)
    (info / "METADATA").write_text(METADATA, encoding="utf-8")
    return info.name


def screen():
    """The terminal, to say there how far the compiler is: pip shows nothing of what a backend prints before it has failed."""
    try:
        return open("/dev/tty", "w", encoding="utf-8")
    except OSError:
        return None


def built_package() -> pathlib.Path:
    if shutil.which("cmake") is None:
        sys.exit("coilwright: cmake is not installed, which builds the package: scripts/setup.sh && scripts/setup.sh python")
    # A venv's interpreter is a link; the build folder must not depend on what is removed with the venv.
    python = os.path.realpath(sys.executable)
    log = ROOT / "build.log"
    with open(log, "w", encoding="utf-8") as said:
        failed = subprocess.run(["cmake", "--preset", "release", "-DCOILWRIGHT_PYTHON=ON", f"-DPython_EXECUTABLE={python}"],
                                cwd=ROOT, stdout=said, stderr=subprocess.STDOUT, check=False).returncode
    compiling = [sys.executable, ROOT / "scripts/build.py", "coilwright_python"]
    if failed or subprocess.run(compiling, stderr=screen(), check=False).returncode:
        sys.exit(log.read_text(encoding="utf-8"))
    log.unlink()
    return BUILD / "python/coilwright"


def record_line(name: str, content: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return wheel_of(built_package(), wheel_directory)


def wheel_of(package: pathlib.Path, wheel_directory) -> str:
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    info = f"coilwright-{VERSION}.dist-info"
    module = "_core" + sysconfig.get_config_var("EXT_SUFFIX")
    files = [file.name for file in sorted(package.iterdir())
             if file.suffix in (".py", ".pyi", ".typed") or file.name == "libcoilwright_opencv.so" and file.exists()]
    contents = {f"coilwright/{name}": (package / name).read_bytes() for name in [module, *files]}
    contents[f"{info}/METADATA"] = METADATA.encode()
    contents[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    contents[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: coilwright\nRoot-Is-Purelib: false\nTag: {tag}\n").encode()
    contents[f"{info}/RECORD"] = ("".join(record_line(*each) for each in contents.items()) + f"{info}/RECORD,,\n").encode()
    name = f"coilwright-{VERSION}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in contents.items():
            wheel.writestr(zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)
    return name


def build_sdist(sdist_directory, config_settings=None):
    base = f"coilwright-{VERSION}"
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True).stdout.decode()
    with tarfile.open(pathlib.Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
        for name in filter(None, files.split("\0")):
            archive.add(ROOT / name, f"{base}/{name}", recursive=False)
        (pathlib.Path(sdist_directory) / "PKG-INFO").write_text(METADATA, encoding="utf-8")
        archive.add(pathlib.Path(sdist_directory) / "PKG-INFO", f"{base}/PKG-INFO")
        (pathlib.Path(sdist_directory) / "PKG-INFO").unlink()
    return f"{base}.tar.gz"
