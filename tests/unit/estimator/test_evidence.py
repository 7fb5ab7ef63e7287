"""Sums of windows, and what they say once a prior is added."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.clocks import Clocks
from estimator.corrections import clocks_at, rig_at
from estimator.evidence import Evidence, Free, UsualErrors, differences
from estimator.scene import Scene
from estimator.se3 import SE3, Array
from estimator.unknowns import Unknowns
from estimator.window_information import WindowInformation
from tests.mounts import left_side_rig

RIG = left_side_rig()
UNKNOWNS = Unknowns(RIG)
SIZE = UNKNOWNS.size
SCENE = Scene(RIG, (SE3(),), np.zeros((0, 3)), clocks=Clocks((0,), (0.0, 0.0, 0.0)))
NOTHING = Evidence.none(RIG)


def window(minimum: Array, seed: int = 0, landmarks: int = 4000) -> WindowInformation:
    """Return a window that says the unknowns are at a minimum, each to a unit over root ``landmarks``."""
    scores = np.random.default_rng(seed).standard_normal((landmarks, SIZE)) * 1e4
    hessian = landmarks * 1e8 * np.eye(SIZE)
    return WindowInformation(hessian, -hessian @ minimum, scores)


def test_a_vector_of_unknowns_survives_the_way_to_a_scene_and_back() -> None:
    values = np.random.default_rng(1).uniform(0.001, 0.01, SIZE)
    scene = replace(SCENE, rig=rig_at(RIG, values), clocks=Clocks((0,), clocks_at(RIG, values)))
    np.testing.assert_allclose(differences(RIG, scene), values, atol=1e-9)


def test_what_two_windows_agree_on_is_believed() -> None:
    minimum = np.full(SIZE, 1e-3)
    minimum[UNKNOWNS.clock(0)] = 0.0
    evidence = NOTHING.with_window(window(minimum), SCENE).with_window(window(minimum, 1), SCENE)
    posterior = evidence.posterior(UsualErrors())
    np.testing.assert_allclose(posterior.mean, minimum, atol=1e-5)
    assert posterior.disagreement < 0.1


def test_windows_that_disagree_are_noticed() -> None:
    apart = [window(np.full(SIZE, sign * 1e-3), seed) for seed, sign in enumerate((-1, 1))]
    evidence = NOTHING.with_window(apart[0], SCENE).with_window(apart[1], SCENE)
    assert evidence.posterior(UsualErrors()).disagreement > 100


def test_landmarks_that_scatter_more_than_their_hessian_says_widen_the_covariance() -> None:
    calm = window(np.zeros(SIZE))
    wild = replace(calm, scores=3 * calm.scores)
    sigma = [
        np.sqrt(np.diag(NOTHING.with_window(each, SCENE).posterior(UsualErrors()).covariance)[:12])
        for each in (calm, wild)
    ]
    np.testing.assert_allclose(sigma[1], 3 * sigma[0], rtol=0.01)


def test_what_is_not_in_doubt_stays_as_the_rig_file_says() -> None:
    evidence = NOTHING.with_window(window(np.full(SIZE, 1e-3)), SCENE)
    mean = evidence.posterior(UsualErrors(), Free(frozenset(["front"]), frozenset())).mean
    assert np.abs(mean[UNKNOWNS.lens(0)]).min() > 9e-4
    assert abs(mean[UNKNOWNS.lens(1)][0]) < 1e-5 and abs(mean[UNKNOWNS.clock(2)]) < 1e-4


def test_without_evidence_the_usual_errors_remain() -> None:
    sigma = np.sqrt(np.diag(NOTHING.posterior(UsualErrors(focal_share=0.02)).covariance))
    np.testing.assert_allclose(sigma[UNKNOWNS.lens(1)], [0.02, 3.0, 3.0])


def test_a_forgotten_pose_takes_along_what_hangs_on_it_and_nothing_else() -> None:
    root = np.random.default_rng(3).standard_normal((SIZE, SIZE))
    minimum = np.linspace(-1e-3, 1e-3, SIZE)
    hessian = root @ root.T + np.eye(SIZE)
    whole = NOTHING.with_window(WindowInformation(hessian, -hessian @ minimum, root), SCENE)
    left = whole.forgetting_pose("left_rear")
    gone = UNKNOWNS.extrinsics(2)
    kept = np.delete(np.arange(SIZE), np.r_[gone])
    assert not left.hessian[gone].any() and not left.vector[gone].any() and not left.scatter[gone].any()
    block = np.linalg.inv(np.linalg.inv(hessian)[np.ix_(kept, kept)])  # the marginal information
    np.testing.assert_allclose(left.hessian[np.ix_(kept, kept)], block, atol=1e-8)
    np.testing.assert_allclose(np.linalg.solve(block, left.vector[kept]), minimum[kept], atol=1e-9)
    value = left.depth - 2 * left.vector @ minimum + minimum @ left.hessian @ minimum
    assert abs(value) < 1e-6  # what was lowest is lowest still
