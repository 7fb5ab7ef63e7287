"""Settings that are each in range, and do not go together."""

from __future__ import annotations

from sim.light.weather import WeatherConfig
from sim.rendering.names import RendererName
from sim.sensing.sensor import SensorConfig
from sim.streets.street import StreetConfig
from sim.vehicle.drive import DriveConfig

STREET_MARGIN_M = 5.0  # of lane beyond the drive's end
CLIMBED_SHARE = 0.3  # of the grip: what the driven axle gives, less what it needs to speed up


def check_length(street: StreetConfig, drive: DriveConfig) -> None:
    """Refuse a drive that is longer than its street.

    Raises:
        ValueError: What was got and what was wanted, with the dotted path.
    """
    room_m = street.length_m - STREET_MARGIN_M
    if not street.is_closed and drive.distance_m > room_m:
        raise ValueError(
            f"drive.distance_m: got {drive.distance_m:g}, wanted over 0 to {room_m:g} where street.length_m "
            f"is {street.length_m:g}; it needs a street of at least {drive.distance_m + STREET_MARGIN_M:g} m"
        )


def check_slope(street: StreetConfig, drive: DriveConfig) -> None:
    """Refuse hills that the tyres cannot climb.

    Raises:
        ValueError: What was got and what was wanted, with the dotted path.
    """
    climbed_percent = 100 * CLIMBED_SHARE * drive.grip
    if street.slope_percent > climbed_percent + 1e-9:
        raise ValueError(
            f"street.slope_percent: got {street.slope_percent:g}, wanted 0 to {climbed_percent:g} where "
            f"drive.grip is {drive.grip:g}: its wheels would slip on anything steeper"
        )


def check_bumps(street: StreetConfig) -> None:
    """Refuse humps where nobody builds them.

    Raises:
        ValueError: What was got and what was wanted, with the dotted path.
    """
    if street.kind == "motorway" and street.speed_bumps > 0:
        raise ValueError(
            f"street.speed_bumps: got {street.speed_bumps:g}, wanted 0 where street.kind is motorway; "
            "street.roughness shakes the car there"
        )


def check_shutter(sensor: SensorConfig, drive: DriveConfig) -> None:
    """Refuse a shutter that still reads one image out when the next begins.

    Raises:
        ValueError: What was got and what was wanted, with the dotted path.
    """
    longest_s = 1.0 / drive.rate_hz
    if sensor.rolling_shutter_s > longest_s:
        raise ValueError(
            f"sensor.rolling_shutter_s: got {sensor.rolling_shutter_s:g}, wanted 0 to {longest_s:.3g} where "
            f"drive.rate_hz is {drive.rate_hz:g}: the next image begins before"
        )


def check_lamps(street: StreetConfig, weather: WeatherConfig, renderer: RendererName) -> None:
    """Refuse lamps in Filament: its tone mapping and highlights mix the channels (``sim.light.channels``).

    Raises:
        ValueError: What was got and what was wanted, with the dotted path.
    """
    lit = [key for key in ("dusk", "night") if getattr(weather, key) > 0]
    lit += ["tunnel"] if weather.tunnel > 0 and street.kind == "tunnel" else []
    if renderer == "filament" and lit:
        raise ValueError(
            f"renderer: got filament, which cannot draw the lamps of weather.{lit[0]} "
            f"{getattr(weather, lit[0]):g}; wanted classic or pyrender, or weather.{lit[0]}: 0"
        )
