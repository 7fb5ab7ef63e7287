"""What is said of cameras that do not sit any more where they did."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from estimator.belief import Belief
from estimator.finding import Finding, FindingKind


def contradicted(name: str, before: Belief, now: Belief) -> Finding:
    """Return the finding that the newest window denies what was known of a camera."""
    about = f"{name}: the newest window puts it {_apart(name, before, now)} from where all before it did"
    return Finding(FindingKind.CONTRADICTED, (name,), about)


def moved(name: str, before: Belief, now: Belief, stamp_ns: int) -> Finding:
    """Return the finding that a camera has moved on the car, as two windows in a row agree.

    Args:
        name: The camera.
        before: Where it was known to be.
        now: Where it is.
        stamp_ns: When the first of the two windows began.
    """
    about = (
        f"{name} moved on the car by {_apart(name, before, now)} at about {stamp_ns * 1e-9:.1f} s; "
        "its pose is known from what came after that alone"
    )
    return Finding(FindingKind.MOVED_CAMERA, (name,), about, doubtful=False)


def all_at_once(reference: str, names: Collection[str], count: int) -> Finding:
    """Return the finding that most cameras seem to have moved, so rather the reference has."""
    about = (
        f"{len(names)} of the {count} others seem to have moved at once against {reference}, the reference: "
        "rather it has moved itself, or the car is not as it was"
    )
    return Finding(FindingKind.CONTRADICTED, (reference,), about)


def _apart(name: str, one: Belief, other: Belief) -> str:
    step = one.rig[name].ego_from_cam.local(other.rig[name].ego_from_cam)
    return f"{np.rad2deg(np.linalg.norm(step[:3])):.2f} deg and {1000 * np.linalg.norm(step[3:]):.0f} mm"
