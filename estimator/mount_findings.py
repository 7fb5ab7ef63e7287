"""What is said of cameras whose images do not come from where the rig file mounts them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.finding import Finding, FindingKind
from estimator.whose_images import Fit


def swap(names: Sequence[str], cycle: tuple[int, ...], fit: Fit) -> Finding:
    """Return the finding that each camera of a cycle of places in ``names`` sits in the next one's socket."""
    swapped = [names[index] for index in cycle]
    said = "; ".join(
        f"{name} fits the mount of {other} ({fit.share[a, b]:.0%} of its tracks, its own "
        f"{fit.share[a, a]:.0%})"
        for name, other, a, b in zip(
            swapped, swapped[1:] + swapped[:1], cycle, (*cycle[1:], cycle[0]), strict=True
        )
    )
    about = f"plugged into each other's socket: {said}"
    return Finding(FindingKind.SWAPPED_CAMERAS, tuple(swapped), about)


def wrong_reference(name: str, reason: str) -> Finding:
    """Return the finding that the reference does not sit where the rig file says."""
    about = f"{name}, the reference, is not mounted as the rig file says, or not connected so: {reason}"
    return Finding(FindingKind.NOMINAL_REJECTED, (name,), about)


def unexplained(names: Sequence[str], index: int, fit: Fit) -> Finding:
    """Return the finding that no mount explains a camera's images."""
    name = names[index]
    others = np.delete(fit.share[index], index)
    about = (
        f"{name}: its nominal pose explains {fit.share[index, index]:.0%} of "
        f"{fit.total[index, index]:.0f} tracks, no other mount more than {others.max(initial=0.0):.0%}"
    )
    return Finding(FindingKind.UNEXPLAINED_IMAGES, (name,), about)


def untracked(name: str, windows: int) -> Finding:
    """Return the finding that a camera has images in which hardly anything can be followed."""
    about = f"{name}: hardly a corner in it could be followed over the last {windows} windows"
    return Finding(FindingKind.UNEXPLAINED_IMAGES, (name,), about)
