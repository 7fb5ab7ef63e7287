"""What a machine needs to run rigtrue, one check each, with the exact remedy."""

from __future__ import annotations

import re
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, requires

import psutil

from estimator.errors import InputError
from eval.out_folder import make_folder
from eval.provenance import package_version
from scenarios.cache import RecordingCache
from sim.rendering.choice import RENDERER_NAMES, probe

_MIN_PYTHON = (3, 11)
_MIN_MEMORY_GB = 2.0
_MIN_DISK_GB = 1.0


@dataclass(frozen=True)
class Check:
    """One thing looked at: what was found, and what would mend it if it is not well.

    What is ``optional`` may be missing: only scenarios that ask for it need it.
    """

    name: str
    ok: bool
    found: str
    remedy: str = ""
    optional: bool = False

    @property
    def verdict(self) -> str:
        return "ok" if self.ok else "no" if self.optional else "BAD"


def diagnose() -> list[Check]:
    """Look at everything; renderers are tried in processes of their own."""
    return [_python(), _packages(), _opengl(), *_other_renderers(), *_cache(), _memory()]


def _python() -> Check:
    found = ".".join(map(str, sys.version_info[:3]))
    return Check("python", sys.version_info >= _MIN_PYTHON, found, "apt-get install python3.11; make setup")


def _packages() -> Check:
    missing = [name for name in _required_packages() if package_version(name) is None]
    own = package_version("rigtrue")
    if own is None:
        return Check("packages", False, "rigtrue is not installed", "make setup")
    found = f"missing: {', '.join(missing)}" if missing else f"rigtrue {own} and all it requires"
    return Check("packages", not missing, found, "make setup")


def _required_packages() -> Iterator[str]:
    try:
        lines = requires("rigtrue") or []
    except PackageNotFoundError:
        return
    for line in lines:
        name = re.match(r"[\w.-]+", line)
        if name and "extra ==" not in line:
            yield name.group()


def _opengl() -> Check:
    result = probe("classic")
    return Check("opengl", result.problem is None, result.found, result.remedy or "")


def _other_renderers() -> Iterator[Check]:
    """Name the renderers that scenarios may choose instead; nothing is wrong with a machine without them."""
    for name in RENDERER_NAMES:
        if name != "classic":
            result = probe(name)
            yield Check(name, result.problem is None, result.found, result.remedy or "", optional=True)


def _cache() -> Iterator[Check]:
    try:
        cache = RecordingCache.of_user()
        make_folder(cache.folder)
    except InputError as error:
        yield Check("cache", False, str(error), "export RIGTRUE_CACHE=DIR, a folder that you can write")
        return
    used_gb = cache.used_bytes() / 1e9
    free_gb = shutil.disk_usage(cache.folder).free / 1e9
    found = f"{cache.folder}: {used_gb:.1f} of {cache.cap_bytes / 1e9:.0f} GB used, {free_gb:.1f} GB free"
    yield Check("cache", free_gb >= _MIN_DISK_GB, found, f"free {_MIN_DISK_GB:.0f} GB, or set RIGTRUE_CACHE")


def _memory() -> Check:
    free_gb = psutil.virtual_memory().available / 1e9
    found = f"{free_gb:.1f} GB available, {psutil.cpu_count()} cores"
    return Check("memory", free_gb >= _MIN_MEMORY_GB, found, f"free {_MIN_MEMORY_GB:.0f} GB")
