"""Inertial topics in a bag: there when asked for, in order, and no hindrance to who reads the images."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from estimator.bag import Bag
from estimator.bag_rosbags import parse
from estimator.recording import Recording
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from sim.bag_writer import BagWriter
from sim.vehicle.car import CarConfig
from sim.vehicle.car_sensors import CarSensors
from sim.vehicle.drive import DriveConfig
from sim.vehicle.inertial import InertialConfig
from sim.vehicle.motion import Motion
from sim.world import CLOCK_START_NS, Snapshot, Truth
from tests.drives import STRAIGHT
from tests.mounts import PINHOLE

RIG = Rig("front", {name: MountedCamera(PINHOLE, SE3()) for name in ("front", "rear")})
BUNDLES = 12


def write(bag: Path, inertial: InertialConfig | None) -> None:
    """Write a drive at 10 bundles a second whose images are grey."""
    width, height = PINHOLE.size_px
    images = {name: np.full((height, width), 90, np.uint8) for name in RIG.cameras}
    sensors = CarSensors(inertial, Motion(DriveConfig(), STRAIGHT, None, CarConfig()), CarConfig(), 0)
    with BagWriter(bag, RIG, inertial) as writer:
        for index in range(BUNDLES):
            stamp_ns = CLOCK_START_NS + round(index * 1e8)
            truth = Truth(stamp_ns, SE3(), np.zeros(6), {name: SE3() for name in RIG.cameras})
            frames = Snapshot.taken(truth, images).frames
            writer.write(Snapshot(truth, frames, samples=sensors.until(index / 10)))


@pytest.fixture(scope="module")
def bag(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("inertial") / "drive"
    write(path, InertialConfig(rate_hz=200.0, noise=0.0))
    return path


def test_samples_are_in_the_bag_with_stamps_in_the_middle_of_their_intervals(bag: Path) -> None:
    with Bag(bag) as opened:
        stamps_ns = [message.header_stamp_ns for message in opened.messages(["/imu"])]
        expected_s = (np.arange((BUNDLES - 1) * 20) + 0.5) / 200
        np.testing.assert_allclose(np.array(stamps_ns) - CLOCK_START_NS, expected_s * 1e9, atol=1)
        wheels = [parse(message) for message in opened.messages(["/wheel_speeds"])]
        assert wheels[0].name == ["front_left", "front_right", "rear_left", "rear_right", "steering"]
        assert np.median([each.velocity[2] for each in wheels]) * 0.327 == pytest.approx(5.0, rel=0.02)


def test_the_bias_and_the_place_of_the_unit_are_told(bag: Path) -> None:
    with Bag(bag) as opened:
        measured = [parse(message) for message in opened.messages(["/imu"])]
        biases = [parse(message) for message in opened.messages(["/truth/imu_bias"])]
        (place,) = (parse(message) for message in opened.messages(["/tf_static"]))
    assert len(biases) == BUNDLES - 1
    vertical = np.mean([each.linear_acceleration.z for each in measured[-20:]])
    assert vertical - biases[-1].linear_acceleration.z == pytest.approx(9.81, abs=0.02)
    assert (place.transforms[0].header.frame_id, place.transforms[0].child_frame_id) == ("ego", "imu")
    assert place.transforms[0].transform.translation.x == CarConfig().imu_position_m[0]


def test_who_reads_the_images_notices_nothing(bag: Path, tmp_path: Path) -> None:
    write(tmp_path / "plain", None)
    with Bag(tmp_path / "plain") as plain:
        assert not {"/imu", "/wheel_speeds", "/tf_static", "/truth/imu_bias"} & set(plain.message_types)
    with Recording(bag, RIG) as recording:
        stamps_ns = [bundle.stamp_ns for bundle in recording.bundles()]
        assert stamps_ns == [CLOCK_START_NS + index * 10**8 for index in range(BUNDLES)]
        assert recording.warnings == []
