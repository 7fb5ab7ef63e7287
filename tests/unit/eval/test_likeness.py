"""Likeness: the figures of the tool that measured the real drives, and what is inside their range."""

import cv2
import numpy as np
import pytest

from estimator.bundle import Image
from eval.likeness import REAL_DRIVES, compare_with_real
from eval.likeness_statistics import statistics_of


def passing_texture() -> list[Image]:
    """Return 17 frames past which a texture of three scales moves by three pixels each."""
    rng = np.random.default_rng(3)
    wide = np.zeros((160, 400), np.float32)
    for side_px in (4, 10, 25):
        nodes = rng.uniform(0, 255, (160 // side_px + 2, 400 // side_px + 2)).astype(np.float32)
        wide += cv2.resize(nodes, (400, 160), interpolation=cv2.INTER_CUBIC) / 3
    texture = np.clip(np.rint(wide), 0, 255).astype(np.uint8)
    return [np.ascontiguousarray(texture[20:140, 3 * index : 3 * index + 240]) for index in range(17)]


def test_the_figures_are_those_of_the_tool_that_measured_the_real_drives() -> None:
    found = statistics_of(passing_texture())
    # That tool begins to count survivors at every fifth frame, this one at every frame.
    means = {name: values[:: 5 if "klt" in name else 1].mean() for name, values in found.items()}
    measured = {  # by that tool, on these frames, rounded
        "fast20_per_100kpx": 2076.2,
        "gftt_per_100kpx": 1915.4,
        "gradient_mean": 11.64,
        "textureless_share": 0.007,
        "contrast_std": 36.8,
        "spectrum_slope": -5.16,
        "klt_survival_1": 0.83,
        "klt_survival_5": 0.78,
        "klt_survival_10": 0.73,
    }
    rounding = {"fast20_per_100kpx": 0.05, "gftt_per_100kpx": 0.05, "contrast_std": 0.05}
    for name, value in measured.items():
        # the last digit, and half a per mille for what differs between processors
        assert means[name] == pytest.approx(value, abs=rounding.get(name, 0.006) + 5e-4 * abs(value)), name


def test_a_blank_wall_is_all_textureless_and_keeps_no_track() -> None:
    statistics = statistics_of([np.full((60, 80), 90, np.uint8)] * 12)
    assert statistics["textureless_share"].tolist() == [1.0] * 12
    assert statistics["klt_survival_1"].tolist() == [0.0] * 2  # ten frames are left behind two of them
    assert not any(each.inside for each in compare_with_real(statistics) if "klt" in each.name)


def test_values_within_fifteen_percent_of_the_real_drives_are_inside() -> None:
    for factor, inside in ((0.86, True), (0.84, False)):
        statistics = {name: np.full(5, low * factor) for name, (low, _) in REAL_DRIVES.items()}
        # a slope is negative: nearer to zero is above the range
        assert all(each.inside is inside for each in compare_with_real(statistics))


def test_a_spread_beyond_the_range_is_told_apart_from_the_mean() -> None:
    statistics = {name: np.full(20, sum(ends) / 2) for name, ends in REAL_DRIVES.items()}
    statistics["contrast_std"] = np.r_[np.full(10, 20.0), np.full(10, 107.0)]
    contrast = next(each for each in compare_with_real(statistics) if each.name == "contrast_std")
    assert contrast.inside and not contrast.spread_inside
    assert (contrast.low, contrast.high) == (20.0, 107.0)
