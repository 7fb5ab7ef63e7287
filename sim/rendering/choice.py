"""Which renderer draws: by name, and whether this machine can run it.

``probe`` tries a renderer in a process of its own, because a broken driver may crash or hang it. What is
found holds for the whole life of the calling process.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import get_args

import mujoco

from estimator.errors import InputError
from sim.rendering.classic import ClassicRenderer
from sim.rendering.gl import REMEDY, choose_backend, no_gl_error, probe_gl
from sim.rendering.names import RendererName
from sim.rendering.view import Renderer
from sim.rendering.vulkan import REMEDY as VULKAN_REMEDY
from sim.rendering.vulkan import vulkan_devices

RENDERER_NAMES: tuple[RendererName, ...] = get_args(RendererName)

_TIMEOUT_S = 120
_TRIAL = """
import numpy as np, mujoco
from estimator.camera import Camera
from estimator.se3 import SE3
from sim.rendering.choice import _OPEN
from sim.rendering.quality import write_visual_settings
from sim.rendering.view import View
spec = mujoco.MjSpec()
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[1, 0, 0], pos=[0, 0, 3])
write_visual_settings(spec, (16, 16))
model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
camera = Camera("pinhole", (16, 16), (20.0, 20.0), (7.5, 7.5))
with _OPEN["{name}"](model) as renderer:
    picture = renderer.render(data, {{"eye": View(camera, SE3.exp(np.zeros(6)))}}, depth=True)["eye"]
assert abs(picture.depth_m[8, 8] - 2) < 0.1, "the depth of a ball is wrong"
print("drawn by:", "{name}")
"""


@dataclass(frozen=True)
class RendererProbe:
    """What became of drawing one image; ``problem`` and ``remedy`` are None when all is well."""

    name: RendererName
    found: str
    problem: str | None = None
    remedy: str | None = None


def open_renderer(name: RendererName, model: mujoco.MjModel) -> Renderer:
    """Open a renderer for a model; it is a context manager.

    Raises:
        InputError: This machine cannot run it; the line names the packages to install.
    """
    if name != "classic":  # that one says by itself what is wrong
        require_renderer(name)
    return _OPEN[name](model)


def require_renderer(name: RendererName) -> None:
    """See that this machine can run a renderer.

    Raises:
        InputError: It cannot; the line names the packages to install.
    """
    result = probe(name)
    if result.problem is not None and name == "classic":
        raise no_gl_error(result.problem)
    if result.problem is not None:
        able = [other for other in RENDERER_NAMES if other != name and probe(other).problem is None]
        raise InputError(
            f"renderer '{name}' does not run on this machine ({result.problem}); wanted: {result.remedy}; "
            f"renderers that run here: {', '.join(able) or 'none'}"
        )


@cache
def probe(name: RendererName) -> RendererProbe:
    """Draw one tiny image in another process."""
    if name == "classic":
        gl = probe_gl()
        return RendererProbe(name, f"{gl.backend}: {gl.renderer_name or gl.problem}", gl.problem, gl.remedy)
    found, lacking, remedy = _needs_filament() if name == "filament" else _needs_pyrender()
    problem = lacking or _draw(name)
    return RendererProbe(name, problem or found, problem, remedy if problem else None)


def _needs_filament() -> tuple[str, str | None, str]:
    devices = vulkan_devices()
    lacking = None if devices else "no Vulkan device: its loader or every driver of it is missing"
    return f"vulkan: {'; '.join(devices)}", lacking, VULKAN_REMEDY


def _needs_pyrender() -> tuple[str, str | None, str]:
    backend = choose_backend()
    lacking = None if backend == "egl" else f"it needs EGL, and OpenGL comes from {backend}"
    return f"egl: {probe_gl().renderer_name}", lacking or probe_gl().problem, REMEDY["egl"]


def _draw(name: RendererName) -> str | None:
    """Return what went wrong, in one line."""
    command = [sys.executable, "-c", _TRIAL.format(name=name)]
    try:
        trial = subprocess.run(command, capture_output=True, text=True, timeout=_TIMEOUT_S)
    except subprocess.TimeoutExpired:
        return f"drawing hung for {_TIMEOUT_S} s"
    if trial.returncode == 0 and f"drawn by: {name}" in trial.stdout:
        return None
    ended = f"ended with exit code {trial.returncode}"
    return (trial.stderr.strip().splitlines() or [ended])[-1]


def _open_filament(model: mujoco.MjModel) -> Renderer:
    opened: Renderer = import_module("sim.rendering.filament").FilamentRenderer(model)
    return opened


def _open_pyrender(model: mujoco.MjModel) -> Renderer:
    opened: Renderer = import_module("sim.rendering.pyrender_renderer").PyrenderRenderer(model)
    return opened


_OPEN: dict[RendererName, Callable[[mujoco.MjModel], Renderer]] = {
    "classic": ClassicRenderer,
    "filament": _open_filament,
    "pyrender": _open_pyrender,
}
