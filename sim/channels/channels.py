"""The truth channels of one bundle, and what makes them while the world drives by."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from types import TracebackType
from typing import Self

import numpy as np
import numpy.typing as npt

from sim.channels.flow import FlowImage, flow_px
from sim.channels.labels import Labels, label_geoms
from sim.channels.names import TruthChannel
from sim.channels.survey import Survey, Surveyor
from sim.channels.visibility import visibility
from sim.rendering.geom_picture import GeomRenderer
from sim.rendering.view import DepthImage
from sim.scene import Scene
from sim.stage import Stage


@dataclass(frozen=True, eq=False)
class Channels:
    """What was asked for of one bundle; what was not is empty.

    Attributes:
        labels: What the numbers in the segmentation mean.
        range_m: (H, W) by camera: distance along each pixel's ray, infinite for the sky.
        classes: (H, W) by camera: index into ``sim.channels.labels.CLASSES``.
        instances: (H, W) by camera: index into the labels' ``instance_names``.
        flow_px: (H, W, 2) by camera: motion until the next bundle, NaN where it cannot be seen; empty for the
            last bundle.
        visibility: By camera and other camera: share of the first's pixels whose place the other sees too.
    """

    labels: Labels
    range_m: Mapping[str, DepthImage]
    classes: Mapping[str, npt.NDArray[np.uint8]]
    instances: Mapping[str, npt.NDArray[np.uint16]]
    flow_px: Mapping[str, FlowImage]
    visibility: Mapping[str, Mapping[str, float]]


class ChannelMaker:
    """Makes the channels of bundle after bundle; opens OpenGL only if some are wanted."""

    def __init__(self, wanted: Collection[TruthChannel], scene: Scene) -> None:
        """Take which channels to make of which world.

        Raises:
            InputError: This machine has no OpenGL, and some channel is wanted.
        """
        self._wanted = frozenset(wanted)
        self._renderer = GeomRenderer(scene.model) if wanted else None
        self._labels = label_geoms(scene.model)
        self._surveyor = Surveyor(scene.true_cameras, scene.lenses) if wanted else None
        self._survey: Survey | None = None

    def at(self, stage: Stage, time_s: float, next_s: float | None) -> Channels | None:
        """Return the channels of one instant; may move the stage on to the next bundle's.

        Args:
            stage: The world.
            time_s: Middle of the bundle's exposure, whatever the shutter.
            next_s: That of the next bundle; None if this is the last.
        """
        if not self._wanted:
            return None
        now = self._survey_of(stage, time_s)
        later = (
            self._survey_of(stage, next_s) if next_s is not None and "optical_flow" in self._wanted else None
        )
        self._survey = later
        names = list(now.sights)
        depths = names if "depth" in self._wanted else []
        segments = names if "segmentation" in self._wanted else []
        shaped = {name: now.sights[name].geom.reshape(_shape(now, name)) for name in segments}
        return Channels(
            self._labels,
            {name: now.sights[name].range_m.reshape(_shape(now, name)).astype(np.float32) for name in depths},
            {name: self._labels.classes(shaped[name]) for name in segments},
            {name: self._labels.instances(shaped[name]) for name in segments},
            {name: flow_px(now, later, name) for name in names} if later is not None else {},
            visibility(now, self._labels) if "visibility" in self._wanted else {},
        )

    def _survey_of(self, stage: Stage, time_s: float) -> Survey:
        if self._survey is not None and self._survey.time_s == time_s:
            return self._survey
        assert self._renderer is not None and self._surveyor is not None
        return self._surveyor.survey(self._renderer, stage.at(time_s), time_s)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._renderer is not None:
            self._renderer.close()


def _shape(survey: Survey, name: str) -> tuple[int, int]:
    width, height = survey.sights[name].camera.size_px
    return height, width
