"""How far to rely on each sighting: by what its patch shows and how well it matches, not by one constant."""

from __future__ import annotations

import numpy as np

from estimator.align import Aligned
from estimator.config import Config
from estimator.loss import Loss
from estimator.ranges import Factor, SigmaPx
from estimator.se3 import Array


class SightingNoise(Config):
    """From how well a patch fits to the standard deviation of where it was seen.

    A blurred, dim or changed patch fits badly or is weak in gradients, and says so itself. Against the truth
    of simulated drives its own sigma is half the error it makes, at all sizes alike (0.02 to 0.13 px against
    0.05 to 0.26); sightings of one landmark, and of one kind of surface, err together, which the rest of
    ``factor`` is for.
    """

    factor: Factor = 8.0
    floor_px: SigmaPx = 0.1
    ceiling_px: SigmaPx = 2.0
    loss_sigmas: Factor = 0.25

    @property
    def loss(self) -> Loss:
        """The loss that a window is adjusted with at last."""
        return Loss(self.loss_sigmas, of_sigma=True)

    def sigma_px(self, measured: Aligned) -> Array:
        """Return (N,) the standard deviations to state of aligned sightings; NaN where not aligned."""
        return np.asarray(np.clip(self.factor * measured.sigma_px, self.floor_px, self.ceiling_px))
