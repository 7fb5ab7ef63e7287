"""The car as MuJoCo parts: chassis, four sprung wheels, steering at the front, drive at the rear.

The chassis body's frame is the ego frame (x forward, y left, z up, under the rear axle). One invisible
ellipsoid a wheel touches the ground: a flat cylinder's edges would grip in curves. What is seen is in
``sim.vehicle.car_body``.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from sim.vehicle.car_body import write_body, write_wheel

GRAVITY_MPS2 = 9.81
HIDDEN_GROUP = 4  # geoms for contact only; never drawn
CHASSIS = "chassis"


@dataclass(frozen=True)
class CarConfig:
    """Sizes and stiffnesses of a compact family car; SI units."""

    wheelbase_m: float = 2.7
    track_m: float = 1.54
    wheel_radius_m: float = 0.32
    sprung_mass_kg: float = 1400.0
    wheel_mass_kg: float = 22.0
    mass_center_m: tuple[float, float, float] = (1.3, 0.0, 0.55)
    inertia_kgm2: tuple[float, float, float] = (500.0, 2000.0, 2300.0)
    spring_npm: float = 30_000.0
    damper_nspm: float = 2_600.0
    bump_travel_m: float = 0.09
    steer_limit_rad: float = 0.65

    @property
    def mass_kg(self) -> float:
        return self.sprung_mass_kg + 4 * self.wheel_mass_kg

    def wheel_position_m(self, wheel: str) -> tuple[float, float, float]:
        """Return the wheel's centre at rest, in the ego frame."""
        y_m = self.track_m / 2 if wheel.endswith("left") else -self.track_m / 2
        return (self.wheelbase_m if wheel in STEERED else 0.0, y_m, self.wheel_radius_m)

    def sprung_load_n(self, wheel: str) -> float:
        """Return the weight the wheel's spring carries at rest."""
        front_share = self.mass_center_m[0] / self.wheelbase_m
        share = front_share if wheel in STEERED else 1 - front_share
        return self.sprung_mass_kg * GRAVITY_MPS2 * share / 2


STEERED = ("front_left", "front_right")
DRIVEN = ("rear_left", "rear_right")
WHEELS = STEERED + DRIVEN


def write_car(spec: mujoco.MjSpec, config: CarConfig) -> mujoco.MjsBody:
    """Add the car to the world body; return the chassis, whose frame is the ego frame."""
    chassis = spec.worldbody.add_body(
        name=CHASSIS,
        mass=config.sprung_mass_kg,
        ipos=config.mass_center_m,
        inertia=config.inertia_kgm2,
        explicitinertial=True,
    )
    chassis.add_freejoint()
    write_body(spec, chassis)
    for wheel in WHEELS:
        _write_wheel(spec, chassis, wheel, config)
    return chassis


def write_ground(spec: mujoco.MjSpec) -> None:
    """Add the plane z = 0 the wheels roll on; it is not drawn."""
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 1], group=HIDDEN_GROUP, contype=1, conaffinity=1
    )


def _write_wheel(spec: mujoco.MjSpec, chassis: mujoco.MjsBody, wheel: str, config: CarConfig) -> None:
    carrier_kg = config.wheel_mass_kg / 4
    carrier = chassis.add_body(
        name=f"{wheel}_carrier",
        pos=config.wheel_position_m(wheel),
        mass=carrier_kg,
        ipos=[0, 0, 0],  # unset, MuJoCo takes the body's own position for it
        inertia=[0.1, 0.1, 0.1],
        explicitinertial=True,
    )
    carrier.add_joint(
        name=f"{wheel}_spring",
        type=mujoco.mjtJoint.mjJNT_SLIDE,
        axis=[0, 0, 1],
        stiffness=config.spring_npm,
        damping=config.damper_nspm,
        # The spring pushes the wheel down with its load while the slide is at zero.
        springref=-config.sprung_load_n(wheel) / config.spring_npm,
        range=[-config.bump_travel_m, config.bump_travel_m],
        limited=True,
    )
    if wheel in STEERED:
        _write_steering(spec, carrier, wheel, config)
    rim = carrier.add_body(
        name=f"{wheel}_wheel",
        mass=config.wheel_mass_kg - carrier_kg,
        ipos=[0, 0, 0],
        inertia=[0.5, 0.9, 0.5],
        explicitinertial=True,
    )
    rim.add_joint(name=f"{wheel}_spin", axis=[0, 1, 0], damping=0.05)
    rim.add_geom(
        type=mujoco.mjtGeom.mjGEOM_ELLIPSOID,
        size=[config.wheel_radius_m, 0.1, config.wheel_radius_m],
        group=HIDDEN_GROUP,
        friction=[1.0, 0.005, 0.0001],
        solref=[0.008, 1.0],
        solimp=[0.98, 0.995, 0.001, 0.5, 2.0],
        priority=1,
        contype=1,
        conaffinity=1,
    )
    write_wheel(rim, wheel, config.wheel_radius_m)
    if wheel in DRIVEN:
        motor = spec.add_actuator(
            name=f"{wheel}_motor", target=f"{wheel}_spin", trntype=mujoco.mjtTrn.mjTRN_JOINT
        )
        motor.set_to_motor()


def _write_steering(spec: mujoco.MjSpec, carrier: mujoco.MjsBody, wheel: str, config: CarConfig) -> None:
    limit_rad = config.steer_limit_rad
    carrier.add_joint(
        name=f"{wheel}_steer", axis=[0, 0, 1], range=[-limit_rad, limit_rad], limited=True, armature=1.0
    )
    servo = spec.add_actuator(
        name=f"{wheel}_servo", target=f"{wheel}_steer", trntype=mujoco.mjtTrn.mjTRN_JOINT
    )
    servo.set_to_position(kp=20_000.0, kv=600.0)


def ackermann_rad(steer_rad: float, config: CarConfig) -> tuple[float, float]:
    """Return the (left, right) wheel angles for a bicycle-model steering angle; left turns are positive."""
    curvature_pm = np.tan(steer_rad) / config.wheelbase_m
    half_m = config.track_m / 2
    left, right = (
        float(np.arctan(config.wheelbase_m * curvature_pm / (1 - side * half_m * curvature_pm)))
        for side in (1, -1)
    )
    return left, right
