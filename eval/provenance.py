"""What made a result: code, packages, renderer and machine. Goes into the header of ``scores.json``."""

from __future__ import annotations

import os
import platform
import subprocess
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from estimator.interface import EstimatorFactory
from eval.code_digest import code_digest
from scenarios.recordings import fingerprint_of

_PACKAGES = ("rigtrue", "gtsam", "mujoco", "numpy", "opencv-python-headless", "poselib", "scipy")


def provenance(make_estimator: EstimatorFactory, bag: Path) -> dict[str, Any]:
    """Return what made a result, as JSON values; what is not known is None.

    Args:
        make_estimator: The estimator, whose code is part of it.
        bag: The recording, which says what rendered it if it was simulated.
    """
    return {
        "commit": _git_commit(),
        "code": code_digest(make_estimator),
        "python": platform.python_version(),
        "versions": {name: package_version(name) for name in _PACKAGES},
        "renderer": fingerprint_of(bag),
        "cpu": _cpu_model(),
        "cpu_count": os.cpu_count(),
        "platform": platform.platform(),
    }


def package_version(name: str) -> str | None:
    """Return the installed version of a package, None where it is not installed."""
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _git_commit() -> str | None:
    """Return the commit of the checkout that this file lies in; ``+`` marks changes on top of it."""
    here = Path(__file__).parent
    command = ["git", "describe", "--always", "--abbrev=40", "--exclude=*", "--dirty=+"]
    try:
        answer = subprocess.run(command, cwd=here, capture_output=True, text=True, timeout=10)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return answer.stdout.strip() or None


def _cpu_model() -> str | None:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or None
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), None)
