"""Builds the wheel of pyproject.toml: what CMake builds and installs as the component python, packed (PEP 517)."""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def get_requires_for_build_wheel(config_settings=None):
    """What is needed comes from the system: a compiler, CMake, pybind11 and the libraries."""
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """`--config-settings build-dir=FOLDER` keeps the build tree elsewhere than in build/wheel."""
    folder = pathlib.Path((config_settings or {}).get("build-dir", ROOT / "build" / "wheel"))
    if not (folder / "CMakeCache.txt").exists():
        run("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DWAVECURVE_PYTHON=ON",
            "-DWAVECURVE_TESTS=OFF", "-DWAVECURVE_BENCHMARKS=OFF", f"-DPython3_EXECUTABLE={sys.executable}")
    run("cmake", "--build", folder, "--target", "wavecurve_python", "-j", os.cpu_count())
    return pack(folder, pathlib.Path(wheel_directory))


def pack(build_folder, wheel_directory):
    """The wheel of a build tree; its name."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(wavecurve VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    info, name = f"wavecurve-{version}.dist-info", f"wavecurve-{version}-{tag}.whl"
    with tempfile.TemporaryDirectory() as prefix:
        run("cmake", "--install", build_folder, "--component", "python", "--prefix", prefix, "--strip")
        package = pathlib.Path(prefix) / "lib" / "python3" / "dist-packages"
        files = {path.relative_to(package).as_posix(): path.read_bytes()
                 for path in sorted(package.rglob("*")) if path.is_file()}
    files[f"{info}/METADATA"] = metadata(project, version).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: wavecurve\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/RECORD"] = record(files, f"{info}/RECORD").encode()
    with zipfile.ZipFile(wheel_directory / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def metadata(project, version):
    lines = ["Metadata-Version: 2.1", "Name: wavecurve", f"Version: {version}", f"Summary: {project['description']}",
             f"License: {project['license']['text']}", f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {needed}" for needed in project["dependencies"]]
    for extra, packages in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f"Requires-Dist: {needed}; extra == '{extra}'" for needed in packages)]
    return "\n".join(lines) + "\n"


def record(files, own_name):
    """Each file's hash and size, but its own."""
    lines = []
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{path},sha256={digest},{len(content)}")
    return "\n".join([*lines, f"{own_name},,"]) + "\n"


def run(*command):
    subprocess.run([str(part) for part in command], check=True)
