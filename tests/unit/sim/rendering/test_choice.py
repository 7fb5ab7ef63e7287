from __future__ import annotations

from collections.abc import Iterator

import mujoco
import pytest

from estimator.errors import InputError
from sim.rendering import choice
from sim.rendering.quality import SAMPLINGS, sampling_of, write_visual_settings


@pytest.fixture(autouse=True)
def no_memory() -> Iterator[None]:
    """Let no probe of one test answer in another."""
    choice.probe.cache_clear()
    yield
    choice.probe.cache_clear()


def test_a_machine_without_vulkan_is_told_what_to_install_and_what_runs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(choice, "vulkan_devices", lambda: [])
    monkeypatch.setattr(choice, "_draw", lambda name: None)
    with pytest.raises(InputError) as refusal:
        choice.open_renderer("filament", mujoco.MjSpec().compile())
    line = str(refusal.value)
    assert line.startswith("renderer 'filament' does not run on this machine (no Vulkan device")
    assert "apt-get install libvulkan1 mesa-vulkan-drivers" in line and "\n" not in line
    assert line.endswith("renderers that run here: classic, pyrender")


def test_pyrender_is_refused_where_opengl_is_not_egl(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "choose_backend", lambda: "osmesa")
    monkeypatch.setattr(choice, "vulkan_devices", lambda: [])
    with pytest.raises(
        InputError, match=r"it needs EGL, and OpenGL comes from osmesa.*apt-get install libegl1"
    ):
        choice.require_renderer("pyrender")


def test_what_a_broken_driver_says_last_is_the_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "vulkan_devices", lambda: ["some device, driver 1.2.3"])
    monkeypatch.setattr(choice, "_TRIAL", "import sys; sys.exit('first\\nthe device is lost')")
    assert choice.probe("filament").problem == "the device is lost"


def test_a_crash_without_a_word_is_a_problem_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "vulkan_devices", lambda: ["some device, driver 1.2.3"])
    monkeypatch.setattr(choice, "_TRIAL", "import os; os.abort()")
    assert choice.probe("filament").problem == "ended with exit code -6"


@pytest.mark.parametrize("quality", SAMPLINGS)
def test_a_model_carries_its_quality(quality: str) -> None:
    spec = mujoco.MjSpec()
    write_visual_settings(spec, (8, 8), quality)
    assert sampling_of(spec.compile()) is SAMPLINGS[quality]
    assert sampling_of(mujoco.MjSpec().compile()) is SAMPLINGS["standard"]
