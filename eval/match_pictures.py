"""The best picture of each pair of cameras that saw the same landmarks, kept while a drive runs.

Matches may join two instants, so small images of the last bundles are held, bounded in bytes.
"""

from __future__ import annotations

import math
from collections import Counter, OrderedDict, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from estimator.estimate import Match
from eval.thumbnails import Thumbnail

_RECENT_BYTES = 64_000_000
Pair = tuple[str, str]


@dataclass(frozen=True, eq=False)
class MatchPicture:
    """Two images and the matches between them; ``matches`` all run from the first camera to the second."""

    stamps_ns: tuple[int, int]
    thumbnails: tuple[Thumbnail, Thumbnail]
    matches: tuple[Match, ...]


class MatchPictureKeeper:
    """Counts matches by camera pair and keeps, for each pair, the image pair with the most."""

    def __init__(self, camera_order: Sequence[str]) -> None:
        self._rank = {name: rank for rank, name in enumerate(camera_order)}
        self._recent: OrderedDict[int, Mapping[str, Thumbnail]] = OrderedDict()
        self._recent_bytes = 0
        self.pictures: dict[Pair, MatchPicture] = {}
        self.same_time_counts: Counter[Pair] = Counter()
        self.later_counts: Counter[Pair] = Counter()

    def remember(self, stamp_ns: int, thumbnails: Mapping[str, Thumbnail]) -> None:
        """Hold the images of a bundle until newer ones need the room."""
        self._recent[stamp_ns] = thumbnails
        self._recent_bytes += _byte_count(thumbnails)
        while self._recent_bytes > _RECENT_BYTES and len(self._recent) > 1:
            _, oldest = self._recent.popitem(last=False)
            self._recent_bytes -= _byte_count(oldest)

    def offer(self, matches: Sequence[Match]) -> None:
        """Take the matches of one update; within a camera, without one in the rig, or nowhere is no link."""
        groups: dict[tuple[Pair, tuple[int, int]], list[Match]] = defaultdict(list)
        for match in matches:
            if match.camera_a == match.camera_b or not {match.camera_a, match.camera_b} <= self._rank.keys():
                continue
            if not all(map(math.isfinite, (*match.pixel_a, *match.pixel_b))):
                continue
            ordered = self._ordered(match)
            pair = ordered.camera_a, ordered.camera_b
            stamps = ordered.stamp_a_ns, ordered.stamp_b_ns
            groups[pair, stamps].append(ordered)
            (self.same_time_counts if stamps[0] == stamps[1] else self.later_counts)[pair] += 1
        for (pair, stamps), group in groups.items():
            self._keep_if_best(pair, stamps, group)

    def _ordered(self, match: Match) -> Match:
        if self._rank[match.camera_a] < self._rank[match.camera_b]:
            return match
        return Match(
            camera_a=match.camera_b,
            stamp_a_ns=match.stamp_b_ns,
            pixel_a=match.pixel_b,
            camera_b=match.camera_a,
            stamp_b_ns=match.stamp_a_ns,
            pixel_b=match.pixel_a,
        )

    def _keep_if_best(self, pair: Pair, stamps: tuple[int, int], group: list[Match]) -> None:
        best = self.pictures.get(pair)
        if best is not None and len(best.matches) >= len(group):
            return
        first = self._recent.get(stamps[0], {}).get(pair[0])
        second = self._recent.get(stamps[1], {}).get(pair[1])
        if first is not None and second is not None:
            self.pictures[pair] = MatchPicture(stamps, (first, second), tuple(group))


def _byte_count(thumbnails: Mapping[str, Thumbnail]) -> int:
    return sum(small.image.nbytes for small in thumbnails.values())
