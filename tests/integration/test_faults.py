"""Every fault on its way through recording, reader and estimator: told, mended or refused, never a crash."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter

from estimator.bag import Bag
from estimator.bag_rosbags import parse
from estimator.bundle import FrameBundle
from estimator.errors import InputError
from estimator.online import OnlineEstimator
from estimator.recording import Recording
from eval.truth import read_truth
from sim.bag_writer import BagWriter
from sim.faults.chain import FaultChain
from sim.faults.image_faults import WrongResolution
from sim.faults.kinds import WAY, AnyFault
from sim.simulate import simulate
from sim.streets.street import StreetConfig
from sim.vehicle.drive import DriveConfig
from sim.world import Snapshot, WorldConfig
from tests.integration.test_recorder import RIG

_PARSE: TypeAdapter[Any] = TypeAdapter(AnyFault)
_WORLD = WorldConfig(
    street=StreetConfig(length_m=20), drive=DriveConfig(distance_m=8, speed_mps=5, rate_hz=10)
)
COUNT = 17
ESTIMATED = [kind for kind in WAY if kind is not WrongResolution]  # that one is refused before


@pytest.fixture(scope="module")
def sound() -> list[Snapshot]:
    """A drive of 17 bundles of three cameras without faults."""
    return list(simulate(_WORLD, RIG, seed=0))


def spoilt(sound: list[Snapshot], folder: Path, *faults: dict[str, Any]) -> Path:
    """Record the drive with faults laid over its frames."""
    chain = FaultChain([_PARSE.validate_python(fault) for fault in faults], RIG.cameras, 0)
    with BagWriter(folder / "bag", RIG) as writer:
        for index, snapshot in enumerate(sound):
            time_s = _WORLD.drive.time_s(index)
            frames = chain.pass_on(snapshot.frames, index, time_s)
            writer.write(Snapshot(snapshot.truth, frames, chain.lasting(time_s)))
    return folder / "bag"


def read(bag: Path) -> tuple[list[FrameBundle], list[str]]:
    with Recording(bag, RIG) as recording:
        return list(recording.bundles()), recording.warnings


@pytest.mark.parametrize("kind", ESTIMATED, ids=lambda kind: kind.__name__)
def test_an_estimator_survives_every_fault(sound: list[Snapshot], tmp_path: Path, kind: Any) -> None:
    name = kind.model_fields["kind"].annotation.__args__[0]
    cameras = ["left_front", "rear"]
    faults = [{"kind": name, "camera": cameras}]
    if name not in ("swapped", "wrong_intrinsics"):  # the reference, too, for a while
        faults += [{"kind": name, "camera": "front", "at_s": 0.4, "duration_s": 0.7}]
    bundles, _ = read(spoilt(sound, tmp_path, *faults))
    estimator = OnlineEstimator(RIG)
    for bundle in bundles:
        assert np.isfinite(estimator.update(bundle).cameras["rear"].covariance).all()
    assert set(estimator.close().cameras) == set(RIG.cameras)


@pytest.mark.parametrize("at_s", [0.0, 0.8])
def test_images_of_a_wrong_size_are_refused_whenever_they_come(
    sound: list[Snapshot], tmp_path: Path, at_s: float
) -> None:
    fault = {"kind": "wrong_resolution", "camera": "rear", "size_px": [80, 50], "at_s": at_s}
    bag = spoilt(sound, tmp_path, fault)
    with pytest.raises(InputError, match="got images of 80 x 50 pixels, the rig states 160 x 100"):
        read(bag)


def test_late_frames_are_put_in_order_and_very_late_ones_told(sound: list[Snapshot], tmp_path: Path) -> None:
    late = {"kind": "late", "camera": "rear", "probability": 1.0}
    for folder in ("late", "too_late"):
        (tmp_path / folder).mkdir()
    bundles, warnings = read(spoilt(sound, tmp_path / "late", late | {"delay_ms": 250}))
    assert warnings == [] and len(bundles) == COUNT
    for bundle, snapshot in zip(bundles, sound, strict=True):
        assert np.array_equal(bundle.images["rear"], snapshot.bundle.images["rear"])
    _, warnings = read(spoilt(sound, tmp_path / "too_late", late | {"delay_ms": 900}))
    assert any("came too late to be put in order" in warning for warning in warnings)


def test_duplicates_are_left_out_and_told(sound: list[Snapshot], tmp_path: Path) -> None:
    fault = {"kind": "duplicated", "camera": "rear", "probability": 1.0}
    bundles, warnings = read(spoilt(sound, tmp_path, fault))
    assert len(bundles) == COUNT
    assert warnings == [f"{COUNT} images with a stamp its camera had already given, left out"]


def test_a_camera_that_goes_off_is_an_absent_key_from_then_on(sound: list[Snapshot], tmp_path: Path) -> None:
    bundles, _ = read(spoilt(sound, tmp_path, {"kind": "off", "camera": "rear", "at_s": 0.5}))
    assert ["rear" in bundle.images for bundle in bundles] == [True] * 5 + [False] * (COUNT - 5)


def test_a_camera_that_is_off_all_the_time_is_told_and_the_others_are_read(
    sound: list[Snapshot], tmp_path: Path
) -> None:
    bundles, warnings = read(spoilt(sound, tmp_path, {"kind": "off", "camera": "rear"}))
    assert warnings == ["camera 'rear': no image in the whole recording"]
    assert [set(bundle.images) for bundle in bundles] == [{"front", "left_front"}] * COUNT


def test_messages_lie_in_the_order_in_which_they_arrive(sound: list[Snapshot], tmp_path: Path) -> None:
    fault = {"kind": "late", "camera": "rear", "probability": 1.0, "delay_ms": 250}
    with Bag(spoilt(sound, tmp_path, fault)) as bag:
        stamps_ns = [m.header_stamp_ns for m in bag.messages(["/rear/image_raw", "/truth/odometry"])]
        kinds = [m.topic for m in bag.messages(["/rear/image_raw", "/truth/odometry"])]
    # the first late image comes between the third and the fourth truth
    assert kinds[:4] == ["/truth/odometry"] * 3 + ["/rear/image_raw"]
    assert stamps_ns[3] == stamps_ns[0]


def test_the_recording_tells_which_faults_are_there_and_the_truth_stays_true(
    sound: list[Snapshot], tmp_path: Path
) -> None:
    fault = {"kind": "clock_offset", "camera": "rear", "offset_ms": 40, "at_s": 0.5, "duration_s": 0.5}
    bag = spoilt(sound, tmp_path, fault, {"kind": "jitter", "camera": "all"})
    with Bag(bag) as source:
        told = [(m.header_stamp_ns, parse(m)) for m in source.messages(["/truth/faults"])]
    assert [[status.name for status in array.status] for _, array in told] == [
        ["jitter"],
        ["clock_offset", "jitter"],
        ["jitter"],
    ]
    offset = told[1][1].status[0]
    assert offset.hardware_id == "rear" and offset.message == "clock_offset: rear"
    assert {value.key: value.value for value in offset.values}["offset_ms"] == "40.0"
    assert [stamp_ns - sound[0].truth.stamp_ns for stamp_ns, _ in told] == [0, 500_000_000, 1_000_000_000]
    truth = read_truth(bag)
    assert truth is not None
    assert truth.stamps_ns == [snapshot.truth.stamp_ns for snapshot in sound]
