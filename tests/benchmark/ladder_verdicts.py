"""What a ladder's figures say: does a statistic go the way that was said beforehand, over several streets?

Every severity is measured on the same streets, so what counts is the step that each street takes by itself,
and its standard error is that of those steps' mean. A step back counts once it is larger than that error and
than what nobody would see.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from tests.benchmark.ladder_effects import Effect

UNSEEN = 0.01  # of the pixels or tracks, or of the statistic's largest value
_KEPT = 0.05  # of its value without the effect: what may change of a statistic that must not
_ARRIVES_ERRORS = 2.0  # by which the last severity must lie beyond none
REVERSES = "REVERSES"
MARKS = {1: "<", -1: ">", 0: "-"}


def verdict(name: str, values: Array, effect: Effect) -> str:
    """Return the mark of one statistic.

    Args:
        name: The statistic's.
        values: (streets, severities), two streets or more.
        effect: What is said of it beforehand.

    Returns:
        ``<`` it must rise and does, ``>`` it must fall and does, ``=`` it must stay and does, ``-`` nothing
        is asked of it, or ``REVERSES``.
    """
    sign = (name in effect.rises) - (name in effect.falls)
    means = values.mean(0)
    if name in effect.keeps:
        return "=" if (np.abs(means - means[0]) <= _KEPT * abs(means[0])).all() else REVERSES
    if not sign:
        return MARKS[0]
    unseen = UNSEEN * (1.0 if "share" in name or "klt" in name else float(np.abs(means).max()))
    steps, way = sign * np.diff(values, axis=1), sign * (values[:, -1] - values[:, 0])
    goes_on = (steps.mean(0) > -np.maximum(unseen, standard_error(steps))).all()
    arrives = way.mean() > max(unseen, _ARRIVES_ERRORS * float(standard_error(way)))
    return MARKS[sign] if goes_on and arrives else REVERSES


def standard_error(values: Array) -> Array:
    """Return that of the mean over the first axis."""
    return np.asarray(values.std(0, ddof=1) / np.sqrt(len(values)))
