"""What every bundled scenario must be: loadable, explained, unique, textured, finite, repeatable."""

from collections.abc import Sequence
from contextlib import closing
from functools import cache
from itertools import islice

import cv2
import numpy as np
import pytest

from scenarios.bundled import bundled_names
from scenarios.digest import recording_digest
from scenarios.load import load_scenario
from scenarios.scenario import Scenario
from scenarios.sweep import load_sweep
from sim.simulate import simulate
from sim.world import Snapshot

NAMES = bundled_names("scenario")
_BUNDLES = 2
_MIN_CORNERS = 60  # a hundredth of what real driving images of this size hold


def take(name: str) -> list[Snapshot]:
    """Simulate the first bundles of a scenario; building its street is most of the time."""
    scenario = load_scenario(name)
    with closing(simulate(scenario.world, scenario.rig, 0)) as snapshots:
        return list(islice(snapshots, _BUNDLES))


take_once = cache(take)


@pytest.mark.parametrize("name", NAMES)
def test_about_is_one_sentence(name: str) -> None:
    about = load_scenario(name).about
    assert about.endswith(".") and about[0].isupper() and ". " not in about


def test_no_two_scenarios_are_the_same_drive() -> None:
    digests = {recording_digest(load_scenario(name), 0) for name in NAMES}
    assert len(digests) == len(NAMES)


@pytest.mark.parametrize("name", bundled_names("sweep"))
def test_every_run_of_a_bundled_sweep_loads(name: str) -> None:
    assert all(load_scenario(run.scenario) for run in load_sweep(name).runs)


@pytest.mark.parametrize("name", NAMES)
def test_a_scenario_gives_textured_images_and_finite_truth(name: str) -> None:
    scenario = load_scenario(name)
    snapshots = take_once(name)
    assert len(snapshots) == _BUNDLES
    for snapshot in snapshots:
        assert list(snapshot.bundle.images) == list(scenario.rig.cameras)
        assert len(snapshot.bundle.images) == 7
        for camera, image in snapshot.bundle.images.items():
            assert image.shape[::-1] == scenario.rig[camera].camera.size_px
            corners = cv2.goodFeaturesToTrack(image, 500, 0.01, 5)
            assert corners is not None and len(corners) >= _MIN_CORNERS, camera
    _check_truth(scenario, snapshots)


def _check_truth(scenario: Scenario, snapshots: Sequence[Snapshot]) -> None:
    wanted = scenario.world.miscalibration
    for snapshot in snapshots:
        truth = snapshot.truth
        assert truth.stamp_ns == snapshot.bundle.stamp_ns
        assert np.isfinite(truth.world_from_ego.matrix).all() and np.isfinite(truth.velocity_ego).all()
        for camera in scenario.rig.estimated_names:
            nominal, true = scenario.rig[camera].ego_from_cam, truth.ego_from_cams[camera]
            assert np.degrees((nominal.inverse() @ true).angle_rad) == pytest.approx(
                wanted.rotation_deg, abs=1e-3
            )
            length_mm = 1000 * np.linalg.norm(true.translation - nominal.translation)
            assert length_mm == pytest.approx(wanted.translation_mm, abs=1e-2)


def test_the_same_seed_gives_the_same_bytes() -> None:
    for first, again in zip(take_once("quick_look"), take("quick_look"), strict=True):
        assert list(first.bundle.images) == list(again.bundle.images)
        for camera, image in first.bundle.images.items():
            assert image.tobytes() == again.bundle.images[camera].tobytes()
