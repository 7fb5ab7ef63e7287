"""A short drive through the canyon with a rig whose file is wrong: no renderer, exact truth."""

from __future__ import annotations

from collections.abc import Iterable

from estimator.bundle import FrameBundle
from estimator.estimate import Estimate
from estimator.lens_config import LensConfig
from estimator.online_config import OnlineConfig
from estimator.rig import Rig
from tests.canyon import render
from tests.mounts import arc, left_side_rig, shaken

TRUTH = left_side_rig()
NOMINAL = shaken(TRUTH, 2.0, 60.0)
PATH = arc(0.7, 20)
PERIOD_NS = 100_000_000
# The car keeps its speed and its bend all the way, so the drive cannot show clocks.
IN_STEP = OnlineConfig(lens=LensConfig(clocks_in_step=True))


def canyon_bundles() -> list[FrameBundle]:
    """Return what the true rig sees along the path."""
    return [
        FrameBundle(
            index * PERIOD_NS, {n: render(m.camera, pose @ m.ego_from_cam) for n, m in TRUTH.cameras.items()}
        )
        for index, pose in enumerate(PATH)
    ]


def rig_of(estimate: Estimate) -> Rig:
    """Return the rig as an answer has it."""
    return NOMINAL.with_extrinsics({name: c.ego_from_cam for name, c in estimate.cameras.items()})


def as_bytes(answers: Iterable[Estimate]) -> bytes:
    """Return all poses and covariances to the bit."""
    parts = []
    for answer in answers:
        for camera in answer.cameras.values():
            parts += [camera.ego_from_cam.matrix.tobytes(), camera.covariance.tobytes()]
    return b"".join(parts)
