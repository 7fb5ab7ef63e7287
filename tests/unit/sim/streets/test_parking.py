"""Parked cars: none like another, and where there are more of them than models, likes stand far apart."""

import numpy as np
import pytest

from sim.streets.footprint import Ground
from sim.streets.kinds import Ground as Asked
from sim.streets.kinds import draw_network
from sim.streets.parking import MODELS, choose_cars, draw_cars, paint_cars, park
from sim.streets.placing import Site

ROW_M = np.column_stack([np.arange(0.0, 600.0, 6.0), np.zeros(100)])


def parked(share: float) -> Site:
    plan, relief, models, bays = np.random.default_rng(5).spawn(4)
    network = draw_network("bend", 70.0, Asked(), plan, relief)
    site = Site("parked", Ground([]), network.relief, ROW_M)
    park(site, network.bays, draw_cars(models), share, bays)
    return site


def test_no_two_cars_of_a_street_are_alike() -> None:
    skins = [prop.skin for prop in parked(1.0).props]
    assert 20 < len(skins) == len(set(skins))


def test_which_cars_are_parked_does_not_depend_on_how_many() -> None:
    some, all_cars = ({(prop.skin, prop.position_m) for prop in parked(share).props} for share in (0.4, 1.0))
    assert some < all_cars


def test_only_cars_that_stand_somewhere_are_painted() -> None:
    models = draw_cars(np.random.default_rng(1))
    props = parked(0.2).props
    assert 0 < len(props) < MODELS
    assert set(paint_cars(models, props)) == {prop.skin for prop in props}


@pytest.mark.parametrize("seed", range(3))
def test_a_car_comes_again_far_from_its_like(seed: int) -> None:
    chosen = choose_cars(ROW_M, np.random.default_rng(seed).permutation(len(ROW_M)), MODELS)
    assert set(chosen) == set(range(MODELS))
    apart_m = [np.diff(ROW_M[chosen == model, 0]).min(initial=600.0) for model in range(MODELS)]
    assert min(apart_m) > 60.0
    assert np.median(apart_m) > 150.0


def test_the_paint_of_each_car_differs() -> None:
    models, props = draw_cars(np.random.default_rng(1)), parked(0.3).props
    images = {skin.image.tobytes() for skin in paint_cars(models, props).values()}
    assert len(images) == len(props)
