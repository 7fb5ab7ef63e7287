"""Adjustment of a window whose truth is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.belief import Belief
from estimator.factors import GraphConfig
from estimator.graph import Adjusted, adjust
from estimator.loss import Loss
from estimator.observations import Observations
from estimator.rig import Rig, RigPrior
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig, shaken, worst_error

CONFIG = GraphConfig(iterations=60, relative_tolerance=1e-12)
TRUTH = left_side_rig(PINHOLE, BROWN, FISHEYE)
SCENE = known_scene(TRUTH, arc(1.0, 6))
SEEN = sightings(SCENE)
EVERYTHING = np.ones(len(SCENE.points_world), bool)


def vague(rig: Rig) -> Belief:
    """Return a belief that hardly says anything."""
    return Belief.nominal(replace(rig, prior=RigPrior(60.0, 10_000.0)))


def adjusted(start: Rig, seen: Observations = SEEN, **options: bool) -> Adjusted:
    scene = replace(SCENE, rig=start).with_triangulated(seen, EVERYTHING)
    seen = seen.select(np.isfinite(scene.points_world[seen.landmark, 0])).of_enough_views(2)
    return adjust(scene, seen, on_road(SCENE), vague(start), Loss(10.0), CONFIG, **options)


@pytest.mark.parametrize("seed", [0, 1])
def test_three_degrees_and_a_hundred_millimetres_are_undone(seed: int) -> None:
    rotation_deg, translation_mm = worst_error(adjusted(shaken(TRUTH, 3.0, 100.0, seed)).scene.rig, TRUTH)
    assert rotation_deg < 1e-3 and translation_mm < 0.1


def test_the_car_s_path_is_recovered_too() -> None:
    nudge = np.array([0.005, -0.005, 0.01, 0.05, 0.03, 0.02])
    poses = SCENE.world_from_egos
    off = (poses[0], *(pose.retract(nudge) for pose in poses[1:]))
    found = adjust(
        replace(SCENE, world_from_egos=off), SEEN, on_road(SCENE), vague(TRUTH), Loss(10.0), CONFIG
    ).scene
    for pose, true in zip(found.world_from_egos, poses, strict=True):
        np.testing.assert_allclose(true.local(pose), 0, atol=1e-5)


def test_the_reference_is_the_gauge_and_stays() -> None:
    result = adjusted(shaken(TRUTH, 3.0, 100.0), want_covariance=True)
    assert result.scene.rig["front"] == TRUTH["front"]
    assert result.covariance.shape == (12, 12)


def test_fixed_poses_stay() -> None:
    found = adjusted(shaken(TRUTH, 1.0, 30.0), fixed_poses=True).scene
    for pose, true in zip(found.world_from_egos, SCENE.world_from_egos, strict=True):
        np.testing.assert_allclose(true.local(pose), 0, atol=1e-6)


def test_the_road_brings_a_scene_of_wrong_size_to_scale() -> None:
    small = tuple(replace(pose, translation=0.97 * pose.translation) for pose in SCENE.world_from_egos)
    start = replace(SCENE, world_from_egos=small).with_triangulated(SEEN, EVERYTHING)
    seen = SEEN.select(np.isfinite(start.points_world[SEEN.landmark, 0])).of_enough_views(2)
    found = adjust(start, seen, on_road(SCENE), vague(TRUTH), Loss(10.0), CONFIG).scene
    length_m = np.linalg.norm(found.world_from_egos[-1].translation)
    assert abs(length_m / np.linalg.norm(SCENE.world_from_egos[-1].translation) - 1) < 1e-4


def test_a_robust_loss_shrugs_off_wrong_sightings() -> None:
    pixels = SEEN.pixels.copy()
    pixels[::25] += 40.0
    wrong = replace(SEEN, pixels=pixels)
    found = adjust(SCENE, wrong, on_road(SCENE), vague(TRUTH), Loss(0.5), CONFIG).scene
    rotation_deg, translation_mm = worst_error(found.rig, TRUTH)
    assert rotation_deg < 0.01 and translation_mm < 2.0


def test_a_firm_belief_outweighs_a_few_sightings() -> None:
    start = shaken(TRUTH, 0.1, 3.0)
    firm = Belief(start, 1e-14 * np.eye(12))
    found = adjust(replace(SCENE, rig=start), SEEN, on_road(SCENE), firm, Loss(10.0), CONFIG).scene
    rotation_deg, translation_mm = worst_error(found.rig, start)
    assert rotation_deg < 1e-3 and translation_mm < 0.1


def test_what_one_camera_shows_moves_those_that_are_believed_to_move_with_it() -> None:
    spread = np.random.default_rng(0).standard_normal((12, 12)) * 0.01
    covariance = spread @ spread.T + 1e-6 * np.eye(12)
    unseen = SEEN.select(SEEN.camera != 2)
    start = shaken(TRUTH, 1.0, 30.0)
    found = adjust(
        replace(SCENE, rig=start), unseen, on_road(SCENE), Belief(start, covariance), Loss(10.0), CONFIG
    ).scene.rig
    moved = {n: start[n].ego_from_cam.local(found[n].ego_from_cam) for n in TRUTH.estimated_names}
    wanted = covariance[6:, :6] @ np.linalg.solve(covariance[:6, :6], moved["left_front"])
    np.testing.assert_allclose(moved["left_rear"], wanted, rtol=1e-3, atol=1e-6)


def test_the_covariance_is_symmetric_and_positive() -> None:
    covariance = adjusted(TRUTH, want_covariance=True).covariance
    np.testing.assert_allclose(covariance, covariance.T, rtol=1e-6, atol=1e-16)
    assert np.linalg.eigvalsh(covariance).min() > 0


def test_more_sightings_leave_less_doubt() -> None:
    fewer = SEEN.select(SEEN.landmark % 2 == 0)
    doubt_of_all = np.linalg.eigvalsh(adjusted(TRUTH, want_covariance=True).covariance)
    doubt_of_fewer = np.linalg.eigvalsh(adjusted(TRUTH, fewer, want_covariance=True).covariance)
    assert (doubt_of_all < doubt_of_fewer).all()


def test_the_covariance_tells_how_far_noise_moves_the_cameras() -> None:
    distances = []
    for seed in range(6):
        result = adjusted(TRUTH, sightings(SCENE, 0.3, seed), want_covariance=True)
        errors = [
            TRUTH[n].ego_from_cam.local(result.scene.rig[n].ego_from_cam) for n in TRUTH.estimated_names
        ]
        error = np.concatenate(errors)
        distances.append(error @ np.linalg.solve(result.covariance, error))
    assert 5 < np.mean(distances) < 24  # chi-square of 12 degrees of freedom


def test_a_landmark_without_depth_does_not_cost_the_window_its_answer() -> None:
    """Two sightings of which the loss leaves one nothing: GTSAM calls the whole system indeterminate."""
    row = np.flatnonzero(SEEN.landmark == SEEN.landmark[0])
    pixels = SEEN.pixels.copy()
    pixels[row[1]] += 100.0
    seen = replace(SEEN, pixels=pixels).select(np.delete(np.arange(len(SEEN)), row[2:]))
    found = adjust(SCENE, seen, on_road(SCENE), vague(TRUTH), Loss(0.01), CONFIG, want_covariance=True)
    assert np.isfinite(found.covariance).all()
    assert worst_error(found.scene.rig, TRUTH)[0] < 1e-3
