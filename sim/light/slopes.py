"""How 1/depth grows around the samples of a picture: constant on planes, so it gives their normals."""

from __future__ import annotations

import cv2
import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float32]
_STEEP, _OUTSIDE = 0.3, 1e6  # what a step costs against a bend; a neighbour that the picture has not


def slopes_at(nearness: Floats, step: int) -> Floats:
    """Return (2, h, w) how the nearness grows by a pixel to the right and down, every ``step`` pixels.

    Of the four corners that a pixel makes with a neighbour beside it and one above or below, that counts
    whose fourth pixel lies on the same plane, so that the two slopes are of one surface; and of several, the
    flattest one, since the others may reach over an edge.
    """
    height, width = nearness.shape
    (rows, columns), around = nearness[::step, ::step].shape, _neighbours(nearness, step)
    here = around[1][1]
    best = np.full((rows, columns), np.inf, np.float32)
    slopes = np.zeros((2, rows, columns), np.float32)
    besides = {right: around[1][1 + right] - here for right in (1, -1)}
    for down in (1, -1):
        across = around[1 + down][1] - here
        for right, beside in besides.items():
            cost = cv2.absdiff(around[1 + down][1 + right] - here, beside + across)
            cost += np.float32(_STEEP) * (np.abs(beside) + np.abs(across))
            cost[:, _off(columns, width, step, right)] = cost[_off(rows, height, step, down)] = _OUTSIDE
            better = cost < best
            np.copyto(best, cost, where=better)
            np.copyto(slopes[0], right * beside, where=better)
            np.copyto(slopes[1], down * across, where=better)
    return slopes


def _neighbours(nearness: Floats, step: int) -> list[list[Floats]]:
    """Return the 3 x 3 of (h, w) values above to below, left to right of the samples, repeated at borders."""
    rows, columns = nearness[::step, ::step].shape
    padded = cv2.copyMakeBorder(nearness, 1, 1, 1, 1, cv2.BORDER_REPLICATE)
    return [
        [np.ascontiguousarray(padded[v::step, u::step][:rows, :columns]) for u in range(3)] for v in range(3)
    ]


def _off(count: int, length: int, step: int, ahead: int) -> slice:
    """Return which samples have no neighbour on that side."""
    if ahead < 0:
        return slice(0, 1)
    return slice(count - 1, count) if step * (count - 1) == length - 1 else slice(0, 0)
