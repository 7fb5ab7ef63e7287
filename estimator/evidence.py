"""What all windows together say of extrinsics, lenses and clocks: sums of quadratics, bounded for ever.

Each window adds its own information about one vector of unknowns, whatever was believed before it. So the
question whether a lens or a clock is to blame is asked of the whole drive at once: while the car drives
straight at constant speed, a late clock and a shifted camera look the same.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from pydantic import Field

from estimator.belief import Belief
from estimator.config import Config
from estimator.ranges import ClockSigmaS, SigmaPx
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.unknowns import Unknowns
from estimator.window_information import WindowInformation

_HELD = 1e-5  # of the usual error, for what counts as right


class UsualErrors(Config):
    """How far lenses and clocks usually are from what the rig file says: one sigma of a weak prior."""

    focal_share: float = Field(0.01, ge=1e-6, le=1)
    center_px: SigmaPx = 3.0
    clock_s: ClockSigmaS = 0.02

    def sigmas(self, unknowns: Unknowns) -> Array:
        """Return the (D,) usual errors; NaN for poses, of which this says nothing."""
        sigma = np.full(unknowns.size, np.nan)
        for camera in range(len(unknowns.names)):
            sigma[unknowns.lens(camera)] = [self.focal_share, self.center_px, self.center_px]
            sigma[unknowns.clock(camera)] = self.clock_s
        return sigma


@dataclass(frozen=True)
class Free:
    """Names of the cameras whose lens, and of those whose clock, is in doubt."""

    lenses: frozenset[str]
    clocks: frozenset[str]


@dataclass(frozen=True, eq=False)
class Posterior:
    """A Gaussian over ``Unknowns``, as differences from the rig file.

    Attributes:
        mean: (D,).
        covariance: (D, D), widened by how far the landmarks really scatter.
        disagreement: How far apart windows are, in squared sigmas each degree of freedom; near 1 if all of
            them see the same rig.
    """

    mean: Array
    covariance: Array
    disagreement: float


@dataclass(frozen=True, eq=False)
class Evidence:
    """Sums over windows, about the rig file.

    Attributes:
        nominal: The rig file: where the unknowns are zero.
        hessian: (D, D).
        vector: (D,): hessian times where the minimum lies.
        scatter: (D, D) sum of outer products of landmarks' scores.
        depth: Sum over windows of the quadratic's value at zero above its own minimum, times two.
        window_count: How many were added.
    """

    nominal: Rig
    hessian: Array
    vector: Array
    scatter: Array
    depth: float = 0.0
    window_count: int = 0

    @staticmethod
    def none(nominal: Rig) -> Evidence:
        """Return what is known before the first window."""
        size = Unknowns(nominal).size
        return Evidence(nominal, np.zeros((size, size)), np.zeros(size), np.zeros((size, size)))

    def with_window(self, found: WindowInformation, scene: Scene) -> Evidence:
        """Add a window that was linearised at a scene's extrinsics, lenses and clocks."""
        at = differences(self.nominal, scene)
        hessian = found.hessian
        vector = hessian @ at - found.gradient
        lowest = np.linalg.lstsq(hessian, vector, rcond=1e-12)[0]
        return replace(
            self,
            hessian=self.hessian + hessian,
            vector=self.vector + vector,
            scatter=self.scatter + found.scores.T @ found.scores,
            depth=self.depth + float(vector @ lowest),
            window_count=self.window_count + 1,
        )

    def forgetting_pose(self, name: str) -> Evidence:
        """Return the evidence without what it says of one camera's extrinsics.

        What that camera showed of its lens, its clock and the others is kept as far as it does not hang on
        where the camera was.
        """
        unknowns = Unknowns(self.nominal)
        gone = np.zeros(unknowns.size, bool)
        gone[unknowns.extrinsics(unknowns.names.index(name))] = True
        left = ~gone
        by = self.hessian[np.ix_(left, gone)] @ np.linalg.pinv(
            self.hessian[np.ix_(gone, gone)], hermitian=True
        )
        into = np.zeros((unknowns.size, unknowns.size))
        into[np.ix_(left, left)] = np.eye(left.sum())
        into[np.ix_(left, gone)] = -by
        return replace(
            self,
            hessian=into @ self.hessian @ into.T,
            vector=into @ self.vector,
            scatter=into @ self.scatter @ into.T,
            depth=self.depth
            - float(self.vector[gone] @ np.linalg.pinv(self.hessian[np.ix_(gone, gone)]) @ self.vector[gone]),
        )

    def posterior(self, usual: UsualErrors, free: Free | None = None) -> Posterior:
        """Weigh the evidence against the rig file's prior and what is usual for lenses and clocks.

        Args:
            usual: How far lenses and clocks may be off.
            free: Those that are in doubt; the others count as right. None: all are.
        """
        prior = prior_information(self.nominal, usual, free)
        noise, size = self._noise(), len(self.vector)
        gain = np.linalg.inv(self.hessian / noise + prior)
        mean = gain @ (self.vector / noise)
        covariance = gain @ (self.scatter / noise**2 + prior) @ gain
        misfit = self.depth - 2 * float(self.vector @ mean) + float(mean @ self.hessian @ mean)
        freedom = max(self.window_count - 1, 1) * size
        return Posterior(mean, covariance, misfit / noise / freedom)

    def information(self, usual: UsualErrors, free: Free | None = None) -> Array:
        """Return the (D, D) information of the evidence and of the prior that ``posterior`` takes."""
        return self.hessian / self._noise() + prior_information(self.nominal, usual, free)

    def _noise(self) -> float:
        """Return the variance of landmarks' scores in units of what the Hessian says."""
        ratio = np.linalg.lstsq(self.hessian, self.scatter, rcond=1e-12)[0]
        return max(float(np.trace(ratio)) / len(self.vector), 1e-12)


def differences(nominal: Rig, scene: Scene) -> Array:
    """Return (D,) how a scene's rig and clocks differ from the rig file and clocks that are right."""
    unknowns = Unknowns(nominal)
    result = np.zeros(unknowns.size)
    for camera, name in enumerate(unknowns.names):
        stated, now = nominal[name], scene.rig[name]
        if name in unknowns.estimated:
            result[unknowns.extrinsics(camera)] = stated.ego_from_cam.local(now.ego_from_cam)
        focal = np.log(now.camera.focal_px[0] / stated.camera.focal_px[0])
        center = np.subtract(now.camera.center_px, stated.camera.center_px)
        result[unknowns.lens(camera)] = [focal, *center]
        result[unknowns.clock(camera)] = scene.clocks.ahead_s[camera] if scene.clocks else 0.0
    return result


def prior_information(nominal: Rig, usual: UsualErrors, free: Free | None = None) -> Array:
    """Return the (D, D) information of the rig file; the reference's clock is right by definition."""
    unknowns = Unknowns(nominal)
    sigma = usual.sigmas(unknowns)
    sigma[: unknowns.pose_size] = np.sqrt(np.diag(Belief.nominal(nominal).covariance))
    for camera, name in enumerate(unknowns.names):
        if free is not None and name not in free.lenses:
            sigma[unknowns.lens(camera)] *= _HELD
        if name == nominal.reference or (free is not None and name not in free.clocks):
            sigma[unknowns.clock(camera)] *= _HELD
    return np.diag(sigma**-2.0)
