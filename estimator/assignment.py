"""Find which streams of images are plugged into the wrong socket, from how well each fits each mount."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.optimize import linear_sum_assignment

from estimator.config import Config
from estimator.ranges import PositiveCount, Share
from estimator.whose_images import Fit


class AssignmentConfig(Config):
    """How much better a stream must fit another mount than its own, and how many tracks must say so."""

    min_tracks: PositiveCount = 30
    min_share: Share = 0.6
    min_gain: Share = 0.4
    loyalty: Share = 0.1  # of a stream to its own mount: among mounts that look the same way, it stays


def swapped_cycles(fit: Fit, config: AssignmentConfig) -> list[tuple[int, ...]]:
    """Return the cycles of streams that fit each other's mounts: each the mount of the next.

    A cycle counts only if every stream in it fits its new mount well and its own badly.
    """
    share = fit.share
    _, mount_of = linear_sum_assignment(-(share + config.loyalty * np.eye(len(share))))
    return [cycle for cycle in _cycles(mount_of.tolist()) if _is_clear(fit, cycle, config)]


def swap_explains(fit: Fit, own: Fit, swap: tuple[int, int], config: AssignmentConfig) -> bool:
    """Tell whether two swapped streams explain all streams, and together much more than none swapped.

    Args:
        fit: Along the path that follows from the swap.
        own: Along the path that follows from no swap.
        swap: The two streams.
        config: Limits.
    """
    mount_of = np.arange(len(fit.share))
    mount_of[list(swap)] = swap[::-1]
    better = fit.share[np.arange(len(mount_of)), mount_of]
    gain = better.mean() - own.share.diagonal().mean()
    return bool(better.min() > config.min_share and gain > 0.5 * config.min_gain)


def _cycles(mount_of: list[int]) -> Iterator[tuple[int, ...]]:
    """Yield the cycles of a permutation that are longer than one."""
    left = set(range(len(mount_of)))
    while left:
        cycle = [min(left)]
        while mount_of[cycle[-1]] != cycle[0]:
            cycle.append(mount_of[cycle[-1]])
        left -= set(cycle)
        if len(cycle) > 1:
            yield tuple(cycle)


def _is_clear(fit: Fit, cycle: tuple[int, ...], config: AssignmentConfig) -> bool:
    own = np.array(cycle)
    new = np.roll(own, -1)
    better, before = fit.share[own, new], fit.share[own, own]
    enough = (fit.total[own, new] >= config.min_tracks).all()
    return bool(enough and (better > config.min_share).all() and (better - before > config.min_gain).all())
