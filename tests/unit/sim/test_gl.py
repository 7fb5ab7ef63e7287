from __future__ import annotations

import os

import pytest

from estimator.errors import InputError
from sim.rendering import gl

EGL = ("libEGL.so.1", "libGL.so.1")


def test_egl_is_chosen_where_its_libraries_load(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine_with(monkeypatch, *EGL, "libOSMesa.so.8")
    assert gl.choose_backend() == os.environ["MUJOCO_GL"] == os.environ["PYOPENGL_PLATFORM"] == "egl"


@pytest.mark.parametrize("half", EGL)
def test_osmesa_is_chosen_where_egl_is_not_whole(monkeypatch: pytest.MonkeyPatch, half: str) -> None:
    _machine_with(monkeypatch, half, "libOSMesa.so.8")
    assert gl.choose_backend() == os.environ["MUJOCO_GL"] == os.environ["PYOPENGL_PLATFORM"] == "osmesa"


@pytest.mark.parametrize(("asked", "there"), [("osmesa", EGL), ("egl", ("libOSMesa.so.8",))])
def test_what_the_user_asks_for_is_never_replaced(
    monkeypatch: pytest.MonkeyPatch, asked: str, there: tuple[str, ...]
) -> None:
    _machine_with(monkeypatch, *there)
    monkeypatch.setenv("MUJOCO_GL", asked)
    for _ in range(2):  # the second time finds what the first one left
        assert gl.choose_backend() == asked
        assert os.environ["MUJOCO_GL"] == "off"


@pytest.mark.parametrize(
    ("there", "missing"),
    [((), "libEGL.so.1"), (("libEGL.so.1",), "libGL.so.1"), (("libGL.so.1",), "libEGL.so.1")],
)
def test_a_machine_without_gl_is_told_what_to_install(
    monkeypatch: pytest.MonkeyPatch, there: tuple[str, ...], missing: str
) -> None:
    _machine_with(monkeypatch, *there)
    monkeypatch.setattr(gl, "import_module", _fail)
    message = rf"\(egl: {missing} is missing\).*apt-get install libegl1 .*libgl1-mesa-dri"
    with pytest.raises(InputError, match=message):
        gl.open_context(8, 8)
    with pytest.raises(InputError, match=message):
        gl.require_gl()
    assert os.environ["MUJOCO_GL"] == "off"  # else importing MuJoCo would fail


def _machine_with(monkeypatch: pytest.MonkeyPatch, *libraries: str) -> None:
    for name in ("MUJOCO_GL", "PYOPENGL_PLATFORM"):  # restored after the test
        monkeypatch.setenv(name, "")
    monkeypatch.setattr(gl, "_loads", lambda library: library in libraries)


def _fail(name: str) -> None:
    raise ImportError(name)
