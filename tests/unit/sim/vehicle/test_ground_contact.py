"""Wheels on slopes, humps and rough roads: where the car stands and what it takes to climb."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from sim.seeds import rng_for
from sim.streets.relief import Relief, draw_hills, draw_roughness
from sim.vehicle.car import GRAVITY_MPS2
from sim.vehicle.drive import DriveConfig
from tests.drives import CAR, STRAIGHT, Ramp, drive


@pytest.mark.parametrize("slope", [0.05, 0.15, -0.1])
def test_a_slope_needs_the_torque_that_gravity_asks_for(slope: float) -> None:
    motion, seen = drive(DriveConfig(speed_mps=6.0, distance_m=70.0), road=Ramp(slope))
    angle_rad = np.arctan(slope)
    assert -seen[-1].pitch_deg == pytest.approx(np.degrees(angle_rad), abs=0.7)  # it squats a little
    model, data = motion.model, motion._data
    push_n, load_n = 0.0, 0.0
    for index in range(data.ncon):
        force = np.zeros(6)
        mujoco.mj_contactForce(model, data, index, force)
        load_n += force[0] / np.cos(angle_rad)
        frame = data.contact[index].frame.reshape(3, 3)
        push_n += (frame.T @ force[:3])[0]
    assert load_n == pytest.approx(CAR.mass_kg * GRAVITY_MPS2, rel=0.02)
    assert push_n == pytest.approx(0.0, abs=0.01 * CAR.mass_kg * GRAVITY_MPS2)  # nothing else pushes along x
    torque_nm = data.ctrl[-2:].sum() - model.dof_frictionloss.sum()  # motors and brakes
    wanted_nm = CAR.mass_kg * GRAVITY_MPS2 * np.sin(angle_rad) * CAR.wheel_radius_m
    assert torque_nm == pytest.approx(wanted_nm, rel=0.06)


def test_rides_on_the_road_wherever_it_is() -> None:
    road = Ramp(slope=0.1)
    _, seen = drive(DriveConfig(speed_mps=5.0, distance_m=60.0), road=road)
    for each in seen:
        x, y, z = each.world_from_ego.translation
        # The chord of the wheelbase, and what the rear springs give way.
        assert z == pytest.approx(float(road.road_height_m(np.array([x, y]))), abs=0.02)


@pytest.mark.parametrize("speed_mps", [0.5, 10.0, 25.0])
def test_goes_over_a_hump_with_the_front_first_and_settles(speed_mps: float) -> None:
    config = DriveConfig(speed_mps=speed_mps, distance_m=27.0 + 4 * speed_mps)
    _, seen = drive(config, road=Ramp(hump_m=0.07), every_s=0.02)
    pitches = [each.pitch_deg for each in seen]
    lowest, highest = int(np.argmin(pitches)), int(np.argmax(pitches))
    assert pitches[lowest] < -0.1 and pitches[highest] > 0.1
    assert seen[lowest].world_from_ego.translation[0] < 25.0 + speed_mps / 2
    assert abs(pitches[-1]) < 0.05
    if speed_mps == 0.5:  # the rear axle is lifted by nearly the whole hump
        assert max(each.world_from_ego.translation[2] for each in seen) == pytest.approx(0.07, abs=0.012)


def test_no_wheel_ever_sinks_into_a_rough_road_or_leaves_it_for_long() -> None:
    rng = rng_for(1, "test")
    relief = Relief(draw_hills(8.0, STRAIGHT.points_m[:800], rng), draw_roughness(2.0, rng))
    motion, _ = drive(DriveConfig(speed_mps=10.0, distance_m=0.1), road=relief)
    data = motion._data
    touching, deepest_m = 0, 0.0
    for step in range(3000):
        motion.state_at(step * 0.002)
        touching += data.ncon == 4
        deepest_m = max([deepest_m, *(-data.contact[index].dist for index in range(data.ncon))])
    assert touching > 2950
    assert deepest_m < 0.04


def test_without_hills_the_ground_is_the_plane_itself() -> None:
    flat = drive(DriveConfig(distance_m=10.0), road=Ramp())[1][-1].state
    plane = drive(DriveConfig(distance_m=10.0))[1][-1].state
    np.testing.assert_allclose(flat.qpos[:7], plane.qpos[:7], atol=1e-9)


def test_a_stopped_car_stays_on_a_hill() -> None:
    motion, seen = drive(DriveConfig(speed_mps=4.0, distance_m=60.0, profile="stop_and_go"), road=Ramp(0.12))
    still = [each for each in seen if each.time_s > 8 and motion.plan.speed_mps(each.time_s) == 0.0]
    stops = np.split(
        np.array(still, dtype=object), np.flatnonzero(np.diff([s.time_s for s in still]) > 1) + 1
    )
    assert len(stops) >= 2
    for stop in stops:
        settled = stop[8:]
        moved_m = settled[-1].world_from_ego.translation - settled[0].world_from_ego.translation
        assert np.linalg.norm(moved_m) < 0.002
