"""One camera, several, or all: whatever way it is written, it means the same."""

from __future__ import annotations

import pytest

from sim.some_cameras import SomeCameras


@pytest.mark.parametrize(
    ("camera", "meant"),
    [
        ("rear", {"rear"}),
        (["rear", "left"], {"rear", "left"}),
        ("all", {"left", "rear", "front"}),
        (["all"], {"left", "rear", "front"}),
        (["rear", "all"], {"left", "rear", "front"}),
    ],
)
def test_it_concerns_the_cameras_that_are_meant(camera: object, meant: set[str]) -> None:
    several = SomeCameras.model_validate({"camera": camera})
    assert {name for name in ("left", "rear", "front") if several.concerns(name)} == meant
