"""Each fault does to a frame what its name says, and nothing else."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter

from sim.faults.chain import FaultChain
from sim.faults.kinds import WAY, AnyFault
from sim.frame import Frame

CAMERAS = ("front", "left", "rear")
MS = 1_000_000
_PARSE: TypeAdapter[Any] = TypeAdapter(AnyFault)


def frames_at(index: int) -> tuple[Frame, ...]:
    rng = np.random.default_rng(index)
    stamp_ns = 10**9 + index * 100 * MS
    return tuple(
        Frame(name, stamp_ns, stamp_ns, rng.integers(1, 255, (20, 32), np.uint8)) for name in CAMERAS
    )


def drive(*faults: dict[str, Any], count: int = 40, seed: int = 0) -> list[tuple[Frame, ...]]:
    """Pass a drive of ten bundles a second through faults."""
    chain = FaultChain([_PARSE.validate_python(fault) for fault in faults], CAMERAS, seed)
    return [chain.pass_on(frames_at(index), index, index / 10) for index in range(count)]


def of(camera: str, bundle: tuple[Frame, ...]) -> list[Frame]:
    return [frame for frame in bundle if frame.camera == camera]


def same(first: Frame, second: Frame) -> bool:
    stamps = (first.camera, first.stamp_ns, first.arrival_ns)
    return stamps == (second.camera, second.stamp_ns, second.arrival_ns) and np.array_equal(
        first.image, second.image
    )


def test_without_faults_frames_pass_as_they_are() -> None:
    for index, bundle in enumerate(drive()):
        assert all(map(same, bundle, frames_at(index)))


@pytest.mark.parametrize("kind", sorted(set(WAY), key=lambda each: each.__name__))
def test_a_fault_leaves_other_cameras_and_other_times_alone(kind: type) -> None:
    name = kind.model_fields["kind"].annotation.__args__[0]  # type: ignore[attr-defined]
    cameras = ["rear", "left"] if name == "swapped" else "rear"
    window = {} if name == "wrong_intrinsics" else {"at_s": 1.0, "duration_s": 1.0}
    for index, bundle in enumerate(drive({"kind": name, "camera": cameras} | window)):
        sound = frames_at(index)
        assert same(of("front", bundle)[0], sound[0])
        if not 10 <= index < 20:
            assert len(bundle) == 3 and all(map(same, bundle, sound))


def test_dropped_frames_are_as_many_as_said() -> None:
    bundles = drive({"kind": "dropped", "camera": "all", "probability": 0.25}, count=400)
    assert sum(map(len, bundles)) == pytest.approx(0.75 * 1200, rel=0.06)


def test_a_camera_that_is_off_sends_nothing() -> None:
    bundles = drive({"kind": "off", "camera": ["left", "rear"], "at_s": 1.0})
    assert [len(bundle) for bundle in bundles] == [3] * 10 + [1] * 30


def test_a_late_frame_arrives_later_with_its_own_stamp() -> None:
    bundles = drive({"kind": "late", "camera": "rear", "probability": 0.5, "delay_ms": 250})
    delays_ms = [(frame.arrival_ns - frame.stamp_ns) / MS for bundle in bundles for frame in bundle]
    assert set(delays_ms) == {0.0, 250.0}
    assert all(
        frame.stamp_ns == frames_at(index)[0].stamp_ns for index, b in enumerate(bundles) for frame in b
    )


def test_a_duplicated_frame_comes_twice_with_one_stamp() -> None:
    bundles = drive({"kind": "duplicated", "camera": "rear", "probability": 1.0})
    for bundle in bundles:
        first, second = of("rear", bundle)
        assert same(replace(second, arrival_ns=first.arrival_ns), first)
        assert second.arrival_ns > first.arrival_ns


def test_a_frozen_camera_repeats_its_last_sound_image_with_new_stamps() -> None:
    bundles = drive({"kind": "frozen", "camera": "rear", "at_s": 1.0})
    for index, bundle in enumerate(bundles):
        (frame,) = of("rear", bundle)
        assert np.array_equal(frame.image, frames_at(min(index, 9))[2].image)
        assert frame.stamp_ns == frames_at(index)[2].stamp_ns


def test_black_is_black_and_overexposed_clips() -> None:
    (bundle,) = drive({"kind": "black", "camera": "rear"}, count=1)
    assert not of("rear", bundle)[0].image.any()
    (bundle,) = drive({"kind": "overexposed", "camera": "rear", "gain": 4.0}, count=1)
    sound = frames_at(0)[2].image.astype(int)
    assert np.array_equal(of("rear", bundle)[0].image, np.minimum(4 * sound, 255))


def test_an_image_of_wrong_resolution_shows_the_same_field() -> None:
    (bundle,) = drive({"kind": "wrong_resolution", "camera": "rear", "size_px": [16, 10]}, count=1)
    image = of("rear", bundle)[0].image
    assert image.shape == (10, 16)
    assert image.mean() == pytest.approx(frames_at(0)[2].image.mean(), abs=1.0)


def test_jitter_has_its_sigma_and_bounds() -> None:
    bundles = drive({"kind": "jitter", "camera": "all", "sigma_ms": 5}, count=400)
    off_ms = np.array([(frame.stamp_ns - frame.arrival_ns) / MS for b in bundles for frame in b])
    assert off_ms.std() == pytest.approx(5, rel=0.1) and np.abs(off_ms).max() <= 15
    assert abs(off_ms.mean()) < 0.6


def test_swapped_cables_exchange_images_and_nothing_else() -> None:
    for index, bundle in enumerate(drive({"kind": "swapped", "camera": ["left", "rear"]})):
        _, left, rear = frames_at(index)
        assert same(of("left", bundle)[0], replace(rear, camera="left"))
        assert same(of("rear", bundle)[0], replace(left, camera="rear"))
