"""Choose the off-screen OpenGL of this process: EGL first, OSMesa where EGL is missing, else none.

MuJoCo and PyOpenGL read their choice from the environment when they are first imported, so the package
``sim`` calls ``choose_backend`` before anything else. MuJoCo's import fails where the chosen library is
missing, so there it is told to bind none, and only rendering fails. ``probe_gl`` tries a choice in a process
of its own: a broken driver may crash it without harm.
"""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from estimator.errors import InputError

# What a backend loads: one library of each group.
LIBRARIES = {
    "egl": (("libEGL.so.1",), ("libGL.so.1", "libOpenGL.so.0")),
    "osmesa": (("libOSMesa.so.8",),),
}
REMEDY = {
    "egl": "apt-get install libegl1 libgl1 libgl1-mesa-dri",
    "osmesa": "apt-get install libosmesa6",
}
_NO_BINDING = "off"
_PROBE_TIMEOUT_S = 60
_MOST_THREADS = 8  # llvmpipe gains little beyond
_PROBE = """
import mujoco
from OpenGL import GL
model = mujoco.MjModel.from_xml_string("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
with mujoco.Renderer(model, 8, 8) as renderer:
    renderer.update_scene(mujoco.MjData(model))
    renderer.render()
    print("renderer:", b", ".join([GL.glGetString(GL.GL_RENDERER), GL.glGetString(GL.GL_VERSION)]).decode())
"""


@dataclass(frozen=True)
class GlProbe:
    """What became of rendering one image.

    Attributes:
        backend: ``egl`` or ``osmesa``.
        renderer_name: As the driver calls itself, with its version.
        problem: One line saying why nothing was rendered; None when all is well.
        remedy: The command that would mend it; None when all is well.
    """

    backend: str
    renderer_name: str | None
    problem: str | None
    remedy: str | None


def choose_backend() -> str:
    """Set ``MUJOCO_GL`` and ``PYOPENGL_PLATFORM`` unless the user already chose; return the backend.

    Where a library of the backend is missing ``MUJOCO_GL`` is ``off``, and the other one keeps the choice.
    """
    backend = os.environ.get("MUJOCO_GL", "").lower()
    if backend == _NO_BINDING:
        backend = os.environ.get("PYOPENGL_PLATFORM", "").lower()
    if backend not in LIBRARIES:
        backend = next((name for name in LIBRARIES if _missing_library(name) is None), "egl")
    os.environ["PYOPENGL_PLATFORM"] = backend
    os.environ["MUJOCO_GL"] = backend if _missing_library(backend) is None else _NO_BINDING
    # Mesa's software rasteriser else runs on one core in some containers; pictures do not depend on it.
    os.environ.setdefault("LP_NUM_THREADS", str(min(len(os.sched_getaffinity(0)), _MOST_THREADS)))
    return backend


def open_context(width_px: int, height_px: int) -> Any:
    """Make an OpenGL context current and return it; its ``free`` ends it.

    Asks the backend's own module, so that it does not matter who imported MuJoCo first.

    Raises:
        InputError: This machine cannot render; the line names the package to install.
    """
    try:
        context = import_module(f"mujoco.{choose_backend()}").GLContext(width_px, height_px)
        context.make_current()
    except Exception as error:  # the bindings raise what they like, down to AttributeError
        raise no_gl_error(error) from error
    return context


def no_gl_error(cause: Exception | str) -> InputError:
    """Say in one line that this machine cannot render, why, and what to install."""
    backend = choose_backend()
    reason = _missing_library(backend) or " ".join(str(cause).split()) or type(cause).__name__
    return InputError(
        f"no off-screen OpenGL on this machine ({backend}: {reason}); wanted EGL or OSMesa: "
        f"{REMEDY['egl']} (or {REMEDY['osmesa']})"
    )


def require_gl() -> None:
    """See that this machine can render, which takes a second.

    Raises:
        InputError: It cannot; the line names the package to install.
    """
    problem = probe_gl().problem
    if problem is not None:
        raise no_gl_error(problem)


def probe_gl() -> GlProbe:
    """Render one tiny image in another process with the backend chosen for this one."""
    backend = choose_backend()
    missing = _missing_library(backend)
    if missing is not None:
        return GlProbe(backend, None, missing, REMEDY[backend])
    try:
        probe = subprocess.run(
            [sys.executable, "-c", _PROBE], capture_output=True, text=True, timeout=_PROBE_TIMEOUT_S
        )
    except subprocess.TimeoutExpired:
        return GlProbe(backend, None, f"rendering hung for {_PROBE_TIMEOUT_S} s", REMEDY[backend])
    for line in probe.stdout.splitlines():
        if line.startswith("renderer: ") and probe.returncode == 0:
            return GlProbe(backend, line.removeprefix("renderer: "), None, None)
    last = (probe.stderr.strip().splitlines() or [f"exit code {probe.returncode}"])[-1]
    return GlProbe(backend, None, last, REMEDY[backend])


def _missing_library(backend: str) -> str | None:
    """Say which library of a backend does not load; None if all do."""
    for group in LIBRARIES[backend]:
        if not any(_loads(library) for library in group):
            return f"{group[0]} is missing"
    return None


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
