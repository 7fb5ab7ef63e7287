"""Who saw which landmark where: the measurements of one window as parallel arrays."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

from estimator.se3 import Array

Index = npt.NDArray[np.int64]
Mask = npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Observations:
    """N sightings.

    Attributes:
        landmark: (N,) index of the landmark.
        camera: (N,) index into the rig's cameras, in their order.
        keyframe: (N,) index into the window's keyframes.
        pixels: (N, 2) where it was seen.
        sigma_px: (N,) standard deviation of each coordinate.
        handed_over: (N,) whether it was found by looking for another camera's landmark.
    """

    landmark: Index
    camera: Index
    keyframe: Index
    pixels: Array
    sigma_px: Array
    handed_over: Mask

    def __len__(self) -> int:
        return len(self.landmark)

    def select(self, chosen: Mask | Index) -> Observations:
        """Return the chosen sightings."""
        return Observations(*(getattr(self, f.name)[chosen] for f in fields(self)))

    def join(self, other: Observations) -> Observations:
        """Return both, one after the other."""
        return Observations(
            *(np.concatenate([getattr(self, f.name), getattr(other, f.name)]) for f in fields(self))
        )

    def of_enough_views(self, minimum: int) -> Observations:
        """Return those of landmarks that are seen at least ``minimum`` times."""
        if len(self) == 0:
            return self
        return self.select(np.bincount(self.landmark)[self.landmark] >= minimum)
