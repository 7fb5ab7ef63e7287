"""What must not matter to an adjustment: where the ego frame is, and in which order the cameras stand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from estimator.belief import Belief
from estimator.factors import GraphConfig
from estimator.graph import Adjusted, adjust
from estimator.loss import Loss
from estimator.observations import Observations
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.se3 import SE3
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig, shaken

CONFIG = GraphConfig(iterations=60, relative_tolerance=1e-12)
TRUTH = left_side_rig(PINHOLE, BROWN, FISHEYE)
SCENE = known_scene(TRUTH, arc(1.0, 4))
SEEN = sightings(SCENE, noise_px=0.3)
START = replace(SCENE, rig=shaken(TRUTH, 1.0, 30.0))
COVARIANCE = Belief.nominal(TRUTH).covariance


def adjusted(scene: Scene, seen: Observations, covariance: np.ndarray, *, fixed_poses: bool) -> Adjusted:
    belief = Belief(scene.rig, covariance)
    return adjust(
        scene, seen, on_road(SCENE), belief, Loss(2.0), CONFIG, fixed_poses=fixed_poses, want_covariance=True
    )


def assert_same_cameras(found: Rig, wanted: Rig, atol: float) -> None:
    for name in wanted.cameras:
        a, b = found[name].ego_from_cam, wanted[name].ego_from_cam
        np.testing.assert_allclose(a.matrix, b.matrix, atol=atol, err_msg=name)


ALONG_FIXED_PATH = adjusted(START, SEEN, COVARIANCE, fixed_poses=True)
TOGETHER = adjusted(START, SEEN, COVARIANCE, fixed_poses=False)


@settings(max_examples=8)
@given(st.lists(st.floats(-1, 1), min_size=6, max_size=6))
def test_the_extrinsics_move_with_the_ego_frame(tangent: list[float]) -> None:
    new_from_old = SE3.exp(np.array(tangent) * [3, 3, 3, 5, 5, 5])
    rig = START.rig
    moved = rig.with_extrinsics({n: new_from_old @ rig[n].ego_from_cam for n in rig.cameras})
    poses = tuple(pose @ new_from_old.inverse() for pose in START.world_from_egos)
    found = adjusted(replace(START, rig=moved, world_from_egos=poses), SEEN, COVARIANCE, fixed_poses=True)
    wanted = ALONG_FIXED_PATH.scene.rig
    wanted = wanted.with_extrinsics({n: new_from_old @ wanted[n].ego_from_cam for n in wanted.cameras})
    assert_same_cameras(found.scene.rig, wanted, 1e-5)
    np.testing.assert_allclose(found.covariance, ALONG_FIXED_PATH.covariance, rtol=1e-3, atol=1e-10)


@settings(max_examples=6)
@given(st.permutations(range(3)))
def test_the_order_of_the_cameras_does_not_matter(order: list[int]) -> None:
    names = list(START.rig.cameras)
    rig = replace(START.rig, cameras={names[index]: START.rig[names[index]] for index in order})
    seen = replace(SEEN, camera=np.argsort(order)[SEEN.camera])
    found = adjusted(replace(START, rig=rig), seen, COVARIANCE, fixed_poses=False)
    assert_same_cameras(found.scene.rig, TOGETHER.scene.rig, 1e-6)
    for name in names:
        np.testing.assert_allclose(
            Belief(rig, found.covariance).camera_covariance(name),
            Belief(START.rig, TOGETHER.covariance).camera_covariance(name),
            rtol=1e-4,
            atol=1e-12,
        )


@settings(max_examples=5)
@given(st.integers(0, 2**32 - 1))
def test_the_order_of_the_sightings_does_not_matter(seed: int) -> None:
    shuffled = SEEN.select(np.random.default_rng(seed).permutation(len(SEEN)))
    found = adjusted(START, shuffled, COVARIANCE, fixed_poses=False)
    assert_same_cameras(found.scene.rig, TOGETHER.scene.rig, 1e-6)
