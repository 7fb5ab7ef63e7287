"""Which axes of a camera's pose the drive itself has shown, as opposed to the rig file's prior."""

from __future__ import annotations

import numpy as np

from estimator.config import Config
from estimator.estimate import Axes
from estimator.observations import Mask
from estimator.ranges import AngleRad, LengthM, Share
from estimator.se3 import SE3, Array

_TURNS = ("pitch", "yaw", "roll")  # about the camera's axes: right, down, forward
_PLACES = ("forward", "sideways", "height")  # along the car's axes


class ObservabilityConfig(Config):
    """When an axis counts as observed.

    Either the drive carries ``share`` of the information on it, or, where the rig file is so good that no
    drive could, it shows the axis by itself to within the sigma given here. Whatever clocks leave open must
    lie within that sigma as well.
    """

    share: Share = 0.9
    rotation_rad: AngleRad = 0.0005
    translation_m: LengthM = 0.005


def observed_axes(
    covariance: Array, prior: Array, config: ObservabilityConfig, hidden: Array | None = None
) -> Axes:
    """Tell for each axis of the tangent, in the camera frame, whether the drive has made it observable.

    Args:
        covariance: (6, 6) of the posterior, without what is added to it afterwards for errors that all
            windows share.
        prior: (6, 6) of the rig file.
        config: Thresholds.
        hidden: (6, 6) of what clocks leave open, if anything.
    """
    enough = np.repeat([config.rotation_rad, config.translation_m], 3)
    shown = _is_shown(np.diag(covariance), np.diag(prior), enough, config)
    if hidden is not None:
        shown[:3] &= ~_is_hidden(hidden[:3, :3], config.rotation_rad)
        shown[3:] &= ~_is_hidden(hidden[3:, 3:], config.translation_m)
    rx, ry, rz, tx, ty, tz = (bool(each) for each in shown)
    return rx, ry, rz, tx, ty, tz


def weak_words(
    observed: Axes,
    covariance: Array,
    prior: Array,
    ego_from_cam: SE3,
    config: ObservabilityConfig,
    hidden: Array | None = None,
) -> tuple[str, ...]:
    """Name what is not observed, as people speak of a car: how the camera is turned, where it sits in it.

    Turns are about the camera's own axes. Places are along the car's, so their covariance is turned first;
    where no axis of the car is weak by itself and one of the camera is, the weakest is named.
    """
    rotation = ego_from_cam.rotation
    after, before = (np.diag(rotation @ each[3:, 3:] @ rotation.T) for each in (covariance, prior))
    weak = ~_is_shown(after, before, np.full(3, config.translation_m), config)
    if hidden is not None:
        weak |= _is_hidden(rotation @ hidden[3:, 3:] @ rotation.T, config.translation_m)
    if not all(observed[3:]) and not weak.any():
        weak[np.argmax(after / before)] = True
    turns = tuple(word for word, seen in zip(_TURNS, observed[:3], strict=True) if not seen)
    return turns + tuple(word for word, is_weak in zip(_PLACES, weak, strict=True) if is_weak)


def _is_shown(after: Array, before: Array, enough: Array, config: ObservabilityConfig) -> Mask:
    """Compare the drive's own information with the prior's: (N,) variances, and sigmas that are enough."""
    of_drive = 1 / after - 1 / before
    of_both = of_drive >= config.share / after
    return np.asarray(of_both | (of_drive >= 1 / enough**2))


def _is_hidden(open_still: Array, enough: float) -> Mask:
    """Tell which of three axes share in a (3, 3) covariance that is too large, whichever way they point."""
    variance = np.diag(open_still)
    return np.asarray((variance.sum() > enough**2) & (variance > enough**2 / 3))
