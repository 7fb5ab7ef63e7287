"""The car's pose from all cameras: found where they agree, refused where too few do."""

from __future__ import annotations

import numpy as np

from estimator.rig_pose import RigPose, RigPoseConfig, Sight, fit_rig_pose
from estimator.se3 import SE3
from tests.canyon import cast
from tests.mounts import BROWN, FISHEYE, arc, left_side_rig

RIG = left_side_rig(left_front=BROWN, left_rear=FISHEYE)
HERE = arc(0.7, 6)[5]
NEARBY = HERE @ SE3.exp(np.array([0.01, -0.01, 0.05, 0.4, 0.1, 0.0]))


def sights(noise_px: float = 0.3, count: int = 120) -> dict[str, Sight]:
    """Return what every camera sees of the canyon."""
    rng = np.random.default_rng(0)
    result = {}
    for name, mounted in RIG.cameras.items():
        pixels = rng.uniform(5, np.array(mounted.camera.size_px) - 5, (count, 2))
        points = cast(HERE @ mounted.ego_from_cam, mounted.camera.unproject(pixels))[0]
        seen = mounted.camera.unproject(pixels + rng.normal(0, noise_px, pixels.shape))
        known = np.isfinite(points).all(1) & (seen[:, 2] > 0.17)
        result[name] = Sight(seen[known], points[known])
    return result


def fitted(seen: dict[str, Sight], config: RigPoseConfig | None = None) -> RigPose | None:
    return fit_rig_pose(RIG, seen, NEARBY, config or RigPoseConfig())


def moved(sight: Sight) -> Sight:
    return Sight(sight.rays_cam, sight.points_world + np.array([0.0, 0.0, 1.5]))


def test_a_car_is_found_where_its_cameras_say() -> None:
    found = fitted(sights())
    assert found is not None
    error = HERE.local(found.world_from_ego)
    assert np.linalg.norm(error[:3]) < 1e-3 and np.linalg.norm(error[3:]) < 0.01


def test_a_camera_that_sees_another_world_is_outvoted_and_told() -> None:
    seen = sights()
    found = fitted(seen | {"front": moved(seen["front"])})
    assert found is not None
    assert np.linalg.norm(HERE.local(found.world_from_ego)[3:]) < 0.02
    assert found.agrees["front"].mean() < 0.1 and found.agrees["left_rear"].mean() > 0.8


def test_without_the_reference_the_others_know_the_pose() -> None:
    seen = sights()
    del seen["front"]
    found = fitted(seen)
    assert found is not None and np.linalg.norm(HERE.local(found.world_from_ego)[3:]) < 0.02


def test_points_that_agree_on_nothing_give_no_pose() -> None:
    rng = np.random.default_rng(1)
    shuffled = {n: Sight(s.rays_cam, rng.permutation(s.points_world)) for n, s in sights().items()}
    assert fitted(shuffled) is None


def test_few_points_give_no_pose() -> None:
    few = {name: Sight(s.rays_cam[:5], s.points_world[:5]) for name, s in sights().items()}
    assert fitted(few) is None
    assert fitted({}) is None


def test_the_same_sights_give_the_same_bits() -> None:
    first, second = fitted(sights()), fitted(sights())
    assert first is not None and second is not None
    assert first.world_from_ego.matrix.tobytes() == second.world_from_ego.matrix.tobytes()
