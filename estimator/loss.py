"""How much say a sighting keeps as its residual grows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array


@dataclass(frozen=True)
class Loss:
    """A Cauchy loss: residuals well above the scale lose their say.

    Attributes:
        scale: In pixels, or in standard deviations of each sighting.
        of_sigma: Which of the two.
    """

    scale: float
    of_sigma: bool = False

    def in_sigmas(self, sigma_px: float) -> float:
        """Return the scale for a sighting of this standard deviation."""
        return self.scale if self.of_sigma else self.scale / sigma_px

    def weights(self, residuals_px: Array, sigmas_px: Array) -> Array:
        """Return (N,) what is left of the say of sightings with these residuals, 1 for those that fit."""
        scale_px = self.scale * sigmas_px if self.of_sigma else self.scale
        return np.asarray(1 / (1 + (residuals_px / scale_px) ** 2))
