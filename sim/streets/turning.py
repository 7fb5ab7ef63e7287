"""Lanes of roads that meet: straight across, and right turns out of and into the lane beside the mouth."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree
from shapely import contains_xy

from estimator.se3 import Array
from sim.streets.junctions import Joint
from sim.streets.network import Lane
from sim.streets.path import STEP_M, Path, path_through
from sim.streets.road import Road, Strip
from sim.streets.rounded import smoothed

SIDE_SPEED_MPS = 6.0
_LEG_M = 7.5  # from the corner of a turn to where it begins and ends
_STOP_BEFORE_M = 2.2  # the carriageway that is given way to


def strip_of(road: Road, forward: bool) -> Strip:
    """The lane of a two-way road in one direction that is nearest to its kerb."""
    side = -1 if forward else 1
    return max((s for s in road.strips if s.forward == forward), key=lambda s: side * s.d_m)


def across(one: Road, other: Road, through: Road) -> Lane:
    """The lane out of one arm, straight across the through road, into the arm facing it."""
    start = one.path.offset(strip_of(one, False).d_m, backwards=True).points_m
    end = other.path.offset(strip_of(other, True).d_m).points_m
    lane = Lane("car", smoothed(path_through(np.vstack([start, end[1:]]))), SIDE_SPEED_MPS)
    return giving_way(lane, through)


def right_turns(arm: Road, through: Road, joint: Joint) -> list[Lane]:
    """From the arm to the right, and from the through road to the right into the arm."""
    near = strip_of(through, joint.side < 0)
    along = through.path.offset(near.d_m, backwards=joint.side > 0).points_m
    inward = arm.path.offset(strip_of(arm, False).d_m, backwards=True).points_m
    outward = arm.path.offset(strip_of(arm, True).d_m).points_m
    leaving = Lane("car", _turned(inward, along), SIDE_SPEED_MPS)
    entering = Lane("car", _turned(along, outward), SIDE_SPEED_MPS)
    return [giving_way(leaving, through), entering]


def _turned(before_m: Array, after_m: Array) -> Path:
    """Follow one line up to where it meets another, turn, and follow that."""
    gap_m, nearest = (np.asarray(each) for each in cKDTree(after_m).query(before_m))
    meets = int(np.argmin(gap_m))
    before = before_m[: max(meets - round(_LEG_M / STEP_M), 1)]
    after = after_m[int(nearest[meets]) + round(_LEG_M / STEP_M) :]
    u = np.linspace(0, 1, 60)[1:-1, None]
    bend = (1 - u) ** 2 * before[-1] + 2 * u * (1 - u) * before_m[meets] + u**2 * after[0]
    return smoothed(path_through(np.vstack([before, bend, after])))


def giving_way(lane: Lane, through: Road) -> Lane:
    """The lane, stopping before it enters the through road."""
    outline = through.outline()
    inside = contains_xy(outline, lane.path.points_m[:, 0], lane.path.points_m[:, 1])
    if inside[0] or not inside.any():
        return lane
    enters = lane.path.start_m + lane.path.step_m * int(np.argmax(inside))
    return replace(lane, gives_way_m=enters - _STOP_BEFORE_M)
