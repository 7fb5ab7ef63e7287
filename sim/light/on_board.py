"""The atmosphere as the cameras of one drive meet it: it asks how the car moves at each instant."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import mujoco

from sim.light.atmosphere import Atmosphere
from sim.light.channels import FloatImage
from sim.light.instant import Instant
from sim.light.mirror import Mirror
from sim.light.vehicles import vehicles_at
from sim.rendering.view import Picture, View
from sim.traffic.traffic import NOBODY, Traffic
from sim.vehicle.car_state import velocity_in_ego, world_from_ego


class OnBoardAtmosphere:
    """Fulfils ``sim.sensing.atmosphere.Atmosphere``; remembers only the instant asked for last.

    And what each camera sees mirrored in its present image.
    """

    def __init__(
        self,
        atmosphere: Atmosphere,
        model: mujoco.MjModel,
        at: Callable[[float], mujoco.MjData],
        traffic: Traffic = NOBODY,
    ) -> None:
        """``at`` gives the state of the world at a time (``Stage.at``); ``traffic`` has lamps too."""
        self._atmosphere, self._model, self._at, self._traffic = atmosphere, model, at, traffic
        self._instant: Instant | None = None
        self._mirrors: dict[str, Mirror] = {}

    @property
    def needs_depth(self) -> bool:
        """Whether ``light`` wants pictures with depth."""
        return self._atmosphere.needs_depth

    def around(self, views: Mapping[str, View]) -> dict[str, View]:
        """Return the views that ``look_around`` wants pictures of, with depth."""
        return self._atmosphere.around(views)

    def look_around(
        self, pictures: Sequence[Picture], views: Sequence[View], camera: str, time_s: float
    ) -> None:
        """Find what is mirrored in a camera's next image."""
        self._mirrors[camera] = self._atmosphere.mirror(pictures, views, self._moving(time_s))

    def light(self, picture: Picture, view: View, camera: str, time_s: float) -> FloatImage:
        """Return the (H, W) light of a picture; ``at`` has been asked for its time last."""
        return self._atmosphere.light(picture, view, self._moving(time_s), self._mirrors.get(camera))

    def cover(self, light: FloatImage, camera: str, time_s: float) -> FloatImage:
        """Return the (H, W) light of a camera's image with what is on its lens laid over it."""
        return self._atmosphere.cover(light, camera, time_s)

    def _moving(self, time_s: float) -> Instant:
        if self._instant is None or self._instant.time_s != time_s:
            data = self._at(time_s)
            pose = world_from_ego(data)
            velocity_mps = pose.rotation @ velocity_in_ego(self._model, data)[3:]
            lit = self._traffic if self._atmosphere.in_channels else NOBODY
            vehicles = vehicles_at(lit, time_s, pose.translation)
            self._instant = Instant(time_s, pose, velocity_mps, vehicles)
        return self._instant
