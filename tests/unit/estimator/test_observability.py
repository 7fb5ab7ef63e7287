"""Which axes a drive has shown: on a straight without overlaps few, in a turn with overlaps all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.belief import Belief
from estimator.estimate import ALL_AXES, Status
from estimator.factors import GraphConfig
from estimator.graph import adjust
from estimator.loss import Loss
from estimator.observability import ObservabilityConfig, observed_axes, weak_words
from estimator.off_nominal import OffNominal
from estimator.se3 import SE3
from estimator.status import StatusConfig, judge
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import arc, left_side_rig

CONFIG = ObservabilityConfig()
RIG = left_side_rig()
PRIOR = RIG.prior.covariance


def after_driving(curvature_per_m: float, *, overlaps: bool) -> Belief:
    """Return what ten metres teach, from landmarks of each camera's own or from those they share too."""
    scene = known_scene(RIG, arc(1.0, 10, curvature_per_m))
    scene = replace(scene, stamps_ns=tuple(range(0, 2_000_000_000, 200_000_000)))
    seen = sightings(scene, 0.1)
    seen = replace(seen, sigma_px=np.full(len(seen), 0.1))
    if not overlaps:
        seen = seen.select(~seen.handed_over).of_enough_views(2)
    nominal = Belief.nominal(RIG)
    found = adjust(scene, seen, on_road(scene), nominal, Loss(1.0), GraphConfig(), want_covariance=True)
    return Belief(found.scene.rig, found.covariance)


STRAIGHT, TURN = after_driving(0.0, overlaps=False), after_driving(1 / 15, overlaps=True)


def weak_in(belief: Belief, name: str) -> tuple[str, ...]:
    covariance = belief.camera_covariance(name)
    observed = observed_axes(covariance, PRIOR, CONFIG)
    return weak_words(observed, covariance, PRIOR, belief.rig[name].ego_from_cam, CONFIG)


def status(belief: Belief, name: str) -> Status:
    observed = observed_axes(belief.camera_covariance(name), PRIOR, CONFIG)
    return judge(name, belief, RIG, 500, 500, 0, StatusConfig(), observed, OffNominal())


@pytest.mark.parametrize("name", RIG.estimated_names)
def test_a_straight_drive_without_overlaps_does_not_show_where_a_camera_sits(name: str) -> None:
    assert {"forward", "sideways"} <= set(weak_in(STRAIGHT, name))  # height, the road shows
    assert status(STRAIGHT, name) == Status.WEAK


@pytest.mark.parametrize("name", RIG.estimated_names)
def test_a_turn_with_overlaps_shows_every_axis(name: str) -> None:
    assert observed_axes(TURN.camera_covariance(name), PRIOR, CONFIG) == ALL_AXES
    assert weak_in(TURN, name) == ()
    assert status(TURN, name) == Status.CONVERGED


def test_an_axis_is_observed_when_the_drive_carries_nine_tenths_of_the_information() -> None:
    shrunk = np.diag([0.09, 0.11, 0.09, 0.09, 0.11, 0.09]) * PRIOR
    assert observed_axes(shrunk, PRIOR, CONFIG) == (True, False, True, True, False, True)
    assert observed_axes(PRIOR, PRIOR, CONFIG) == (False,) * 6


def test_a_rig_file_that_is_better_than_any_drive_leaves_what_the_drive_shows_well_observed() -> None:
    good = np.diag([0.0005**2] * 3 + [0.004**2] * 3)
    shown_to = np.diag([0.0004**2] * 3 + [0.0045**2] * 3)
    both = np.linalg.inv(np.linalg.inv(good) + np.linalg.inv(shown_to))
    assert observed_axes(both, good, CONFIG) == ALL_AXES
    vague = np.linalg.inv(np.linalg.inv(good) + np.linalg.inv(9.0 * shown_to))
    assert not any(observed_axes(vague, good, CONFIG))


def test_places_are_named_along_the_car_whichever_way_the_camera_looks() -> None:
    backward = SE3(np.array([[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]), np.zeros(3))
    covariance = 0.01 * PRIOR
    covariance[5, 5] = PRIOR[5, 5]  # along the view
    assert weak_words((*ALL_AXES[:5], False), covariance, PRIOR, backward, CONFIG) == ("forward",)
    covariance[1, 1] = PRIOR[1, 1]
    assert weak_words((True, False, *ALL_AXES[:3], False), covariance, PRIOR, backward, CONFIG) == (
        "yaw",
        "forward",
    )
