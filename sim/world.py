"""The settings of a whole world, and what it yields at each instant."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Self

from pydantic import Field, field_validator, model_validator

from estimator.bundle import FrameBundle, Image
from estimator.config import Config
from estimator.se3 import SE3, Array
from sim.agreement import check_bumps, check_lamps, check_length, check_shutter, check_slope
from sim.channels.names import TruthChannel
from sim.faults.fault import Fault
from sim.faults.kinds import AnyFault
from sim.frame import Frame
from sim.light.contradictions import check_weather
from sim.light.weather import WeatherConfig
from sim.rendering.names import Quality, RendererName
from sim.sensing.sensor import SensorConfig
from sim.streets.street import StreetConfig
from sim.vehicle.car_sensors import CarSamples
from sim.vehicle.drive import DriveConfig
from sim.vehicle.inertial import InertialConfig
from sim.vehicle.miscalibration import MiscalibrationConfig

CLOCK_START_NS = 1_000_000_000  # stamp of the drive's time zero
if TYPE_CHECKING:  # it takes a whole world to make them
    from sim.channels.channels import Channels


class WorldConfig(Config):
    """Everything besides rig and seed that changes a recording."""

    street: StreetConfig = StreetConfig()
    drive: DriveConfig = DriveConfig()
    miscalibration: MiscalibrationConfig = MiscalibrationConfig()
    weather: WeatherConfig = WeatherConfig()
    sensor: SensorConfig = SensorConfig()
    inertial: InertialConfig | None = None
    faults: list[AnyFault] = Field([])
    renderer: RendererName = "classic"
    quality: Quality = "standard"
    truth: list[TruthChannel] = Field([])

    @field_validator("truth")
    @classmethod
    def _names_each_once(cls, truth: list[TruthChannel]) -> list[TruthChannel]:
        if len(set(truth)) < len(truth):
            raise ValueError(f"got {truth}, wanted each channel once")
        return truth

    @model_validator(mode="after")
    def _goes_together(self) -> Self:
        check_length(self.street, self.drive)
        check_slope(self.street, self.drive)
        check_bumps(self.street)
        check_shutter(self.sensor, self.drive)
        check_weather(self.street.kind, self.weather)
        check_lamps(self.street, self.weather, self.renderer)
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
    """What the cameras delivered of one instant, and the truth of it; only the recorder sees both.

    Attributes:
        truth: Exact, whatever became of the images.
        frames: Images exposed at the truth's instant, with what they say of themselves; a camera may have
            none, or several.
        faults: What is wrong at this instant.
        samples: What the car's other sensors have put out since the snapshot before.
        channels: Truth beyond poses, if any was asked for.
        bundle_count: How many snapshots the drive has in all; None if that is not known.
    """

    truth: Truth
    frames: tuple[Frame, ...]
    faults: tuple[Fault, ...] = ()
    samples: CarSamples = field(default_factory=CarSamples)
    bundle_count: int | None = None
    channels: Channels | None = None

    @staticmethod
    def taken(truth: Truth, images: Mapping[str, Image]) -> Snapshot:
        """Return a snapshot whose images arrive at once, rightly stamped."""
        stamp_ns = truth.stamp_ns
        return Snapshot(
            truth, tuple(Frame(name, stamp_ns, stamp_ns, image) for name, image in images.items())
        )

    @property
    def bundle(self) -> FrameBundle:
        """The images as one bundle of the true stamp; of a camera's several images the last one."""
        return FrameBundle(self.truth.stamp_ns, {frame.camera: frame.image for frame in self.frames})
