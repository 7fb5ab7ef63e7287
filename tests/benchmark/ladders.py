"""Do the severities lead one way? Every effect's ladder, measured on frames of one camera on several streets.

``python -m tests.benchmark.ladders [EFFECT ...] [--sheet FILE.jpg] [--table]`` drives down ``first_drive`` of
seeds 0, 1, 2 at 10 m/s without sensor noise, takes a frame every metre with the pinhole camera ``front`` at
every severity, and prints the means of the statistics of ``eval.likeness_statistics`` and of
``tests.benchmark.true_tracks``. ``+-`` is the largest standard error of a step from one severity to the next.
After a row, ``<`` says that it must rise and does, ``>`` that it must fall and does, ``=`` that it must stay
and does, ``REVERSES`` that it does otherwise, and ``-`` that nothing is asked of it. ``--table`` prints the
rows of the tables in the docs as well. Ends with status 1 if anything reverses.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path

import cv2
import numpy as np

from estimator.bundle import Image
from estimator.se3 import Array
from eval.likeness_statistics import statistics_of
from tests.benchmark.ladder_effects import EFFECTS, Effect
from tests.benchmark.ladder_rides import Ride, rides
from tests.benchmark.ladder_verdicts import REVERSES, standard_error, verdict
from tests.benchmark.true_tracks import shift_px, true_shares

SEEDS = (0, 1, 2)
IN_DOCS = {
    "mean_level": 0,
    "contrast_std": 0,
    "fast20_per_100kpx": 0,
    "gftt_per_100kpx": 0,
    "gradient_mean": 1,
    "textureless_share": 2,
    "klt_survival_1": 2,
    "klt_survival_5": 2,
    "true_share_1": 2,
    "true_share_5": 2,
    "shift_px": 2,
}  # columns of the tables in the docs, and their digits
_SIGNS = {"<": " \u2191", ">": " \u2193", "=": " =", "-": "", REVERSES: " **!**"}
_TILE_PX = (256, 160)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    names = [effect.name for effect in EFFECTS]
    parser.add_argument("effects", nargs="*", metavar="EFFECT", help=", ".join(names))
    parser.add_argument("--sheet", type=Path, help="draw the last frame of each severity there")
    parser.add_argument("--table", action="store_true", help="print the rows of the docs' tables")
    request = parser.parse_args()
    if unknown := set(request.effects) - set(names):
        parser.error(f"no effect {', '.join(sorted(unknown))}; there are: {', '.join(names)}")
    sheet, rows, reversals = [], [], 0
    for effect in EFFECTS:
        if not request.effects or effect.name in request.effects:
            values, last_frames = ladder(effect)
            reversals += report(effect, values)
            rows.append(table_row(effect, values))
            sheet.append(
                [labelled(frame, effect, v) for frame, v in zip(last_frames, effect.values, strict=True)]
            )
    if request.table:
        print("\n" + "\n".join(rows))
    if request.sheet:
        cv2.imwrite(
            str(request.sheet), np.vstack([np.hstack(row) for row in sheet]), [cv2.IMWRITE_JPEG_QUALITY, 85]
        )
    sys.exit(1 if reversals else 0)


def ladder(effect: Effect) -> tuple[dict[str, Array], list[Image]]:
    """Return (streets, severities) of every statistic, and the last frames of the first street."""
    of_streets, last_frames = [], []
    for seed in SEEDS:
        plain: Ride | None = None
        steps = []
        for ride in rides(effect, seed):
            plain = plain or ride
            steps.append(measured(ride, plain, effect))
            if seed == SEEDS[0]:
                last_frames.append(ride.frames[-1])
        of_streets.append(steps)
    values = {name: np.array([[s[name] for s in steps] for steps in of_streets]) for name in of_streets[0][0]}
    return values, last_frames


def measured(ride: Ride, plain: Ride, effect: Effect) -> dict[str, float]:
    """Return the mean of every statistic; ``plain`` is the ride without the effect."""
    window = (slice(*effect.rows), slice(*effect.columns))
    cut = [frame[window] for frame in ride.frames]
    of_light = {
        "mean_level": float(np.mean(cut)),
        "white_share": float(np.mean(np.array(cut) > 250)),
    }
    likeness = {name: float(values.mean()) for name, values in statistics_of(cut).items()}
    tracks = true_shares(ride, window) | {"shift_px": shift_px(plain, ride, window)}
    return of_light | likeness | tracks


def report(effect: Effect, values: Mapping[str, Array]) -> int:
    """Print one effect's table and return how many of its statistics reverse."""
    print(f"\n{effect.name}: {effect.why}")
    print(f"{'':<20}" + "".join(f"{value:>9g}" for value in effect.values) + f"{'+-':>9}")
    marks = {name: verdict(name, each, effect) for name, each in values.items()}
    for name, each in values.items():
        error = float(standard_error(np.diff(each, axis=1)).max())
        cells = "".join(f"{value:>9.{_digits(name)}f}" for value in (*each.mean(0), error))
        print(f"{name:<20}{cells}  {marks[name]}", flush=True)
    return list(marks.values()).count(REVERSES)


def table_row(effect: Effect, values: Mapping[str, Array]) -> str:
    """Return one effect's row of the table in the docs."""
    cells = [
        " ".join(f"{value:.{digits}f}" for value in values[name].mean(0))
        + _SIGNS[verdict(name, values[name], effect)]
        for name, digits in IN_DOCS.items()
    ]
    return f"| `{effect.name}` | {' | '.join(cells)} |"


def _digits(name: str) -> int:
    return 1 if name in ("mean_level", "gradient_mean", "contrast_std") or "per_100kpx" in name else 2


def labelled(image: Image, effect: Effect, value: float) -> Image:
    """Return a small copy that says what it shows."""
    small = cv2.resize(image, _TILE_PX, interpolation=cv2.INTER_AREA)
    for level, width in ((0, 3), (255, 1)):
        cv2.putText(
            small,
            f"{effect.name} {value:g}",
            (5, 14),
            cv2.FONT_HERSHEY_SIMPLEX,
            0.42,
            level,
            width,
            cv2.LINE_AA,
        )
    return np.asarray(small, np.uint8)


if __name__ == "__main__":
    main()
