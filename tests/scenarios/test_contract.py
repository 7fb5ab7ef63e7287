"""What every bundled scenario must be: loadable, explained, unique, textured, finite, fit to be estimated."""

import re
from collections.abc import Callable

import cv2
import numpy as np
import pytest

from estimator.online import OnlineEstimator
from scenarios.bundled import bundled_names
from scenarios.digest import recording_digest
from scenarios.load import load_scenario
from scenarios.scenario import Scenario
from scenarios.sweep import load_sweep
from sim.world import Snapshot
from tests.scenarios.first_bundles import BUNDLES, SHRINKING, shrunk

NAMES = bundled_names("scenario")
_MIN_CORNERS = 20  # on a small image; a tenth of what clear ones by day hold
_MIN_CONTRAST = 3.0  # of what is left once noise is smoothed away
_NOISELESS_PX = 2.0
_ONE_SENTENCE = re.compile(r"[A-Z].*[^.]\.", re.DOTALL)

FirstBundles = Callable[[str], list[Snapshot]]


@pytest.mark.parametrize("name", NAMES)
def test_about_is_one_sentence(name: str) -> None:
    about = load_scenario(name).about
    assert _ONE_SENTENCE.fullmatch(about) and ". " not in about and len(about) < 200


def test_no_two_scenarios_are_the_same_drive() -> None:
    digests = {recording_digest(load_scenario(name), 0) for name in NAMES}
    assert len(digests) == len(NAMES)


@pytest.mark.parametrize("name", bundled_names("sweep"))
def test_every_run_of_a_bundled_sweep_loads(name: str) -> None:
    assert all(map(load_scenario, {run.scenario for run in load_sweep(name).runs}))


def test_the_nightly_sweep_runs_every_scenario_that_can_be_judged() -> None:
    runs = {run.scenario for run in load_sweep("nightly").runs}
    too_short, refused = {"quick_look", "dense_truth"}, {"wrong_resolution"}
    assert runs == set(NAMES) - too_short - refused


@pytest.mark.parametrize("name", NAMES)
def test_every_sound_camera_gives_a_textured_image(name: str, bundles_of: FirstBundles) -> None:
    scenario = load_scenario(name)
    snapshots = bundles_of(name)
    assert len(snapshots) == BUNDLES and len(scenario.rig.cameras) == 7
    for snapshot in snapshots:
        for camera in sound_cameras(scenario, snapshot):
            (frame,) = (each for each in snapshot.frames if each.camera == camera)
            assert frame.stamp_ns == frame.arrival_ns == snapshot.truth.stamp_ns
            width, height = scenario.rig[camera].camera.size_px
            assert frame.image.shape == (height // SHRINKING, width // SHRINKING)
            smooth = cv2.GaussianBlur(frame.image, (0, 0), _NOISELESS_PX)
            corners = cv2.goodFeaturesToTrack(smooth, 200, 0.01, 3)
            assert corners is not None and len(corners) >= _MIN_CORNERS, camera
            assert smooth.std() >= _MIN_CONTRAST, camera


@pytest.mark.parametrize("name", NAMES)
def test_the_truth_is_finite_and_as_far_off_as_the_scenario_says(name: str, bundles_of: FirstBundles) -> None:
    scenario = load_scenario(name)
    for snapshot in bundles_of(name):
        truth = snapshot.truth
        assert np.isfinite(truth.world_from_ego.matrix).all() and np.isfinite(truth.velocity_ego).all()
        assert list(truth.ego_from_cams) == list(scenario.rig.cameras)
    check_mounting(scenario, bundles_of(name)[0])


@pytest.mark.parametrize("name", NAMES)
def test_an_estimator_answers_for_every_camera(name: str, bundles_of: FirstBundles) -> None:
    rig = shrunk(load_scenario(name)).rig
    estimator = OnlineEstimator(rig)
    for snapshot in bundles_of(name):
        images = {
            camera: image
            for camera, image in snapshot.bundle.images.items()
            if image.shape[::-1] == rig[camera].camera.size_px  # others are refused by whoever reads them
        }
        answer = estimator.update(type(snapshot.bundle)(snapshot.bundle.stamp_ns, images))
        assert list(answer.cameras) == list(rig.cameras)
    assert list(estimator.close().cameras) == list(rig.cameras)


def sound_cameras(scenario: Scenario, snapshot: Snapshot) -> list[str]:
    """Return the cameras that no fault strikes at this instant."""
    return [
        name for name in scenario.rig.cameras if not any(fault.concerns(name) for fault in snapshot.faults)
    ]


def check_mounting(scenario: Scenario, snapshot: Snapshot) -> None:
    """Before any event the cameras are off by exactly what the scenario states."""
    wanted = scenario.world.miscalibration
    if wanted.model_dump().get("events"):
        return
    for camera in scenario.rig.estimated_names:
        nominal, true = scenario.rig[camera].ego_from_cam, snapshot.truth.ego_from_cams[camera]
        assert np.degrees((nominal.inverse() @ true).angle_rad) == pytest.approx(
            wanted.rotation_deg, abs=1e-3
        )
        length_mm = 1000 * np.linalg.norm(true.translation - nominal.translation)
        assert length_mm == pytest.approx(wanted.translation_mm, abs=1e-2)
