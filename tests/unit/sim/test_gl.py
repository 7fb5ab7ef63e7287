from __future__ import annotations

import pytest

from estimator.errors import InputError
from sim import gl


def test_egl_is_chosen_where_its_library_loads(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine_with(monkeypatch, "libEGL.so.1", "libOSMesa.so.8")
    assert gl.choose_backend() == "egl"


def test_osmesa_is_chosen_where_egl_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine_with(monkeypatch, "libOSMesa.so.8")
    assert gl.choose_backend() == "osmesa"


def test_a_machine_without_gl_is_told_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine_with(monkeypatch)
    monkeypatch.setattr(gl, "import_module", _fail)
    with pytest.raises(
        InputError, match=r"libEGL.so.1 is missing.*apt-get install libegl1 .*libgl1-mesa-dri"
    ):
        gl.open_context(8, 8)


def _machine_with(monkeypatch: pytest.MonkeyPatch, *libraries: str) -> None:
    for name in ("MUJOCO_GL", "PYOPENGL_PLATFORM"):  # restored after the test
        monkeypatch.setenv(name, "")
    monkeypatch.setattr(gl, "_loads", lambda library: library in libraries)


def _fail(name: str) -> None:
    raise ImportError(name)
