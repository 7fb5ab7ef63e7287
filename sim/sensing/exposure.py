"""Exposure time and gain: fixed, or steered by what the last images metered, as a camera does it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from estimator.bundle import Image
from sim.sensing.face import GreyImage

DAY_EXPOSURE_S = 0.0007  # at which a sunny day's light makes the levels it is given in, at gain 1
SHORTEST_EXPOSURE_S = 0.00005
LONGEST_EXPOSURE_S = 0.015
LARGEST_GAIN = 16.0  # 24 dB
# An image whose mean lies between these at a sunny day's exposure is left as it is: dim days look dim. Beyond
# them the exposure changes so that the mean keeps to the upper limit, and falls below the lower one by this
# power of the light only: the night stays darker than the day. There is no jump where that begins.
DARKEST_MEAN, BRIGHTEST_MEAN, LEFT_DARK = 62.0, 155.0, 0.22
# Longer exposures stop where more than this share of the image would be brighter than this level: lamps may
# burn out, the road before the car's own lamps may not, however black the rest.
_BRIGHT_SHARE, BRIGHT_LEVEL = 0.03, 215.0
_NEAR_ENOUGH = 0.01  # of a factor, from which on a sunny day's exposure is taken as it is
_TIME_CONSTANT_S = 0.3
_SETTLING_STEPS = 60
_METERED_WEIGHT = 3.0  # of the middle of the image, against the rim
_STRIDE_PX = 8
_WHITE = 250
_USUAL_WHITE = 0.3  # share of an image that may be white without hurry
_GLARE = 900.0  # levels that white beyond that is taken to hide


@dataclass(frozen=True)
class Exposure:
    """How long the sensor collects light, and how much its signal is amplified."""

    time_s: float = DAY_EXPOSURE_S
    gain: float = 1.0

    @property
    def scale(self) -> float:
        """Level of the image per level of a sunny day."""
        return self.time_s / DAY_EXPOSURE_S * self.gain

    @staticmethod
    def of_scale(scale: float) -> Exposure:
        """Return the longest exposure within its limits, and gain for the rest."""
        time_s = float(np.clip(scale * DAY_EXPOSURE_S, SHORTEST_EXPOSURE_S, LONGEST_EXPOSURE_S))
        return Exposure(time_s, float(np.clip(scale * DAY_EXPOSURE_S / time_s, 1.0, LARGEST_GAIN)))


class ExposureControl(Protocol):
    """One camera's exposure, from image to image."""

    now: Exposure

    def settle(self, light: GreyImage) -> None:
        """Adapt to (H, W) light as if it had been there for long; once, before the first image."""

    def watch(self, image: Image) -> None:
        """Meter an image that was taken."""

    def steer(self, later_s: float) -> None:
        """Set the exposure of an image so long after the one that was metered last."""


class FixedExposure:
    """A sunny day's, whatever the light."""

    def __init__(self) -> None:
        self.now = Exposure()

    def settle(self, light: GreyImage) -> None:
        pass

    def watch(self, image: Image) -> None:
        pass

    def steer(self, later_s: float) -> None:
        pass


class AutoExposure:
    """Follows the light with a time constant, within limits; sits still while images are well exposed.

    What is saturated meters as little more than white however bright it is, so a glare takes some images to
    get over.
    """

    def __init__(self) -> None:
        self.now = Exposure()
        self._wanted_scale = 1.0

    def settle(self, light: GreyImage) -> None:
        sparse = light[:: _STRIDE_PX // 2, :: _STRIDE_PX // 2]
        for _ in range(_SETTLING_STEPS):
            self._wanted_scale = wanted_scale(
                np.clip(sparse * np.float32(self.now.scale), 0, 255), self.now.scale
            )
            self._adjust(1.0)

    def watch(self, image: Image) -> None:
        self._wanted_scale = wanted_scale(image[::_STRIDE_PX, ::_STRIDE_PX], self.now.scale)

    def steer(self, later_s: float) -> None:
        self._adjust(float(1 - np.exp(-later_s / _TIME_CONSTANT_S)))

    def _adjust(self, share: float) -> None:
        scale = self.now.scale * (self._wanted_scale / self.now.scale) ** share
        self.now = Exposure() if abs(np.log(scale)) < _NEAR_ENOUGH else Exposure.of_scale(scale)


def wanted_scale(image: GreyImage | Image, scale: float) -> float:
    """Return the ``Exposure.scale`` at which what an image taken at ``scale`` shows is well exposed."""
    mean = max(metered(image), 1.0)
    least = (scale * DARKEST_MEAN / mean) ** (1 - LEFT_DARK)
    by_mean = float(np.clip(1.0, least, max(least, scale * BRIGHTEST_MEAN / mean)))
    bright = max(float(np.quantile(image, 1 - _BRIGHT_SHARE)), 1.0)
    return max(min(by_mean, scale * BRIGHT_LEVEL / bright), min(by_mean, 1.0))


def metered(image: GreyImage | Image) -> float:
    """Return the mean level, the middle counting more; a largely saturated image counts as far brighter."""
    height, width = image.shape
    rows, columns = (np.hanning(length + 2)[1:-1].astype(np.float32) for length in (height, width))
    weights = 1 + (_METERED_WEIGHT - 1) * rows[:, None] * columns
    weights /= weights.sum()
    saturated = float(((image >= _WHITE) * weights).sum())
    return float((image * weights).sum()) + _GLARE * max(saturated - _USUAL_WHITE, 0.0)
