"""What an estimator noticed that a user should know: which camera, what kind of trouble, and the evidence."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class FindingKind(StrEnum):
    """What may be wrong, with the recording, the rig file or a camera."""

    NO_IMAGE = "no_image"
    NO_TEXTURE = "no_texture"
    FROZEN_IMAGE = "frozen_image"
    SWAPPED_CAMERAS = "swapped_cameras"
    CLOCK_OFFSET = "clock_offset"
    WRONG_INTRINSICS = "wrong_intrinsics"
    NOMINAL_REJECTED = "nominal_rejected"
    NO_MOTION = "no_motion"
    UNEXPLAINED_IMAGES = "unexplained_images"
    UNSOLVED_WINDOWS = "unsolved_windows"
    CONTRADICTED = "contradicted"
    MOVED_CAMERA = "moved_camera"


@dataclass(frozen=True)
class Finding:
    """One thing noticed, as it stands now.

    Attributes:
        kind: What it is.
        cameras: The cameras it concerns.
        about: One sentence with the numbers it rests on, for people.
        doubtful: Whether the poses of these cameras are not to be relied on because of it.
    """

    kind: FindingKind
    cameras: tuple[str, ...]
    about: str
    doubtful: bool = True
