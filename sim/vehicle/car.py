"""The car as MuJoCo parts: chassis, four sprung wheels, steering at the front, drive at the rear.

The chassis body's frame is the ego frame (x forward, y left, z up, under the rear axle). What is seen is in
``sim.vehicle.car_body``; what touches the ground is in ``sim.vehicle.car_physics``.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import mujoco
import numpy as np

from sim.vehicle.car_body import write_body, write_wheel
from sim.vehicle.tyre import TyreConfig

GRAVITY_MPS2 = 9.81
HIDDEN_GROUP = 4  # geoms for contact only; never drawn
CHASSIS = "chassis"
CHASSIS_JOINT = "chassis_free"


@dataclass(frozen=True)
class CarConfig:
    """Sizes and stiffnesses of a compact family car; SI units."""

    wheelbase_m: float = 2.7
    track_m: float = 1.54
    wheel_radius_m: float = 0.32
    tyre_width_m: float = 0.2
    sprung_mass_kg: float = 1400.0
    wheel_mass_kg: float = 22.0
    mass_center_m: tuple[float, float, float] = (1.3, 0.0, 0.55)
    inertia_kgm2: tuple[float, float, float] = (500.0, 2000.0, 2300.0)
    spring_npm: float = 22_000.0
    damper_nspm: float = 2_000.0
    roll_bar_npm: float = 15_000.0
    bump_travel_m: float = 0.09
    steer_limit_rad: float = 0.65
    imu_position_m: tuple[float, float, float] = (0.9, 0.0, 0.5)  # under the console
    tyre: TyreConfig = field(default_factory=TyreConfig)  # in front
    rear_tyre_share: float = 1.2  # stiffness of rear by front tyres: the car understeers

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

    def tyre_load_n(self, wheel: str) -> float:
        """Return the weight the wheel's tyre carries at rest."""
        return self.sprung_load_n(wheel) + self.wheel_mass_kg * GRAVITY_MPS2

    def tyre_share(self, wheel: str) -> float:
        """Return how many times stiffer than ``tyre`` the wheel's own is, in every direction."""
        return 1.0 if wheel in STEERED else self.rear_tyre_share

    def free_radius_m(self, wheel: str) -> float:
        """Return the radius of the tyre without load; ``wheel_radius_m`` is what the car's weight leaves."""
        return self.wheel_radius_m + self.tyre.deflection_m(self.tyre_load_n(wheel) / self.tyre_share(wheel))

    def rolling_radius_m(self, wheel: str) -> float:
        """Return the distance rolled by angle turned: half-way between the free and the loaded radius."""
        return (self.free_radius_m(wheel) + self.wheel_radius_m) / 2


STEERED = ("front_left", "front_right")
DRIVEN = ("rear_left", "rear_right")
WHEELS = STEERED + DRIVEN


def write_car(spec: mujoco.MjSpec, config: CarConfig) -> mujoco.MjsBody:
    """Add the car as it is seen to the world body; return the chassis, whose frame is the ego frame."""
    chassis = write_joints(spec, config)
    write_body(spec, chassis)
    for wheel in WHEELS:
        write_wheel(spec.body(f"{wheel}_wheel"), wheel, config.wheel_radius_m)
    return chassis


def write_joints(spec: mujoco.MjSpec, config: CarConfig) -> mujoco.MjsBody:
    """Add the bodies and joints of the car, without anything to see or to touch; return the chassis."""
    chassis = spec.worldbody.add_body(
        name=CHASSIS,
        mass=config.sprung_mass_kg,
        ipos=config.mass_center_m,
        inertia=config.inertia_kgm2,
        explicitinertial=True,
    )
    chassis.add_freejoint(name=CHASSIS_JOINT)
    for wheel in WHEELS:
        _write_wheel(chassis, wheel, config)
    return chassis


def _write_wheel(chassis: mujoco.MjsBody, wheel: str, config: CarConfig) -> None:
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
        limit_rad = config.steer_limit_rad
        carrier.add_joint(
            name=f"{wheel}_steer", axis=[0, 0, 1], range=[-limit_rad, limit_rad], limited=True, armature=1.0
        )
    rim = carrier.add_body(
        name=f"{wheel}_wheel",
        mass=config.wheel_mass_kg - carrier_kg,
        ipos=[0, 0, 0],
        inertia=[0.5, 0.9, 0.5],
        explicitinertial=True,
    )
    rim.add_joint(
        name=f"{wheel}_spin",
        axis=[0, 1, 0],
        damping=0.05,
        # Hard enough that a braked wheel does not creep.
        solimp_friction=[0.9999, 0.9999, 0.001, 0.5, 2.0],
    )


def ackermann_rad(steer_rad: float, config: CarConfig) -> tuple[float, float]:
    """Return the (left, right) wheel angles for a bicycle-model steering angle; left turns are positive."""
    curvature_pm = np.tan(steer_rad) / config.wheelbase_m
    half_m = config.track_m / 2
    left, right = (
        float(np.arctan(config.wheelbase_m * curvature_pm / (1 - side * half_m * curvature_pm)))
        for side in (1, -1)
    )
    return left, right
