"""Every kind of fault, in the order in which an image meets them on its way from lens to recorder."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from sim.faults.clock_faults import ClockOffset, Jitter
from sim.faults.fault import Fault
from sim.faults.image_faults import Black, Frozen, Overexposed, WrongResolution
from sim.faults.transport_faults import Dropped, Duplicated, Late, Off, Swapped
from sim.faults.wrong_intrinsics import WrongIntrinsics

WAY: tuple[type[Fault], ...] = (
    *(WrongIntrinsics, Overexposed, Black, Frozen, WrongResolution),
    *(ClockOffset, Jitter),
    *(Swapped, Off, Dropped, Duplicated, Late),
)

AnyFault = Annotated[
    WrongIntrinsics
    | Overexposed
    | Black
    | Frozen
    | WrongResolution
    | ClockOffset
    | Jitter
    | Swapped
    | Off
    | Dropped
    | Duplicated
    | Late,
    Field(discriminator="kind"),
]
