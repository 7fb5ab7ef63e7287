"""Claims on tiny tracks: following, crossing, giving way."""

from __future__ import annotations

import numpy as np

from sim.streets.path import Path, path_through, straight_path
from sim.traffic.conflicts import find_conflicts
from sim.traffic.flow import STEP_S, Entrant, Flow
from sim.traffic.pace import Pace
from sim.traffic.platoon import Platoon
from sim.traffic.track import CELL_M, Track, track_along
from sim.traffic.trajectory import Trajectories

PACE = Pace(1.6, 2.0, 1.5, STEP_S)


def road(x: float, y: float, heading_rad: float, length_m: float = 80.0) -> Path:
    return straight_path(np.array([x, y]), heading_rad, length_m)


def crossing_tracks() -> list[Track]:
    return [track_along("car", road(-40, 0, 0.0), 8.0), track_along("car", road(0, -40, np.pi / 2), 8.0)]


def cars(tracks: list[Track], each: int) -> list[Entrant]:
    return [Entrant(track, 4.5, 1.0, 0.0) for track in range(len(tracks)) for _ in range(each)]


def test_only_the_crossing_excludes_others_and_is_a_box() -> None:
    tracks = crossing_tracks()
    found = find_conflicts(tracks, [False, False])
    cells, offsets = found.excluded_by(0, 0, tracks[0].cell_count - 1)
    assert set(cells) <= set(range(int(found.first[1]), int(found.first[2])))
    at_m = tracks[0].cell_points_m[np.unique(offsets)]
    assert np.abs(at_m[:, 0]).max() < 2.6
    assert found.boxed.sum() == 2 * len(np.unique(offsets))


def test_lanes_side_by_side_do_not_exclude_each_other() -> None:
    tracks = [track_along("car", road(0, y, 0.0), 8.0) for y in (0.0, 3.1)]
    assert len(find_conflicts(tracks, [False, False]).cells) == 0


def test_cars_on_crossing_roads_take_turns() -> None:
    tracks = crossing_tracks()
    flow = Flow(tracks, cars(tracks, 3), [], PACE)
    start, end = flow.at(0.0)[0], flow.at(60.0)[0]
    assert (end - start > 40.0).all()
    for time_s in np.arange(0.0, 60.0, 0.2):
        s_m = np.mod(flow.at(float(time_s))[0], tracks[0].ring_m) - tracks[0].beyond_m - 40.0
        inside = np.abs(s_m) < 2.25 + 0.9
        assert not (inside[flow.track == 0].any() and inside[flow.track == 1].any())


def test_a_follower_keeps_its_gap() -> None:
    tracks = [track_along("car", road(0, 0, 0.0, 120.0), 8.0)]
    flow = Flow(tracks, [Entrant(0, 4.5, brisk, 0.0) for brisk in (1.3, 0.5, 1.2)], [], PACE)
    for time_s in np.arange(0.0, 60.0, 0.5):
        way = flow.at(float(time_s))[0]
        gaps = np.diff(np.append(way, way[0] + tracks[0].ring_m)) - 4.5
        assert gaps.min() > PACE.gap_m - 1e-9


def test_others_wait_for_the_driven_car_and_go_on_behind_it() -> None:
    route = track_along("car", road(-40, 0, 0.0), 8.0)
    platoon = Platoon(route, lambda time_s: 5.0 * time_s, [])
    crossing = [track_along("car", road(0, -40, np.pi / 2), 8.0)]
    flow = Flow(crossing, cars(crossing, 3), [platoon], PACE)
    passes_s = 40.0 / 5.0  # when the driven car is on the crossing
    for time_s in np.arange(passes_s - 1.0, passes_s + 1.0, 0.1):
        s_m = np.mod(flow.at(float(time_s))[0], crossing[0].ring_m) - crossing[0].beyond_m - 40.0
        assert (np.abs(s_m) > 2.25 + 0.9).all()
    assert (flow.at(60.0)[0] - flow.at(passes_s)[0] > 60.0).all()


def test_speed_allows_to_stop_within_what_is_free() -> None:
    speed, way = np.array([8.0]), np.array([0.0])
    free = way + 8.0**2 / (2 * PACE.brake_mps2) + 0.02
    while speed[0] > 1e-3:
        following = PACE.next_speed(speed, np.array([8.0]), free - way)
        way, speed = way + (speed + following) / 2 * STEP_S, following
        assert way[0] <= free[0]
    assert way[0] > free[0] - 0.5


def test_a_table_is_met_at_its_rows_and_smooth_between() -> None:
    table = Trajectories(0.0, 0.5, np.array([0.0]), np.array([2.0]))
    table.append(np.array([1.5]), np.array([4.0]))
    way, speed = table.at(0.25)
    np.testing.assert_allclose([way[0], speed[0]], [0.25 * 2 + 2 * 0.25**2, 3.0])
    np.testing.assert_allclose(table.at(0.5)[0], [1.5])


def test_a_track_slows_down_before_its_bend() -> None:
    turn = np.linspace(0, np.pi / 2, 40)
    bend = np.stack([40 + 6 * np.sin(turn), 6 - 6 * np.cos(turn)], axis=1)
    points = np.vstack([[0.0, 0.0], bend, [46.0, 40.0]])
    track = track_along("car", path_through(points), 10.0)
    speeds = track.cell_speeds_mps
    at_bend = round((40 + track.beyond_m + 4) / CELL_M)
    assert speeds[0] == 10.0 and speeds[at_bend] < 4.5
    assert np.diff(speeds**2).min() > -2 * 1.3 * CELL_M
