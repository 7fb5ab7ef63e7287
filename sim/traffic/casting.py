"""Draw the traffic of a street: which actors there are, on which tracks, and whom each kind gives way to."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from estimator.se3 import Array
from sim.seeds import rng_for
from sim.streets.network import Network
from sim.traffic.config import (
    CAR_SPACING_M,
    CYCLIST_SPACING_M,
    PEDESTRIAN_SPACING_M,
    TrafficConfig,
    jam_share,
)
from sim.traffic.entrants import draw_entrants
from sim.traffic.fleet import fit_for, rider_models, vehicle_models, walker_models
from sim.traffic.flow import STEP_S, Flow
from sim.traffic.lanes import bike_tracks, car_tracks, foot_tracks, ground_m, route_track
from sim.traffic.model import Model
from sim.traffic.movers import Movers
from sim.traffic.pace import Pace
from sim.traffic.pedalling import pedalling
from sim.traffic.platoon import Platoon, draw_members
from sim.traffic.rolling import rolling
from sim.traffic.track import Track
from sim.traffic.traffic import NOBODY, Traffic
from sim.traffic.troupe import Troupe
from sim.traffic.walking import walking

Progress = Callable[[float], float]
_LONGEST_IN_BENDS_M = 7.0
_TIGHT_1PM = 1 / 40


def build_traffic(
    config: TrafficConfig,
    network: Network,
    standing_m: Sequence[Array],
    progress_m: Progress,
    top_mps: float,
    seed: int,
) -> Traffic:
    """Draw the traffic of a street.

    Args:
        config: How much of it.
        network: Where it can be.
        standing_m: Outlines on the ground of what pedestrians walk round, each (K, 2) in world xy.
        progress_m: s of the route at which the driven car means to be; it falls when driving backwards.
        top_mps: Its highest speed.
        seed: Everything random follows from it.
    """
    if config.is_empty:
        return NOBODY
    vehicles = vehicle_models(seed) if config.cars else []
    platoon, own_lane = _own_lane(config, network, progress_m, top_mps, vehicles, seed)
    cars, driving = _cars(config, network, [platoon], vehicles, seed)
    bikes, riding = _cyclists(config, network, [platoon, cars], seed)
    walking_about = _pedestrians(config, network, standing_m, [platoon, cars, bikes], seed)
    return Traffic([own_lane, driving, riding, walking_about])


def _own_lane(
    config: TrafficConfig,
    network: Network,
    progress_m: Progress,
    top_mps: float,
    vehicles: Sequence[Model],
    seed: int,
) -> tuple[Platoon, Troupe]:
    route, rng = route_track(network), rng_for(seed, "traffic.own_lane")
    fit = [vehicles[k] for k in fit_for(route.speed_mps)] if vehicles else []
    models = [model for model in fit if model.length_m < _LONGEST_IN_BENDS_M]
    room_m = route.ring_m if route.closed else np.inf
    members = draw_members(config.cars, [model.length_m for model in models], room_m, top_mps, rng)
    if progress_m(1.0) < progress_m(0.0):
        members = []  # who backs up does so where the lane is free
    platoon = Platoon(route, progress_m, members)
    cast = [models[member.model] for member in members]
    troupe = Troupe(
        "car_own_lane",
        cast,
        [route],
        np.zeros(len(cast), np.int64),
        lambda time_s: (platoon.way_m(time_s), np.zeros(len(cast))),
        lambda now: rolling(now.way_m, now.curvature_1pm, cast),
        network.relief.road_height_m,
    )
    return platoon, troupe


def _cars(
    config: TrafficConfig, network: Network, above: Sequence[Movers], models: Sequence[Model], seed: int
) -> tuple[Flow, Troupe]:
    tracks = car_tracks(network)
    choices = [_fit_on(track, models) for track in tracks]
    entrants, chosen = draw_entrants("cars", tracks, CAR_SPACING_M, config.cars, models, choices, seed)
    pace = Pace(1.6, 2.0, 1.5, STEP_S, jam_share(config.cars))
    flow = Flow(tracks, entrants, above, pace)
    cast = [chosen[k] for k in flow.members]
    return flow, Troupe(
        "car",
        cast,
        tracks,
        flow.track,
        flow.at,
        lambda now: rolling(now.way_m, now.curvature_1pm, cast),
        network.relief.road_height_m,
    )


def _fit_on(track: Track, models: Sequence[Model]) -> list[int]:
    """Which models drive on a track."""
    fit = fit_for(track.speed_mps) if models else []
    return [k for k in fit if models[k].length_m < _LONGEST_IN_BENDS_M] if _is_tight(track) else fit


def _is_tight(track: Track) -> bool:
    """Whether a long vehicle would leave the lane in its curves."""
    s_m = track.path.start_m + np.arange(0.0, track.path.length_m)
    return bool(np.abs(track.path.curvature_1pm(s_m)).max() > _TIGHT_1PM)


def _cyclists(
    config: TrafficConfig, network: Network, above: Sequence[Movers], seed: int
) -> tuple[Flow, Troupe]:
    tracks = bike_tracks(network)
    models = rider_models(seed) if config.cyclists else []
    entrants, chosen = draw_entrants(
        "cyclists", tracks, CYCLIST_SPACING_M, config.cyclists, models, None, seed
    )
    flow = Flow(tracks, entrants, above, Pace(1.0, 1.6, 0.8, STEP_S))
    cast = [chosen[k] for k in flow.members]
    start = rng_for(seed, "traffic.cyclists.phase").random(len(chosen))[flow.members]
    return flow, Troupe(
        "cyclist",
        cast,
        tracks,
        flow.track,
        flow.at,
        lambda now: pedalling(now.way_m, start),
        network.relief.road_height_m,
    )


def _pedestrians(
    config: TrafficConfig,
    network: Network,
    standing_m: Sequence[Array],
    above: Sequence[Movers],
    seed: int,
) -> Troupe:
    tracks = foot_tracks(network, standing_m) if config.pedestrians else []
    models = walker_models(seed) if config.pedestrians else []
    entrants, chosen = draw_entrants(
        "pedestrians", tracks, PEDESTRIAN_SPACING_M, config.pedestrians, models, None, seed
    )
    flow = Flow(tracks, entrants, above, Pace(0.8, 1.2, 0.5, STEP_S))
    cast = [chosen[k] for k in flow.members]
    start = rng_for(seed, "traffic.pedestrians.phase").random(len(chosen))[flow.members]
    scale = np.array([model.scale for model in cast])
    return Troupe(
        "pedestrian",
        cast,
        tracks,
        flow.track,
        flow.at,
        lambda now: walking(now.way_m, now.speed_mps, scale, start),
        [ground_m(network, track) for track in tracks],
    )
