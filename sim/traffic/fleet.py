"""The models that take part in traffic, each drawn from a seed of its own."""

from __future__ import annotations

import numpy as np

from sim.paint.bicycle import paint_bicycle
from sim.paint.car_layout import BLACK_AT_M, WHEEL_AT_M, WHEEL_M
from sim.paint.car_layout import rect as car_rect
from sim.paint.heavy import region as heavy_region
from sim.paint.looks import draw_look
from sim.paint.people import paint_person
from sim.seeds import rng_for
from sim.shapes.bicycle import WHEELBASE_M, cranks_mesh, frame_mesh
from sim.shapes.bicycle import wheel_mesh as bicycle_wheel_mesh
from sim.shapes.heavy import BUS, TRUCK, HeavyKind, heavy_body
from sim.shapes.parked_cars import ESTATE, HATCH, OFF_ROADER, SEDAN, VAN, CarKind, body, outline_m
from sim.shapes.person import (
    foot_mesh,
    forearm_mesh,
    shin_mesh,
    thigh_mesh,
    trunk_mesh,
    upper_arm_mesh,
)
from sim.shapes.rider import rider_mesh
from sim.shapes.wheel import wheel_mesh
from sim.streets.scenery import Skin
from sim.traffic.model import Model, Part

CAR_KINDS: tuple[CarKind | HeavyKind, ...] = (
    *(HATCH, SEDAN, VAN, HATCH, SEDAN, TRUCK, HATCH, SEDAN, VAN, BUS),
    *(ESTATE, OFF_ROADER, HATCH, ESTATE, SEDAN, TRUCK, OFF_ROADER, VAN),
)
RIDERS, WALKERS = 7, 14
_HEAVY_WHEEL_M = 0.42
_TOWN_MPS, _HEAVY_MPS = 20.0, 26.0  # lanes driven faster than these see no town buses, and nothing heavy


def vehicle_models(seed: int) -> list[Model]:
    """Cars, vans, a truck and a bus: body, then rear left, rear right, front left and front right wheel."""
    return [
        _heavy(f"vehicle_{k}", kind, seed)
        if isinstance(kind, HeavyKind)
        else _car(f"vehicle_{k}", kind, seed)
        for k, kind in enumerate(CAR_KINDS)
    ]


def fit_for(speed_mps: float) -> list[int]:
    """Tell which of ``vehicle_models`` drive in a lane of this speed."""
    return [
        k
        for k, kind in enumerate(CAR_KINDS)
        if not isinstance(kind, HeavyKind) or speed_mps < (_TOWN_MPS if kind is BUS else _HEAVY_MPS)
    ]


def _car(name: str, kind: CarKind, seed: int) -> Model:
    mesh, skin = body(kind, rng_for(seed, f"traffic.{name}"))
    length, width = outline_m(kind)
    face = car_rect(WHEEL_AT_M, (2 * WHEEL_M, 2 * WHEEL_M))
    wheel = wheel_mesh(WHEEL_M, 0.2, face, car_rect(BLACK_AT_M, (0.5, 0.8)))
    parts: tuple[Part, ...] = (((mesh, name),), *([((wheel, name),)] * 4))
    rear, front = (x - length / 2 for x in kind.axles_m)
    return Model(name, parts, {name: skin}, length, (rear, front), WHEEL_M, width - 0.18)


def _heavy(name: str, kind: HeavyKind, seed: int) -> Model:
    mesh, skin = heavy_body(kind, rng_for(seed, f"traffic.{name}"))
    wheel = wheel_mesh(_HEAVY_WHEEL_M, 0.28, heavy_region("wheel"), heavy_region("black"))
    parts: tuple[Part, ...] = (((mesh, name),), *([((wheel, name),)] * 4))
    rear, front = (x - kind.length_m / 2 for x in kind.axles_m)
    return Model(name, parts, {name: skin}, kind.length_m, (rear, front), _HEAVY_WHEEL_M, kind.width_m - 0.27)


def rider_models(seed: int) -> list[Model]:
    """Cyclists, their parts in the order of ``sim.traffic.pedalling.PARTS``."""
    return [_rider(f"cyclist_{k}", rng_for(seed, f"traffic.cyclist_{k}")) for k in range(RIDERS)]


def _rider(name: str, rng: np.random.Generator) -> Model:
    look, broad, bike = draw_look(rng, rides=True), float(rng.uniform(0.92, 1.08)), f"{name}_bicycle"
    skins = {name: Skin(paint_person(look, rng)), bike: Skin(paint_bicycle(rng), specular=0.3)}
    frame: Part = ((frame_mesh(), bike), (rider_mesh(look, broad, rng), name))
    wheel: Part = ((bicycle_wheel_mesh(), bike),)
    legs: tuple[Part, ...] = tuple(
        ((mesh, name),) for mesh in (thigh_mesh(broad), shin_mesh(broad), foot_mesh())
    )
    parts = (frame, wheel, wheel, ((cranks_mesh(), bike),), *legs, *legs)
    half = WHEELBASE_M / 2
    return Model(name, parts, skins, 2 * half + 0.72, (-half, half))


def walker_models(seed: int) -> list[Model]:
    """Pedestrians, their parts in the order of ``sim.traffic.walking.PARTS``."""
    return [_walker(f"pedestrian_{k}", rng_for(seed, f"traffic.pedestrian_{k}")) for k in range(WALKERS)]


def _walker(name: str, rng: np.random.Generator) -> Model:
    look, broad, scale = draw_look(rng), float(rng.uniform(0.9, 1.14)), float(rng.uniform(0.92, 1.08))
    skin = Skin(paint_person(look, rng))
    limbs = (thigh_mesh(broad), shin_mesh(broad), foot_mesh(), upper_arm_mesh(broad), forearm_mesh(broad))
    meshes = (trunk_mesh(look, broad, rng), *limbs, *limbs)
    parts: tuple[Part, ...] = tuple(((mesh.scaled(scale), name),) for mesh in meshes)
    return Model(name, parts, {name: skin}, 0.5, (-0.15, 0.15), scale=scale)
