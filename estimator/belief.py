"""What is known of the extrinsics so far: one Gaussian over all estimated cameras together.

Cameras are correlated, through the scale and through each other, so the covariance is kept whole. Its size
does not grow with the drive.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from estimator.rig import Rig
from estimator.se3 import Array

_LEAST_SIGMA = np.array([0.005] * 3 + [0.009] * 3)  # rad, m
_GREATEST_SIGMA = np.array([np.pi] * 3 + [100.0] * 3)


@dataclass(frozen=True, eq=False)
class Belief:
    """A Gaussian over the extrinsics of the C estimated cameras.

    Attributes:
        rig: The mean.
        covariance: (6 C, 6 C) of the right perturbations, cameras in the order of ``rig.estimated_names``.
        ahead_s: By camera, how far clocks are ahead; those that are not named are right.
    """

    rig: Rig
    covariance: Array
    ahead_s: Mapping[str, float] = field(default_factory=dict)

    @staticmethod
    def nominal(rig: Rig) -> Belief:
        """Return what the rig file says: its poses and, for each camera alike, its prior.

        No rig file is taken to be better than half a degree and 15 mm: one that claims so and is wrong keeps
        the search too narrow to find out. Nor is one worse than all directions and a hundred metres.
        """
        variance = np.clip(np.diag(rig.prior.covariance), _LEAST_SIGMA**2, _GREATEST_SIGMA**2)
        return Belief(rig, np.asarray(np.kron(np.eye(len(rig.estimated_names)), np.diag(variance)), float))

    def camera_covariance(self, name: str) -> Array:
        """Return the (6, 6) covariance of one camera; zero for the reference."""
        if name == self.rig.reference:
            return np.zeros((6, 6))
        block = self._block(name)
        return self.covariance[block, block]

    def _block(self, name: str) -> slice:
        first = 6 * self.rig.estimated_names.index(name)
        return slice(first, first + 6)

    def rotation_sigma_rad(self, name: str) -> float:
        """Return the root of the summed rotation variances of one camera."""
        return float(np.sqrt(np.trace(self.camera_covariance(name)[:3, :3])))

    def known_within(self, rotation_rad: float) -> frozenset[str]:
        """Return the cameras whose rotation is known that well; the reference is always among them."""
        return frozenset(n for n in self.rig.cameras if self.rotation_sigma_rad(n) <= rotation_rad)

    def translation_sigma_m(self, name: str) -> float:
        """Return the root of the summed translation variances of one camera."""
        return float(np.sqrt(np.trace(self.camera_covariance(name)[3:, 3:])))

    def with_scale_sigma(self, scale_sigma: float) -> Belief:
        """Return the belief with an error of scale added that all windows of a drive share.

        The road fixes the scale under the stated height of the reference camera; ride height and load shift
        it the same way in every window, so it does not average out. An error of scale moves every camera
        along the line from the reference camera to it.
        """
        direction = self._along_scale()
        return self.widened(scale_sigma**2 * np.outer(direction, direction))

    def widened(self, by: Array) -> Belief:
        """Return the belief with a (6 C, 6 C) covariance added."""
        return replace(self, covariance=self.covariance + by)

    def forgetting(self, names: Collection[str], camera_covariance: Array) -> Belief:
        """Return the belief with next to nothing known of some cameras but where they were.

        Args:
            names: Those cameras.
            camera_covariance: (6, 6) of each of them from now on, independent of all others.
        """
        covariance = self.covariance.copy()
        for name in names:
            block = self._block(name)
            covariance[block], covariance[:, block] = 0.0, 0.0
            covariance[block, block] = camera_covariance
        return replace(self, covariance=covariance)

    def with_cameras_of(self, other: Belief, names: Collection[str]) -> Belief:
        """Return the belief with some cameras as another one knows them, independent of all others."""
        poses = {name: other.rig[name].ego_from_cam for name in names}
        result = replace(self, rig=self.rig.with_extrinsics(poses))
        for name in names:
            result = result.forgetting((name,), other.camera_covariance(name))
        return result

    def scale_sigma(self) -> float:
        """Return how far, relatively, the rig may grow or shrink as a whole before the belief objects."""
        direction = self._along_scale()
        information = (
            float(direction @ np.linalg.solve(self.covariance, direction)) if len(direction) else 0.0
        )
        return float(1 / np.sqrt(information)) if information > 0 else np.inf

    def _along_scale(self) -> Array:
        """Return the (6 C,) perturbation that makes the rig larger about its reference, for a factor of e."""
        origin = self.rig[self.rig.reference].ego_from_cam.translation
        direction = np.zeros(len(self.covariance))
        for block, name in enumerate(self.rig.estimated_names):
            pose = self.rig[name].ego_from_cam
            direction[6 * block + 3 : 6 * block + 6] = pose.rotation.T @ (pose.translation - origin)
        return direction
