"""What was rendered once is used again on the machine that rendered it, and on no other one."""

from __future__ import annotations

from pathlib import Path

import pytest

import sim.fingerprint
from scenarios.load import load_scenario
from scenarios.recordings import cached_recording, fingerprint_of
from sim.rendering.choice import probe
from tests.integration.conftest import Command

NOMINAL = "tests.throwaway_estimators:Nominal"


def drawn(tiny: str) -> tuple[dict[str, str] | None, bool]:
    """Ask for the tiny recording; return what it says it was drawn by, and whether it was drawn now."""
    told: list[int] = []
    with cached_recording(load_scenario(tiny), 0, lambda done, total: told.append(done)) as bag:
        return fingerprint_of(bag), bool(told)


@pytest.fixture
def another_driver(monkeypatch: pytest.MonkeyPatch) -> None:
    other = sim.fingerprint.fingerprint() | {"renderer": "classic, egl: another GPU, another driver"}
    monkeypatch.setattr("sim.fingerprint.fingerprint", lambda renderer="classic": other)


def test_a_recording_of_this_machine_is_used_again(tiny: str) -> None:
    first, _ = drawn(tiny)
    assert drawn(tiny) == (first, False) and first == sim.fingerprint.fingerprint()


def test_a_recording_of_another_driver_is_not_used(tiny: str, request: pytest.FixtureRequest) -> None:
    before, _ = drawn(tiny)
    request.getfixturevalue("another_driver")
    after, now = drawn(tiny)
    assert now and after != before


def test_a_sweep_runs_again_what_another_driver_drew(command: Command, tiny: str, tmp_path: Path) -> None:
    (tmp_path / "some.yaml").write_text(
        f"about: A sweep.\nscenarios: [{tiny}]\nseeds: [0]\nestimators: ['{NOMINAL}']\n"
    )
    arguments = ("sweep", "./some.yaml", "--workers", 1, "--out", "out", "--quiet")
    assert command(*arguments) == 0
    (scores,) = (tmp_path / "out").glob("*/scores.json")
    own = scores.read_text()
    scores.write_text(own.replace('"renderer": "classic, ', '"renderer": "classic, another driver of '))
    assert command(*arguments) == 0
    assert "another driver" not in scores.read_text()


def test_what_cannot_be_drawn_is_refused_before_the_street_is_built(
    tiny: str, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    request.getfixturevalue("another_driver")
    monkeypatch.setenv("RIGTRUE_CACHE", str(request.getfixturevalue("tmp_path")))
    monkeypatch.setattr("sim.scene.build_street", None)
    monkeypatch.setattr("sim.rendering.vulkan.LIBRARY", "libnone.so")
    probe.cache_clear()  # what other tests found
    request.addfinalizer(probe.cache_clear)
    scenario = load_scenario(tiny, ["renderer=filament"])
    with (
        pytest.raises(ValueError, match=r"renderer 'filament' does not run .*apt-get install libvulkan1"),
        cached_recording(scenario, 0, lambda done, total: None),
    ):
        pass
