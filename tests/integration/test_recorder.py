"""A simulated drive survives the way through a bag, and the same seed gives the same bytes.

Two simulations of one seed are compared: one kept in memory, one recorded.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.recording import Recording
from estimator.rig import MountedCamera, Rig
from estimator.rig_file import read_rig
from eval.truth import read_truth
from sim.bag_writer import BagWriter
from sim.recorder import record
from sim.simulate import CLOCK_START_NS, simulate
from sim.streets.street import StreetConfig
from sim.vehicle.drive import DriveConfig
from sim.world import Snapshot, WorldConfig

GAP = read_rig(Path(__file__).parents[2] / "scenarios" / "rigs" / "gap.yaml")
CONFIG = WorldConfig(
    street=StreetConfig(length_m=20), drive=DriveConfig(distance_m=1.5, speed_mps=5.0, rate_hz=10.0)
)


def small(camera: Camera) -> Camera:
    """The same camera with a quarter of the pixels a side."""
    return replace(
        camera,
        size_px=(camera.size_px[0] // 4, camera.size_px[1] // 4),
        focal_px=(camera.focal_px[0] / 4, camera.focal_px[1] / 4),
        center_px=((camera.center_px[0] - 1.5) / 4, (camera.center_px[1] - 1.5) / 4),
    )


RIG = Rig(
    "front",
    {
        name: MountedCamera(small(GAP[name].camera), GAP[name].ego_from_cam)
        for name in ("front", "left_front", "rear")
    },
)


@pytest.fixture(scope="module")
def snapshots() -> list[Snapshot]:
    return list(simulate(CONFIG, RIG, seed=5))


@pytest.fixture(scope="module")
def bag(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recorder") / "drive"
    record(CONFIG, RIG, 5, path)
    return path


def test_images_come_back_to_the_bit(snapshots: list[Snapshot], bag: Path) -> None:
    with Recording(bag, RIG) as recording:
        bundles = list(recording.bundles())
        assert recording.warnings == []
    assert [bundle.stamp_ns for bundle in bundles] == [
        CLOCK_START_NS + round(CONFIG.drive.time_s(index) * 1e9) for index in range(4)
    ]
    for bundle, snapshot in zip(bundles, snapshots, strict=True):
        for name in RIG.cameras:
            assert np.array_equal(bundle.images[name], snapshot.bundle.images[name])


def test_truth_comes_back(snapshots: list[Snapshot], bag: Path) -> None:
    track = read_truth(bag)
    assert track is not None
    assert len(track.extrinsics) == 1  # sent again only when it changes
    for pose, snapshot in zip(track.world_from_ego, snapshots, strict=True):
        assert np.abs(pose.local(snapshot.truth.world_from_ego)).max() < 1e-12
        for name, ego_from_cam in track.ego_from_cams_at(snapshot.bundle.stamp_ns).items():
            assert np.abs(ego_from_cam.local(snapshot.truth.ego_from_cams[name])).max() < 1e-9


def test_the_same_seed_gives_the_same_bag_bytes(snapshots: list[Snapshot], bag: Path, tmp_path: Path) -> None:
    with BagWriter(tmp_path / "drive", RIG) as writer:  # the bag of another simulation of the same seed
        for snapshot in snapshots:
            writer.write(snapshot)
    assert _contents(tmp_path / "drive") == _contents(bag)


def test_images_are_textured(snapshots: list[Snapshot]) -> None:
    for image in snapshots[0].bundle.images.values():
        assert image.std() > 15


def test_an_interrupted_recording_leaves_nothing(
    snapshots: list[Snapshot], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    closed = []

    def simulate_again(*_: object) -> Iterator[Snapshot]:
        try:
            yield from snapshots
        finally:
            closed.append(True)

    def interrupt(done: int, total: int) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("sim.recorder.simulate", simulate_again)
    with pytest.raises(KeyboardInterrupt):
        record(CONFIG, RIG, 5, tmp_path / "drive", interrupt)
    assert list(tmp_path.iterdir()) == []
    assert closed  # which is where the renderer is freed


def test_a_name_that_is_taken_is_refused(bag: Path) -> None:
    before = _contents(bag)
    with pytest.raises(InputError, match="exists already"):
        record(CONFIG, RIG, 5, bag)
    assert _contents(bag) == before


def _contents(folder: Path) -> dict[str, bytes]:
    return dict(_files(folder))


def _files(folder: Path) -> Iterator[tuple[str, bytes]]:
    for path in sorted(folder.iterdir()):
        yield path.name, path.read_bytes()
