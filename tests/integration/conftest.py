"""A scenario so small that it renders in seconds, and the command line to run it with."""

from collections.abc import Callable, Iterator
from pathlib import Path

import cv2
import pytest

from estimator.bundle import FrameBundle
from eval.cli import run_command_line
from tests.canyon_drive import canyon_bundles

_CAMERA = """\
  {name}:
    model: pinhole
    size_px: [64, 40]
    focal_px: [40.0, 40.0]
    center_px: [31.5, 19.5]
    ego_from_cam: {{translation_m: {translation}, quaternion_xyzw: {quaternion}}}
"""
_POSES = {
    "front": ("[1.8, 0.1, 1.45]", "[-0.5, 0.5, -0.5, 0.5]"),
    "left_front": ("[1.0, 0.9, 1.2]", "[-0.7, 0.1, -0.1, 0.7]"),
    "rear": ("[-0.8, 0.0, 1.1]", "[0.5, 0.5, -0.5, -0.5]"),
}
SCENARIO = """\
about: Three bundles of three tiny cameras on the shortest street.
rig: ./tiny_rig.yaml
street: {length_m: 20}
drive: {speed_mps: 5, distance_m: 1, rate_hz: 10}
"""

Command = Callable[..., int]


@pytest.fixture(scope="session")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with ``tiny.yaml`` and its rig; recordings are cached below it for the whole session."""
    folder = tmp_path_factory.mktemp("house")
    cameras = (
        _CAMERA.format(name=name, translation=pose[0], quaternion=pose[1]) for name, pose in _POSES.items()
    )
    (folder / "tiny_rig.yaml").write_text("reference: front\ncameras:\n" + "".join(cameras))
    (folder / "tiny.yaml").write_text(SCENARIO)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("RIGTRUE_CACHE", str(folder / "cache"))
        yield folder


@pytest.fixture
def tiny(house: Path) -> str:
    """The path of the tiny scenario."""
    return str(house / "tiny.yaml")


@pytest.fixture
def command(house: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Command:
    """Runs one command line in an empty working folder and returns its exit code."""
    monkeypatch.chdir(tmp_path)
    return lambda *arguments: run_command_line([str(argument) for argument in arguments])


@pytest.fixture(scope="module")
def one_thread() -> Iterator[None]:
    """OpenCV on one thread, so that the same images give the same bytes."""
    before = cv2.getNumThreads()
    cv2.setNumThreads(1)
    yield
    cv2.setNumThreads(before)


@pytest.fixture(scope="module")
def bundles(one_thread: None) -> list[FrameBundle]:
    """A short drive through the canyon; no renderer."""
    return canyon_bundles()
