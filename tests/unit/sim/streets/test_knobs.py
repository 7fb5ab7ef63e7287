"""Turning one knob of a street changes only what it names."""

import hashlib

import numpy as np
import pytest

from sim.streets.street import Street, StreetConfig, build_street


def build(**knobs: object) -> Street:
    return build_street(StreetConfig(kind="straight", length_m=20.0, **knobs), np.random.default_rng(3))


def skins(street: Street) -> dict[str, str]:
    return {name: hashlib.sha256(skin.image).hexdigest() for name, skin in street.scenery.skins.items()}


def places(street: Street) -> dict[str, tuple[float, ...]]:
    """Where everything that stands is, seen from above."""
    return {
        prop.name: (*prop.position_m[:2], prop.yaw_rad)
        for prop in street.scenery.props
        if prop.footprint_m is not None
    }


@pytest.fixture(scope="module")
def plain() -> Street:
    return build()


@pytest.mark.parametrize("knobs", [{"slope_percent": 9.0}, {"roughness": 3.0}])
def test_hills_and_roughness_move_things_up_and_down_only(plain: Street, knobs: dict[str, float]) -> None:
    shaped = build(**knobs)
    assert skins(shaped) == skins(plain)
    assert places(shaped) == places(plain)


def test_speed_bumps_change_the_road_they_lie_on_only(plain: Street) -> None:
    bumpy = build(speed_bumps=8.0)
    assert places(bumpy) == places(plain)
    ours, theirs = skins(plain), skins(bumpy)
    assert ours.keys() == theirs.keys()
    changed = {name for name in ours if ours[name] != theirs[name]}
    assert changed and all(name.startswith("road_main") for name in changed)
