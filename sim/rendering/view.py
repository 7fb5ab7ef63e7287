"""What every renderer is asked for and gives: pinhole views of one instant, and pictures of them.

Renderers know pinholes only; lenses, shutters and sensors are made of their pictures in ``sim.sensing``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import TracebackType
from typing import Protocol, Self

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import SE3

RgbImage = npt.NDArray[np.uint8]
DepthImage = npt.NDArray[np.float32]

NEAR_M, FAR_M = 0.05, 300.0


@dataclass(frozen=True, eq=False)
class View:
    """A pinhole somewhere in the world.

    Attributes:
        pinhole: Its intrinsics; the principal point may lie anywhere, outside of the image too.
        world_from_cam: Its pose, in the optical frame (x right, y down, z forward).
    """

    pinhole: Camera
    world_from_cam: SE3


@dataclass(frozen=True, eq=False)
class Picture:
    """What a view shows.

    Attributes:
        rgb: (H, W, 3).
        depth_m: (H, W) distance along the optical axis, ``FAR_M`` for the sky; None unless asked for.
    """

    rgb: RgbImage
    depth_m: DepthImage | None = None


class Renderer(Protocol):
    """Turns the state of a world into pictures; a context manager, complete once constructed."""

    def render(
        self, data: mujoco.MjData, views: Mapping[str, View], depth: bool = False, keep_shadows: bool = False
    ) -> dict[str, Picture]:
        """Return each view's picture of this instant; positions in ``data`` are up to date.

        Args:
            data: State of the model the renderer was made for.
            views: By name; none larger than the renderer was made for.
            depth: Whether to measure depth as well.
            keep_shadows: Whether the sun's shadows may be those of the last call, where that saves time.
        """

    def __enter__(self) -> Self: ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...
