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
# Between these means of an image nothing is changed: steering at every cloud would make images flicker.
# Beyond them the exposure is steered until the mean is near the one wanted.
DARKEST_MEAN, WANTED_MEAN, BRIGHTEST_MEAN = 62.0, 105.0, 155.0
_NEAR_ENOUGH = 0.12  # of a factor
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
        self._mean = WANTED_MEAN
        self._is_steering = False

    def settle(self, light: GreyImage) -> None:
        sparse = light[:: _STRIDE_PX // 2, :: _STRIDE_PX // 2]
        for _ in range(_SETTLING_STEPS):
            self._mean = metered(np.clip(sparse * np.float32(self.now.scale), 0, 255))
            self._adjust(1.0)

    def watch(self, image: Image) -> None:
        self._mean = metered(image[::_STRIDE_PX, ::_STRIDE_PX])

    def steer(self, later_s: float) -> None:
        self._adjust(float(1 - np.exp(-later_s / _TIME_CONSTANT_S)))

    def _adjust(self, share: float) -> None:
        mean = max(self._mean, 1.0)
        if not DARKEST_MEAN <= mean <= BRIGHTEST_MEAN:
            self._is_steering = True
        elif abs(np.log(mean / WANTED_MEAN)) < _NEAR_ENOUGH:
            self._is_steering = False
        if self._is_steering:
            self.now = Exposure.of_scale(self.now.scale * (WANTED_MEAN / mean) ** share)


def metered(image: GreyImage | Image) -> float:
    """Return the mean level, the middle counting more; a largely saturated image counts as far brighter."""
    height, width = image.shape
    rows, columns = (np.hanning(length + 2)[1:-1].astype(np.float32) for length in (height, width))
    weights = 1 + (_METERED_WEIGHT - 1) * rows[:, None] * columns
    weights /= weights.sum()
    saturated = float(((image >= _WHITE) * weights).sum())
    return float((image * weights).sum()) + _GLARE * max(saturated - _USUAL_WHITE, 0.0)
