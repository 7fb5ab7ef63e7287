"""One look into a scenario: the images of a few cameras at one telling instant."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import closing, suppress
from dataclasses import dataclass
from itertools import islice

import cv2
import numpy as np

from estimator.bundle import Image
from estimator.errors import InputError
from eval.mosaic import rows_of
from scenarios.load import load_scenario
from scenarios.scenario import Scenario
from sim.faults.fault import PassingFault
from sim.some_cameras import SomeCameras

_CAMERAS = 3
_GREY = 128
_MOST_PX = 640  # of width: a sheet shows nothing larger
_RATE_HZ = 1.0  # few pictures on the way there


@dataclass(frozen=True, eq=False)
class Glimpse:
    """What a scenario looks like.

    Attributes:
        scenario: Its name.
        about: Its sentence.
        images: By camera, the reference first; a camera that delivered nothing is absent.
        cameras: The cameras that were asked.
    """

    scenario: str
    about: str
    images: Mapping[str, Image]
    cameras: tuple[str, ...]


def take_glimpse(name: str) -> Glimpse:
    """Drive a scenario, seed 0, up to its telling instant, with few pictures on the way.

    Where this machine lacks the scenario's renderer there is nothing to see.
    """
    from sim.simulate import simulate  # loads the graphics library

    scenario = load_scenario(name)
    drive = scenario.world.drive.model_copy(update={"rate_hz": _RATE_HZ})
    world = scenario.world.model_copy(update={"drive": drive})
    count = min(drive.bundle_count, 1 + round(_telling_s(scenario) * _RATE_HZ))
    seen: Mapping[str, Image] = {}
    with closing(simulate(world, scenario.rig, 0)) as snapshots, suppress(InputError):
        for snapshot in islice(snapshots, count):
            seen = snapshot.bundle.images
    cameras = telling_cameras(scenario)
    images = {
        camera: _reduced(_at_size(seen[camera], scenario.rig[camera].camera.size_px[0]))
        for camera in cameras
        if camera in seen
    }
    return Glimpse(scenario.name, scenario.about, images, cameras)


def telling_cameras(scenario: Scenario) -> tuple[str, ...]:
    """Return three cameras: the reference, those that something happens to, leftmost, looking back."""
    rig, world = scenario.rig, scenario.world
    rows = rows_of(rig)
    rear = rows[-1][len(rows[-1]) // 2]
    happenings: list[SomeCameras] = [*world.faults, *world.miscalibration.events]
    struck = [name for name in rig.cameras if any(name in each.names for each in happenings)]
    return tuple(dict.fromkeys((rig.reference, *struck, rows[0][0], rear)))[:_CAMERAS]


def _telling_s(scenario: Scenario) -> float:
    """Return a second after the last change that a fault brings, else a few seconds into the drive."""
    drive = scenario.world.drive
    end_s = drive.time_s(drive.bundle_count - 1)
    begins_s = [fault.at_s for fault in scenario.world.faults if isinstance(fault, PassingFault)]
    begins_s += [event.at_s for event in scenario.world.miscalibration.events]
    return min(max([3.0, *(at_s + 1.0 for at_s in begins_s)]), end_s)


def _at_size(image: Image, width_px: int) -> Image:
    """Return the image; one smaller than its camera's, in the corner of as much grey as is missing."""
    factor = width_px / image.shape[1]
    if factor <= 1:
        return image
    canvas = np.full((round(image.shape[0] * factor), width_px, *image.shape[2:]), _GREY, np.uint8)
    canvas[: image.shape[0], : image.shape[1]] = image
    return canvas


def _reduced(image: Image) -> Image:
    if image.shape[1] <= _MOST_PX:
        return image
    size = _MOST_PX, max(1, round(image.shape[0] * _MOST_PX / image.shape[1]))
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)
