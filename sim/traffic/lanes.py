"""The tracks that a network offers to cars, cyclists and pedestrians."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.ndimage import maximum_filter1d, uniform_filter1d
from scipy.spatial import cKDTree
from shapely import contains_xy

from estimator.se3 import Array
from sim.streets.network import Lane, Network
from sim.streets.path import Path, path_through
from sim.streets.road import ZEBRA_M, Road
from sim.traffic.detour import obstacles_of, round_obstacles
from sim.traffic.track import HALF_WIDTH_M, Track, track_along

_PASSING_M = HALF_WIDTH_M["bike"] + 0.1  # from a car to the middle of a bicycle
_SWERVE_M = 4.0  # over which cyclists move aside
_MOST_SHIFT_M = 0.95
_ABRUPT_M = 6.0  # a lane that ends nearer than this to the middle of a car's lane ends in a junction
_WALK_MPS = 1.3
_NOSE_SWINGS_M2 = 5.0  # of the driven car, whose path is that of its rear axle and whose nose is narrow
_INTO_HOUSE_M = 0.9


def route_track(network: Network) -> Track:
    """The driven lane, with the room that the nose of the car takes in bends."""
    lane = next((lane for lane in network.lanes if lane.is_route), None)
    speed_mps = lane.speed_mps if lane else 8.0
    return replace(
        track_along("car", network.route, speed_mps), swings_m2=_NOSE_SWINGS_M2, wraps=network.route.closed
    )


def car_tracks(network: Network) -> list[Track]:
    """Every lane for cars but the driven one."""
    lanes = [lane for lane in network.lanes if lane.kind == "car" and not lane.is_route]
    return [track_along("car", lane.path, lane.speed_mps, lane.gives_way_m) for lane in lanes]


def bike_tracks(network: Network) -> list[Track]:
    """Lanes for bicycles, as far right as cars beside them need; none that ends in a junction."""
    cars = [lane for lane in network.lanes if lane.kind == "car"]
    bikes = [lane for lane in network.lanes if lane.kind == "bike" and _goes_through(lane, cars)]
    beside = [route_track(network), *car_tracks(network)]
    return [_beside_cars(lane, beside) for lane in bikes]


def foot_tracks(network: Network, standing_m: Sequence[Array] = ()) -> list[Track]:
    """Pavements, round the outlines of what stands there, and zebra crossings from door to door."""
    lanes = [lane for lane in network.lanes if lane.kind == "foot"]
    walks = round_obstacles([lane.path for lane in lanes], obstacles_of(standing_m, network.carriageway))
    crossings = [path for road in network.roads for zebra in road.zebras_m for path in _across(road, zebra)]
    walked = zip(walks, lanes, strict=True)
    return [track_along("foot", path, lane.speed_mps) for path, lane in walked] + [
        track_along("foot", path, _WALK_MPS) for path in crossings
    ]


def _across(road: Road, zebra_m: float) -> list[Path]:
    """Two ways over a zebra, one in each direction; people keep right."""
    left, right = road.left_m + road.pavements_m[0], road.right_m - road.pavements_m[1]
    d_m = np.linspace(left + _INTO_HOUSE_M, right - _INTO_HOUSE_M, 40)
    there = road.path.point_m(zebra_m + 0.3 * ZEBRA_M, d_m)
    back = road.path.point_m(zebra_m + 0.72 * ZEBRA_M, d_m[::-1])
    return [path_through(there), path_through(back)]


def _goes_through(lane: Lane, cars: Sequence[Lane]) -> bool:
    """Whether both ends of an open lane lie where lanes for cars end too."""
    if lane.closed:
        return True
    inner = [car.path.points_m[80:-80] if not car.closed else car.path.points_m for car in cars]
    middle = cKDTree(np.vstack(inner))
    away, _ = middle.query(lane.path.points_m[[0, -1]])
    return bool((np.asarray(away) > _ABRUPT_M).all())


def _beside_cars(lane: Lane, cars: Sequence[Track]) -> Track:
    """The lane, moved to the right wherever it must be to clear the cars that drive along with it."""
    path = lane.path
    s_m = np.linspace(path.start_m, path.end_m, len(path.points_m))
    shift_m: Array = np.zeros(len(s_m))
    for car in cars:
        near, index = (np.asarray(each) for each in cKDTree(car.path.points_m).query(path.points_m))
        along = np.cos(car.path.headings_rad[index] - path.headings_rad) > 0.9
        clear = car.half_width_m(car.path.start_m + car.path.step_m * index) + _PASSING_M
        lacking = np.where(along, clear - near, 0.0)
        shift_m = np.maximum(shift_m, np.clip(lacking, 0.0, _MOST_SHIFT_M))
    width = round(_SWERVE_M / path.step_m)
    shift_m = np.asarray(maximum_filter1d(shift_m, width, mode="nearest"), float)
    shift_m = np.asarray(uniform_filter1d(shift_m, width, mode="nearest"), float)
    return track_along("bike", path_through(path.point_m(s_m, -shift_m), path.closed), lane.speed_mps)


def ground_m(network: Network, track: Track) -> Array:
    """(N,) height of the ground in the middle of each cell of a track for pedestrians, kerbs smoothed."""
    xy = track.cell_points_m
    on_road = contains_xy(network.carriageway, xy[:, 0], xy[:, 1])
    kerb_m = float(np.median([kerb.height_m for kerb in network.kerbs])) if network.kerbs else 0.0
    return np.where(on_road, network.relief.road_height_m(xy), network.relief.height_m(xy) + kerb_m)
