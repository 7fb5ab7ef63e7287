"""The window in numpy says the same as the window in GTSAM."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.clocks import Clocks
from estimator.factors import GraphConfig
from estimator.graph import adjust
from estimator.loss import Loss
from estimator.rows import NO_LANDMARK, Rows
from estimator.window_information import WindowInformation, window_information
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig

RIG = left_side_rig(PINHOLE, BROWN, FISHEYE)
SCENE = replace(known_scene(RIG, arc(1.0, 6)), clocks=Clocks(tuple(10**8 * k for k in range(6)), (0.0,) * 3))
SEEN = sightings(SCENE, 0.3)
LOSS = Loss(0.5)
CONFIG = GraphConfig(iterations=60, relative_tolerance=1e-12)
BELIEF = Belief.nominal(RIG)
ADJUSTED = adjust(SCENE, SEEN, on_road(SCENE), BELIEF, LOSS, CONFIG, want_covariance=True)
POSES = slice(0, 12)


def look(*, curved: bool = False) -> WindowInformation:
    return window_information(ADJUSTED.scene, SEEN, on_road(SCENE), LOSS, CONFIG, curved=curved)


def test_with_lenses_and_clocks_held_the_posterior_is_that_of_the_graph() -> None:
    total = look().hessian[POSES, POSES] + np.linalg.inv(BELIEF.covariance)
    np.testing.assert_allclose(np.diag(np.linalg.inv(total)), np.diag(ADJUSTED.covariance), rtol=0.015)


def test_at_the_adjusted_values_evidence_and_belief_pull_equally() -> None:
    inverse = np.linalg.inv(BELIEF.covariance)
    off = [RIG[n].ego_from_cam.local(ADJUSTED.scene.rig[n].ego_from_cam) for n in RIG.estimated_names]
    pull = look().gradient[POSES] + inverse @ np.concatenate(off)
    step = ADJUSTED.covariance @ pull
    assert (np.abs(step) < 0.1 * np.sqrt(np.diag(ADJUSTED.covariance))).all()


def test_the_landmarks_parts_sum_to_the_gradient() -> None:
    found = look()
    scale = np.abs(found.scores).sum(0)
    np.testing.assert_allclose(found.scores.sum(0) / scale, found.gradient / scale, atol=0.02)


def test_the_curvature_of_the_loss_says_less_than_the_solver_s_hessian() -> None:
    difference = look().hessian[POSES, POSES] - look(curved=True).hessian[POSES, POSES]
    assert np.linalg.eigvalsh(difference).min() > 0


def test_eliminating_landmarks_leaves_what_a_dense_solution_says() -> None:
    rng = np.random.default_rng(0)
    landmark = np.repeat([4, 7, NO_LANDMARK], 6)
    point = rng.standard_normal((18, 3)) * (landmark != NO_LANDMARK)[:, None]
    rows = Rows(landmark, rng.standard_normal((18, 2)), point, rng.standard_normal(18))
    hessian, gradient, scores = rows.without_landmarks()
    places = [point * (landmark == each)[:, None] for each in (4, 7)]
    dense = np.hstack([rows.rest, *places])
    solution = np.linalg.lstsq(dense, -rows.error)[0][:2]
    np.testing.assert_allclose(np.linalg.solve(hessian, -gradient), solution, atol=1e-9)
    assert scores.shape == (2, 2)
