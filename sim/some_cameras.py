"""Settings that concern some of the rig's cameras: one, several, or all."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from pydantic import field_validator

from estimator.config import Config
from estimator.errors import InputError

ALL = "all"


class SomeCameras(Config):
    """What is said of ``camera``: one name, several, or ``all``."""

    camera: str | list[str]

    @field_validator("camera", mode="before")
    @classmethod
    def _is_a_name_or_several(cls, value: object) -> object:
        names = value if isinstance(value, list) else [value]
        if not names or not all(isinstance(name, str) and name for name in names):
            raise ValueError(f"got {value!r}, wanted the name of a camera, a list of names, or all")
        if len(set(names)) < len(names):
            raise ValueError(f"got {value!r}, wanted each camera once")
        return value

    @property
    def names(self) -> tuple[str, ...]:
        """The cameras as written; ``("all",)`` for all."""
        return (self.camera,) if isinstance(self.camera, str) else tuple(self.camera)

    def concerns(self, camera: str) -> bool:
        """Tell whether a camera is among them."""
        return ALL in self.names or camera in self.names


def check_names(key: str, several: Sequence[SomeCameras], cameras: Collection[str]) -> None:
    """Raise InputError where one of the list at ``key`` names a camera that is not among ``cameras``."""
    for index, each in enumerate(several):
        for name in each.names:
            if name not in (*cameras, ALL):
                raise InputError(
                    f"{key}[{index}].camera: got {name!r}, wanted a camera of the rig; "
                    f"there are: {', '.join(cameras)}, or all"
                )


def check_begins(key: str, at_s: float, end_s: float) -> None:
    """Raise InputError where what the list item at ``key`` says begins after the drive's end."""
    if at_s > end_s:
        raise InputError(f"{key}.at_s: got {at_s:g}, wanted 0 to {end_s:.2f}, when the drive ends")
