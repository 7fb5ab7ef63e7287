"""Vignetting, defocus, dirt and JPEG: each does what it says, and more of it with severity."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from sim.sensing.defocus import defocus, disc_kernel
from sim.sensing.dirt import splash
from sim.sensing.face import GreyImage
from sim.sensing.jpeg import through_jpeg
from sim.sensing.vignetting import transmission

SIZE_PX = (640, 400)
LADDER = [0.5, 1, 2, 3, 4, 5]


def rng() -> np.random.Generator:
    return np.random.default_rng(3)


def texture() -> GreyImage:
    fine = np.random.default_rng(0).uniform(60, 190, (400, 640)).astype(np.float32)
    return defocus(fine, disc_kernel(1))


def test_vignetting_darkens_the_corners_more_with_severity_and_leaves_the_middle() -> None:
    maps = [transmission(SIZE_PX, severity, rng()) for severity in LADDER]
    corners = [np.mean([passed[0, 0], passed[0, -1], passed[-1, 0], passed[-1, -1]]) for passed in maps]
    assert (np.diff(corners) < -0.05).all()
    assert corners[0] > 0.85
    assert corners[-1] < 0.3
    assert all(passed.max() <= 1 and passed[200, 320] > 0.98 for passed in maps)


def test_vignetting_of_two_lenses_is_not_quite_the_same() -> None:
    one, other = (transmission(SIZE_PX, 3, np.random.default_rng(seed)) for seed in (0, 1))
    assert 0 < np.abs(one - other).max() < 0.15


def test_defocus_turns_a_point_into_a_disc_around_it_that_grows() -> None:
    point = np.zeros((41, 41), np.float32)
    point[20, 20] = 1000
    spreads = []
    rows, columns = np.mgrid[-20:21, -20:21]
    for severity in LADDER:
        disc = defocus(point, disc_kernel(severity))
        assert disc.sum() == pytest.approx(1000, rel=1e-4)
        assert abs((disc * columns).sum()) < 0.1
        assert abs((disc * rows).sum()) < 0.1
        spreads.append(float(((rows**2 + columns**2) * disc).sum() / 1000))
    assert (np.diff(spreads) > 0).all()
    assert spreads[-1] == pytest.approx(4.4**2 / 2, rel=0.1)  # of an even disc


def test_dirt_covers_more_with_severity_at_the_same_places() -> None:
    dirts = [splash(SIZE_PX, severity, rng()) for severity in LADDER]
    covered = [float((dirt.cover > 0.3).mean()) for dirt in dirts]
    assert (np.diff(covered) > 0).all()
    assert 0.05 < covered[-1] < 0.6
    for less, more in pairwise(dirts):
        assert (more.cover >= less.cover - 1e-6).all()


def test_dirt_has_soft_edges_and_veils_what_it_hides() -> None:
    dirt = splash(SIZE_PX, 4, rng())
    assert np.abs(np.diff(dirt.cover, axis=1)).max() < 0.35
    light = texture()
    seen = dirt.over(light)
    thick = dirt.cover > 0.6
    detail = [np.diff(image, axis=1, append=0)[thick].std() for image in (light, seen)]
    assert detail[1] < 0.45 * detail[0]
    assert (seen >= 0).all()
    assert seen.max() < 200


def test_two_lenses_are_not_soiled_alike() -> None:
    one, other = (splash(SIZE_PX, 4, np.random.default_rng(seed)).cover for seed in (0, 1))
    assert np.corrcoef(one.ravel(), other.ravel())[0, 1] < 0.5


def test_jpeg_loses_more_with_severity() -> None:
    image = np.rint(texture()).astype(np.uint8)
    errors = [
        float(np.abs(through_jpeg(image, severity).astype(float) - image).mean()) for severity in LADDER
    ]
    assert (np.diff(errors) > 0).all()
    assert errors[-1] > 5
