# SPDX-License-Identifier: BSL-1.0
"""Builds the wheel for pip (PEP 517): CMake makes the package, and its files are put into an archive."""

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

root = pathlib.Path(__file__).resolve().parents[2]


def version() -> str:
    header = (root / "include/hilger/version.hpp").read_text()
    return ".".join(re.search(rf"HILGER_VERSION_{part} (\d+)", header)[1] for part in ("MAJOR", "MINOR", "PATCH"))


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None) -> str:
    cpython = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    name = f"hilger-{version()}-{cpython}-{cpython}-{platform}.whl"
    about = f"hilger-{version()}.dist-info"
    with tempfile.TemporaryDirectory() as build:
        options = ["-D", f"Python_EXECUTABLE={sys.executable}", "-B", build]
        subprocess.run(["cmake", "-S", str(root), "--preset", "python", *options], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "hilger_python", "-j", str(os.cpu_count() or 1)], check=True)
        package = pathlib.Path(build) / "python" / "hilger"
        files = {f"hilger/{file.name}": file.read_bytes() for file in sorted(package.iterdir()) if file.is_file()}
    files[f"{about}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: hilger\nVersion: {version()}\nSummary: Variational integrators from time-scale calculus\n"
        "License: BSL-1.0\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
    ).encode()
    files[f"{about}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: hilger\nRoot-Is-Purelib: false\nTag: {cpython}-{cpython}-{platform}\n".encode()
    files[f"{about}/LICENSE_1_0.txt"] = (root / "LICENSE_1_0.txt").read_bytes()
    record = ""
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(content)}\n"
    files[f"{about}/RECORD"] = f"{record}{about}/RECORD,,\n".encode()
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def build_sdist(sdist_directory, config_settings=None) -> str:
    name = f"hilger-{version()}"
    archive = pathlib.Path(sdist_directory) / f"{name}.tar.gz"
    subprocess.run(["git", "archive", f"--prefix={name}/", "-o", str(archive), "HEAD"], cwd=root, check=True)
    return archive.name
