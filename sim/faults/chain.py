"""All faults of a drive, one seeded stage each, between the cameras and the recorder."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from sim.faults.fault import Fault
from sim.faults.kinds import WAY
from sim.frame import Frame
from sim.seeds import rng_for
from sim.some_cameras import check_names


@dataclass
class FaultStage:
    """One fault at work; remembers each camera's last sound frame."""

    fault: Fault
    seed: int
    _sound: dict[str, Frame] = field(default_factory=dict)

    def pass_on(self, frames: Iterable[Frame], index: int, time_s: float) -> Iterator[Frame]:
        """Yield what is left of the frames of bundle ``index``, exposed ``time_s`` into the drive."""
        lasts = self.fault.lasts(time_s)
        for frame in frames:
            if not self.fault.concerns(frame.camera):
                yield frame
            elif lasts:
                sound = self._sound.setdefault(frame.camera, frame)
                # The list's order and the fault's settings are no part of the purpose: other faults may come
                # and go, and a probability turned up drops the same frames and more.
                purpose = f"fault.{self.fault.kind}.{frame.camera}.{index}"
                yield from self.fault.spoil(frame, sound, rng_for(self.seed, purpose))
            else:
                self._sound[frame.camera] = frame
                yield frame


class FaultChain:
    """Spoils the frames of a drive, bundle by bundle."""

    def __init__(self, faults: Sequence[Fault], cameras: Iterable[str], seed: int) -> None:
        """Take the faults in any order; raises InputError for a camera that the rig does not have."""
        check_cameras(faults, cameras)
        on_their_way = sorted(faults, key=lambda fault: WAY.index(type(fault)))
        self._stages = [FaultStage(fault, seed) for fault in on_their_way]

    def pass_on(self, frames: Iterable[Frame], index: int, time_s: float) -> tuple[Frame, ...]:
        """Return what reaches the recorder of the frames of bundle ``index``, whenever it arrives."""
        for stage in self._stages:
            frames = tuple(stage.pass_on(frames, index, time_s))
        return tuple(frames)

    def lasting(self, time_s: float) -> tuple[Fault, ...]:
        """Return the faults that are there at an instant of the drive."""
        return tuple(stage.fault for stage in self._stages if stage.fault.lasts(time_s))


def check_cameras(faults: Sequence[Fault], cameras: Iterable[str]) -> None:
    """Raise InputError where a fault names a camera that is not among ``cameras``."""
    check_names("faults", faults, tuple(cameras))
