"""Linear rows of a least-squares problem in which each row concerns at most one landmark."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from estimator.observations import Index, Mask
from estimator.se3 import Array

NO_LANDMARK = -1


@dataclass(frozen=True, eq=False)
class Rows:
    """R rows, each ``(rest @ x + point @ landmark + error)^2`` in squared sigmas.

    Attributes:
        landmark: (R,) the landmark concerned, or ``NO_LANDMARK``.
        rest: (R, W) derivatives by all that is no landmark.
        point: (R, 3) derivatives by the landmark.
        error: (R,) at the present values.
    """

    landmark: Index
    rest: Array
    point: Array
    error: Array

    def select(self, chosen: Mask | Index) -> Rows:
        """Return the chosen rows."""
        return Rows(*(getattr(self, f.name)[chosen] for f in fields(self)))

    @staticmethod
    def stacked(parts: Sequence[Rows]) -> Rows:
        """Return all rows, one part after the other; a narrower part depends on no more than its columns."""
        width = max(part.rest.shape[1] for part in parts)
        rest = np.vstack([np.pad(part.rest, ((0, 0), (0, width - part.rest.shape[1]))) for part in parts])
        landmark, point, error = (
            np.concatenate([getattr(part, name) for part in parts]) for name in ("landmark", "point", "error")
        )
        return Rows(landmark, rest, point, error)

    def without_landmarks(self) -> tuple[Array, Array, Array]:
        """Eliminate every landmark by itself, which must have a Hessian of full rank.

        Returns:
            The (W, W) Hessian of the rest, its (W,) gradient, and each landmark's (L, W) part of it.
        """
        free = self.select(self.landmark == NO_LANDMARK)
        tied = self.select(self.landmark != NO_LANDMARK)
        tied = tied.select(np.argsort(tied.landmark, kind="stable"))
        start = np.unique(tied.landmark, return_index=True)[1]
        hessian = np.add.reduceat(tied.point[:, :, None] * tied.point[:, None, :], start)
        pull = np.add.reduceat(tied.point * tied.error[:, None], start)
        cross = np.add.reduceat(tied.point[:, :, None] * tied.rest[:, None, :], start)
        own = np.add.reduceat(tied.rest * tied.error[:, None], start)
        gain = np.linalg.solve(hessian, cross)  # (L, 3, W)
        width = self.rest.shape[1]
        eliminated = cross.reshape(-1, width).T @ gain.reshape(-1, width)
        scores = own - np.einsum("lid,li->ld", gain, pull)
        gradient = scores.sum(0) + free.rest.T @ free.error
        return self.rest.T @ self.rest - eliminated, gradient, scores
