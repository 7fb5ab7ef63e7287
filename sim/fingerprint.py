"""What a picture depends on besides settings and seed: driver, processor, package versions."""

from __future__ import annotations

import platform
from functools import cache
from importlib.metadata import version
from pathlib import Path

from sim.rendering.choice import probe
from sim.rendering.names import RendererName

_PACKAGES = ("mujoco", "numpy", "opencv-python-headless", "pyrender-maintained", "scipy")


@cache
def fingerprint(renderer: RendererName = "classic") -> dict[str, str]:
    """Return names and versions by part; pictures made under equal fingerprints are equal to the byte."""
    packages = {name: version(name) for name in _PACKAGES}
    return {
        "renderer": f"{renderer}, {probe(renderer).found}",
        "cpu": _cpu_name(),
        "platform": " ".join((platform.system(), platform.machine(), *platform.libc_ver())),
        "python": platform.python_version(),
    } | packages


def _cpu_name() -> str:
    lines = (
        Path("/proc/cpuinfo").read_text(errors="replace").splitlines()
        if Path("/proc/cpuinfo").exists()
        else []
    )
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()
