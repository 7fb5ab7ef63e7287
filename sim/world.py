"""The settings of a whole world, and what it yields at each instant."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, Self

from pydantic import model_validator

from estimator.bundle import FrameBundle
from estimator.config import Config
from estimator.se3 import SE3, Array
from sim.light.weather import WeatherConfig
from sim.sensing.sensor import SensorConfig
from sim.streets.street import StreetConfig
from sim.vehicle.drive import DriveConfig
from sim.vehicle.miscalibration import MiscalibrationConfig

STREET_MARGIN_M = 5.0  # of lane beyond the drive's end


class WorldConfig(Config):
    """Everything besides rig and seed that changes a recording."""

    street: StreetConfig = StreetConfig()
    drive: DriveConfig = DriveConfig()
    miscalibration: MiscalibrationConfig = MiscalibrationConfig()
    weather: WeatherConfig = WeatherConfig()
    sensor: SensorConfig = SensorConfig()
    renderer: Literal["classic"] = "classic"

    @model_validator(mode="after")
    def _street_is_long_enough(self) -> Self:
        needed_m = self.drive.distance_m + STREET_MARGIN_M
        if self.street.length_m < needed_m:
            raise ValueError(
                f"street.length_m is {self.street.length_m:g}; "
                f"drive.distance_m {self.drive.distance_m:g} needs at least {needed_m:g}"
            )
        return self


@dataclass(frozen=True, eq=False)
class Truth:
    """The exact state at one bundle.

    Attributes:
        stamp_ns: Stamp of the bundle.
        world_from_ego: Pose of the car.
        velocity_ego: (6,) angular (rad/s) and linear (m/s) velocity in the ego frame.
        ego_from_cams: True extrinsics by camera.
    """

    stamp_ns: int
    world_from_ego: SE3
    velocity_ego: Array
    ego_from_cams: Mapping[str, SE3]


@dataclass(frozen=True, eq=False)
class Snapshot:
    """A bundle and the truth that belongs to it; only the recorder sees both."""

    bundle: FrameBundle
    truth: Truth
