"""Pick landmarks that two cameras share, so that people can see what ties the rig together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.estimate import Match
from estimator.observations import Observations

_PER_PAIR = 40


def cross_camera_matches(
    seen: Observations, names: Sequence[str], stamps_ns: Sequence[int]
) -> tuple[Match, ...]:
    """Return up to forty matches for each pair of cameras, spread over the landmarks they share."""
    order = np.lexsort((seen.keyframe, seen.landmark))
    seen = seen.select(order)
    _, start = np.unique(seen.landmark, return_index=True)
    by_pair: dict[tuple[int, int], list[Match]] = {}
    for rows in np.split(np.arange(len(seen)), start[1:]):
        owners = rows[~seen.handed_over[rows]]
        guests = rows[seen.handed_over[rows]]
        if len(owners) == 0:
            continue
        for guest in guests:
            owner = owners[np.argmin(np.abs(seen.keyframe[owners] - seen.keyframe[guest]))]
            pair = (int(seen.camera[owner]), int(seen.camera[guest]))
            by_pair.setdefault(pair, []).append(_match(seen, int(owner), int(guest), names, stamps_ns))
    chosen: list[Match] = []
    for matches in by_pair.values():
        pick = np.unique(np.linspace(0, len(matches) - 1, min(_PER_PAIR, len(matches))).astype(int))
        chosen.extend(matches[i] for i in pick)
    return tuple(chosen)


def _match(
    seen: Observations, owner: int, guest: int, names: Sequence[str], stamps_ns: Sequence[int]
) -> Match:
    a, b = seen.pixels[owner], seen.pixels[guest]
    return Match(
        names[seen.camera[owner]],
        stamps_ns[seen.keyframe[owner]],
        (float(a[0]), float(a[1])),
        names[seen.camera[guest]],
        stamps_ns[seen.keyframe[guest]],
        (float(b[0]), float(b[1])),
    )
