"""Estimators that do as little as they can, well or badly, to test the judge without the product."""

from __future__ import annotations

import os
import time

import numpy as np

from estimator.bundle import FrameBundle
from estimator.estimate import CameraEstimate, Estimate, Status
from estimator.rig import Rig
from estimator.se3 import SE3


class Nominal:
    """Believes the nominal rig, as unsure as its prior."""

    def __init__(self, rig: Rig) -> None:
        self.rig = rig
        self.stamps_ns: list[int] = []

    def update(self, bundle: FrameBundle) -> Estimate:
        self.stamps_ns.append(bundle.stamp_ns)
        return self.close()

    def close(self) -> Estimate:
        covariances = dict.fromkeys(self.rig.estimated_names, self.rig.prior.covariance)
        cameras = {
            name: CameraEstimate(
                mounted.ego_from_cam, covariances.get(name, np.zeros((6, 6))), Status.INITIALISING
            )
            for name, mounted in self.rig.cameras.items()
        }
        driven_m = 0.5 * (len(self.stamps_ns) - 1)
        return Estimate(self.stamps_ns[-1], cameras, SE3(np.eye(3), np.array([driven_m, 0.0, 0.0])))


class Raises(Nominal):
    """Fails at the second bundle."""

    def update(self, bundle: FrameBundle) -> Estimate:
        if self.stamps_ns:
            raise RuntimeError("a planted\nfault")
        return super().update(bundle)


class AnswersNonsense(Nominal):
    """Answers with something that is no estimate."""

    def update(self, bundle: FrameBundle) -> Estimate:
        return None  # type: ignore[return-value]


class ForgetsACamera(Nominal):
    """Leaves the last camera out."""

    def close(self) -> Estimate:
        whole = super().close()
        return Estimate(whole.stamp_ns, dict(list(whole.cameras.items())[:-1]))


class Sleeps(Nominal):
    """Takes long enough to be interrupted."""

    def update(self, bundle: FrameBundle) -> Estimate:
        time.sleep(30 if self.stamps_ns else 0)
        return super().update(bundle)


class Dies(Nominal):
    """Takes its process down without a word."""

    def update(self, bundle: FrameBundle) -> Estimate:
        os._exit(9)
