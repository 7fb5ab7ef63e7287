"""How long each stretch of a drive came out, beside how hard the car braked or turned on it.

``python -m tests.benchmark.stretch_scale RUN_FOLDER...`` compares the path of a run with the true one, ten
metres at a time: what acceleration costs in scale.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from estimator.se3 import SE3, Array
from estimator.stance import acceleration_mps2

_STRETCH_M = 10.0
_STEP_M = 0.8  # between the poses that accelerations are taken from


@dataclass(frozen=True)
class Stretch:
    """One stretch of a drive; the error is of the estimated length, positive if it is too long."""

    from_m: float
    to_m: float
    acceleration_mps2: float
    error_percent: float


def stretches(true: Array, found: Array) -> Iterator[Stretch]:
    """Yield stretch by stretch.

    Args:
        true: (N, 8) rows of a TUM file: seconds, xyz, quaternion xyzw.
        found: (M, 8) the estimate's.
    """
    stamps = np.intersect1d(true[:, 0], found[:, 0])
    true, found = (rows[np.searchsorted(rows[:, 0], stamps)] for rows in (true, found))
    steps_m = [np.linalg.norm(np.diff(rows[:, 1:4], axis=0), axis=1) for rows in (true, found)]
    driven_m = np.r_[0.0, np.cumsum(steps_m[0])]
    kept = np.unique(np.searchsorted(driven_m, np.arange(0.0, driven_m[-1], _STEP_M)))
    poses = [SE3.from_quaternion_xyzw(row[4:], row[1:4]) for row in true[kept]]
    felt_mps2 = acceleration_mps2(poses, (1e9 * stamps[kept]).astype(np.int64).tolist())
    for start_m in np.arange(0.0, driven_m[-1] - 0.5 * _STRETCH_M, _STRETCH_M):
        within = (driven_m[1:] > start_m) & (driven_m[1:] <= start_m + _STRETCH_M)
        here = (driven_m[kept] >= start_m) & (driven_m[kept] < start_m + _STRETCH_M)
        error = steps_m[1][within].sum() / steps_m[0][within].sum() - 1
        end_m = min(start_m + _STRETCH_M, driven_m[-1])
        yield Stretch(float(start_m), float(end_m), float(felt_mps2[here].mean()), float(100 * error))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+", type=Path)
    for folder in parser.parse_args().folders:
        files = [folder / name for name in ("truth.tum", "trajectory.tum")]
        if not all(file.is_file() for file in files):
            raise SystemExit(
                f"{folder}: no run folder with truth.tum and trajectory.tum; `rigtrue run` makes one"
            )
        print(f"{folder.name}: stretch, m/s2, length too long by %")
        for stretch in stretches(*(np.loadtxt(file, ndmin=2) for file in files)):
            print(
                f"  {stretch.from_m:4.0f} to {stretch.to_m:4.0f} m  {stretch.acceleration_mps2:5.2f}"
                f"  {stretch.error_percent:+.3f}"
            )


if __name__ == "__main__":
    main()
