"""The images of the report as data: small JPEGs with what is drawn on them, in pixels of the full image."""

from __future__ import annotations

import base64
from typing import Any

import cv2
import numpy as np

from eval.collect import RunLog
from eval.match_pictures import MatchPicture, Pair
from eval.mounting import is_left_of
from eval.thumbnails import Moment, Thumbnail

_JPEG_QUALITY = 80
_MAX_TAILS = 220
_MAX_LINES = 36


def moment_pictures(log: RunLog) -> list[dict[str, Any]]:
    """Return the kept moments, the one in the middle of the drive first."""
    moments = list(log.moments.moments)
    middle_ns = (log.first_stamp_ns + log.last_stamp_ns) // 2
    moments.sort(key=lambda moment: abs(moment.stamp_ns - middle_ns))
    ordered = moments[:1] + sorted(moments[1:], key=lambda moment: moment.stamp_ns)
    return [_moment(moment, log.first_stamp_ns) for moment in ordered]


def _moment(moment: Moment, first_ns: int) -> dict[str, Any]:
    cameras = {
        name: {
            **_picture(small),
            "tails": _tails(moment, name),
            "track_count": len(moment.tails_px.get(name, ())),
        }
        for name, small in moment.thumbnails.items()
    }
    return {"time_s": (moment.stamp_ns - first_ns) * 1e-9, "cameras": cameras}


def _tails(moment: Moment, camera: str) -> list[list[list[float]]]:
    tails = moment.tails_px.get(camera, ())
    kept = [tail for tail in tails if np.isfinite(tail).all()]
    return [np.round(tail, 1).tolist() for tail in kept[:: max(1, -(-len(kept) // _MAX_TAILS))]]


def match_pictures(log: RunLog) -> list[dict[str, Any]]:
    """Return one entry for each pair of cameras that shared landmarks, the pair with most matches first."""
    keeper = log.match_pictures
    totals = keeper.same_time_counts + keeper.later_counts
    ordered = sorted(totals.items(), key=lambda item: (-item[1], _rank(item[0], log)))
    return [_pair(pair, log) for pair, _ in ordered]


def _pair(pair: Pair, log: RunLog) -> dict[str, Any]:
    """Return counts and picture of a pair, the camera that looks further left first."""
    keeper = log.match_pictures
    first, second = (log.rig[name].ego_from_cam for name in pair)
    step = 1 if is_left_of(first, second) else -1
    counts = {"same_time_count": keeper.same_time_counts[pair], "later_count": keeper.later_counts[pair]}
    entry: dict[str, Any] = {"cameras": list(pair[::step]), **counts, "images": None}
    picture = keeper.pictures.get(pair)
    return entry if picture is None else entry | _match_picture(picture, log.first_stamp_ns, step)


def _match_picture(picture: MatchPicture, first_ns: int, step: int) -> dict[str, Any]:
    shown = picture.matches[:: max(1, -(-len(picture.matches) // _MAX_LINES))]
    ends = [(match.pixel_a, match.pixel_b)[::step] for match in shown]
    return {
        "images": [_picture(small) for small in picture.thumbnails[::step]],
        "times_s": [(stamp - first_ns) * 1e-9 for stamp in picture.stamps_ns[::step]],
        "match_count": len(picture.matches),
        "lines": [[*_rounded(left), *_rounded(right)] for left, right in ends],
    }


def _rank(pair: Pair, log: RunLog) -> tuple[int, ...]:
    names = tuple(log.rig.cameras)
    return tuple(names.index(name) for name in pair)


def _rounded(pixel: tuple[float, float]) -> list[float]:
    return [round(float(x), 1) for x in pixel]


def _picture(small: Thumbnail) -> dict[str, Any]:
    _, jpeg = cv2.imencode(".jpg", small.image, [cv2.IMWRITE_JPEG_QUALITY, _JPEG_QUALITY])
    return {"jpeg_base64": base64.b64encode(jpeg.tobytes()).decode(), "size_px": list(small.full_size_px)}
