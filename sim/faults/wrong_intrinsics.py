"""A lens that is not what the rig file says: images come through the true one, all else believes the file."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.rig import MountedCamera, Rig
from sim.faults.fault import Fault
from sim.frame import Frame
from sim.sensing.lens import check_lens

Shift = Annotated[float, Field(ge=-200.0, le=200.0)]


class WrongIntrinsics(Fault):
    """The true focal length and principal point are off from the file's by these amounts, all drive long."""

    kind: Literal["wrong_intrinsics"]
    focal_percent: float = Field(1.0, ge=-50.0, le=50.0)
    center_px: list[Shift] = Field([0.0, 0.0], min_length=2, max_length=2)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        """Change nothing: the images were taken through the true lens."""
        return (frame,)

    def true_camera(self, stated: Camera) -> Camera:
        """Return the camera that takes the images."""
        (fx, fy), (cx, cy) = stated.focal_px, stated.center_px
        factor = 1 + self.focal_percent / 100
        return replace(
            stated,
            focal_px=(fx * factor, fy * factor),
            center_px=(cx + self.center_px[0], cy + self.center_px[1]),
        )


def check_true_lenses(stated: Rig, faults: Sequence[Fault]) -> None:
    """See that the lenses the cameras really have can be simulated.

    Raises:
        InputError: A fault makes one fold over inside its image.
    """
    for index, fault in enumerate(faults):
        for name, mounted in stated.cameras.items():
            if isinstance(fault, WrongIntrinsics) and fault.concerns(name):
                try:
                    check_lens(fault.true_camera(mounted.camera))
                except InputError as error:
                    raise InputError(f"faults[{index}]: of camera {name} it makes {error}") from None


def with_true_lenses(stated: Rig, faults: Iterable[Fault]) -> Rig:
    """Return the rig with the intrinsics that its cameras really have."""
    cameras = dict(stated.cameras)
    for fault in faults:
        if isinstance(fault, WrongIntrinsics):
            for name, mounted in cameras.items():
                if fault.concerns(name):
                    cameras[name] = MountedCamera(fault.true_camera(mounted.camera), mounted.ego_from_cam)
    return replace(stated, cameras=cameras)
