from __future__ import annotations

import numpy as np
import pytest

from sim.sensing.exposure import (
    BRIGHT_LEVEL,
    BRIGHTEST_MEAN,
    DARKEST_MEAN,
    LARGEST_GAIN,
    LEFT_DARK,
    LONGEST_EXPOSURE_S,
    AutoExposure,
    Exposure,
    FixedExposure,
)
from sim.sensing.face import GreyImage
from sim.sensing.sensor import expose

PERIOD_S = 0.1


def scene(level: float) -> GreyImage:
    """Return light with some contrast around a level."""
    return np.float32(level) * np.linspace(0.4, 1.6, 400 * 640, dtype=np.float32).reshape(400, 640)


def means_of_images(control: AutoExposure, light: GreyImage, count: int) -> list[float]:
    means = []
    for _ in range(count):
        image = expose(light, 0.0, np.random.default_rng(0), control.now)
        control.watch(image)
        means.append(float(image.mean()))
        control.steer(PERIOD_S)
    return means


def test_a_sunny_day_is_exposed_as_it_comes() -> None:
    control = AutoExposure()
    control.settle(scene(105))
    means_of_images(control, scene(100), 5)
    assert control.now == Exposure()
    assert control.now.scale == 1


def test_out_of_a_tunnel_images_glare_for_some_frames() -> None:
    control = AutoExposure()
    control.settle(scene(6))
    means = means_of_images(control, scene(105), 25)
    assert means[0] > 230
    assert means[2] > BRIGHTEST_MEAN + 20
    assert means[-1] == pytest.approx(105, abs=1)
    assert control.now == Exposure()
    assert (np.diff(means) < 1).all()


def test_into_a_tunnel_images_are_dark_at_first() -> None:
    control = AutoExposure()
    control.settle(scene(105))
    means = means_of_images(control, scene(6), 25)
    assert means[0] < 10
    assert means[-1] == pytest.approx(DARKEST_MEAN * (6 / DARKEST_MEAN) ** LEFT_DARK, rel=0.15)
    assert (np.diff(means) > -1).all()


def test_the_dimmer_the_light_the_dimmer_the_image() -> None:
    """Nowhere does a step towards the dark end in a brighter image."""
    means = []
    for level in np.geomspace(105, 1, 40):
        control = AutoExposure()
        control.settle(scene(level))
        means += means_of_images(control, scene(level), 1)
    assert (np.diff(means) < 1).all()
    assert means[-1] == pytest.approx(DARKEST_MEAN * (1 / DARKEST_MEAN) ** LEFT_DARK, rel=0.02)


def test_the_road_before_the_car_does_not_burn_out() -> None:
    """A tenth of the image lit by the own beams, the rest nearly black."""
    light = np.full((400, 640), 0.05, np.float32)
    light[280:320, 100:500] = 5 * np.linspace(0.8, 1, 400, dtype=np.float32)
    control = AutoExposure()
    control.settle(light)
    image = expose(light, 0.0, np.random.default_rng(0), control.now)
    assert np.quantile(image, 0.97) == pytest.approx(BRIGHT_LEVEL, rel=0.05)
    assert (image >= 250).mean() < 0.03


def test_the_dark_takes_time_first_and_then_gain_up_to_their_limits() -> None:
    dusk, night, cellar = AutoExposure(), AutoExposure(), AutoExposure()
    dusk.settle(scene(10))
    night.settle(scene(0.5))
    cellar.settle(scene(0.0))
    assert dusk.now.gain == 1 < dusk.now.scale
    assert night.now.time_s == LONGEST_EXPOSURE_S
    assert 1 < night.now.gain < LARGEST_GAIN
    assert cellar.now == Exposure(LONGEST_EXPOSURE_S, LARGEST_GAIN)


@pytest.mark.parametrize("scale", [0.2, 1.0, 3.0, 100.0])
def test_exposure_and_gain_multiply_to_the_scale(scale: float) -> None:
    assert Exposure.of_scale(scale).scale == pytest.approx(scale)


def test_a_fixed_exposure_stays() -> None:
    control = FixedExposure()
    control.settle(scene(1))
    control.watch(np.zeros((4, 4), np.uint8))
    control.steer(PERIOD_S)
    assert control.now == Exposure()


def test_gain_raises_noise() -> None:
    """The same level of the image from fewer electrons."""
    flat = np.full((200, 300), 100.0, np.float32)
    day, night = Exposure(), Exposure(gain=8.0)
    noise = [
        expose(flat / exposure.gain, 1.0, np.random.default_rng(0), exposure).std()
        for exposure in (day, night)
    ]
    assert noise[1] > 2.5 * noise[0]
