"""The table of how accurate and how honest the estimators are, from the run folders of sweeps.

``rigtrue sweep accuracy`` and ``rigtrue sweep batch`` make the runs; ``python -m tests.benchmark.accuracy
[FOLDER...]`` prints, for each claim, what is wanted and what was measured, and then every scenario by itself.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from eval.sweep import SWEEPS

PLAIN = ("first_drive", "t_junction", "roundabout")
EFFECTS = (
    *("light_traffic", "first_drive_low_sun", "steady_rain", "fog", "dusk"),
    *("sensor_noise", "defocus", "jpeg_artefacts"),
)


_SHORT_M = 0.5  # by which a drive may miss its length: it ends with a whole bundle
_SAME_NS = 1e6

# The length that 95 % of vectors with three like parts stay below, over the root of the summed variances.
_NORM95_PER_SIGMA = 2.7955 / np.sqrt(3)


@dataclass(frozen=True)
class Claim:
    """What a row of the table asks of the worst camera of some scenarios.

    Attributes:
        about: What the row is called.
        scenarios: Whose runs count, each scenario by itself.
        after: Suffix of the metric keys, such as ``.at_50m``; empty for the end of the drive.
        worst_seed: Whether the worst seed counts instead of the median.
        limit_deg: Of the rotation error.
        limit_mm: Of the translation error.
        or_weak: Whether a camera that states a sigma above the limit, and is inside its 95 % region, answers.
        estimator: Whose runs count.
    """

    about: str
    scenarios: tuple[str, ...]
    after: str
    worst_seed: bool
    limit_deg: float
    limit_mm: float
    or_weak: bool = False
    estimator: str = "online"


CLAIMS = (
    Claim("plain urban drives with a turn, 50 m, median", PLAIN, ".at_50m", False, 0.03, 10),
    Claim("the same, worst seed", PLAIN, ".at_50m", True, 0.05, 20),
    Claim("the same after 10 m, median", PLAIN, ".at_10m", False, 0.10, 40),
    Claim("`batch` on the same drives, worst seed", PLAIN, "", True, 0.02, 8, estimator="batch"),
    Claim("start 10 deg, 300 mm, 50 m, median", ("large_errors",), ".at_50m", False, 0.03, 10),
    Claim("start 10 deg, 300 mm, 50 m, worst seed", ("large_errors",), ".at_50m", True, 0.05, 20),
    *(Claim(f"{name}, 50 m, median", (name,), ".at_50m", False, 0.10, 30) for name in EFFECTS),
    Claim("straight road only, 100 m, median", ("long_straight",), "", False, 0.10, 40, or_weak=True),
    *(
        Claim(f"{name}, 50 m, worst seed", (name,), "", True, 0.3, 80, or_weak=True)
        for name in ("night", "bare_suburb", "repeated_facades")
    ),
)


@dataclass(frozen=True)
class Run:
    """What one run folder says."""

    scenario: str
    seed: int
    metrics: dict[str, Any]
    cameras: list[dict[str, Any]]
    estimator: str = "online"
    converged_at_50m: float | None = None  # the share of cameras; None on a drive that is shorter

    def error(self, quantity: str, after: str) -> float:
        """Return an error of the worst camera; infinite where there is none."""
        return self.value(f"extrinsics.worst.{quantity}{after}", np.inf)

    def value(self, key: str, otherwise: float) -> float:
        """Return a metric, or what stands for one that could not be computed."""
        value = self.metrics[key]["value"]
        return otherwise if value is None else float(value)

    def is_honestly_weak(self, claim: Claim) -> bool:
        """Tell whether every camera beyond a limit says so.

        It is `weak`, inside its 95 % region, and states a sigma above that very limit.
        """
        limits = {"rotation_deg": claim.limit_deg, "translation_mm": claim.limit_mm}
        return all(
            camera["status"] == "weak" and camera["inside95"] and _sigma(camera, quantity) > limit
            for camera in self.cameras
            for quantity, limit in limits.items()
            if not camera["error"] or camera["error"][quantity] > limit
        )


def _sigma(camera: dict[str, Any], quantity: str) -> float:
    """Return the root of the summed variances that a camera states; NaN where it states none."""
    return camera["stated95"][quantity] / _NORM95_PER_SIGMA if camera["stated95"] else np.nan


def read_runs(folder: Path) -> list[Run]:
    """Return the finished runs in a sweep folder."""
    runs = []
    for path in sorted(folder.glob("*/scores.json")):
        scores = json.loads(path.read_text())
        data = json.loads((path.parent / "report_data.json").read_text())
        cameras = [camera for camera in data["cameras"].values() if not camera["is_reference"]]
        who = scores["scenario"], scores["seed"], scores["metrics"], cameras, scores["estimator"]
        runs.append(Run(*who, _converged_share(path.parent, data["reference"], 50.0)))
    return runs


def _converged_share(folder: Path, reference: str, after_m: float) -> float | None:
    """Return the share of cameras that were `converged` when the car had come that far."""
    truth = np.loadtxt(folder / "truth.tum", ndmin=2)
    driven_m = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(truth[:, 1:4], axis=0), axis=1))]
    if driven_m[-1] < after_m - _SHORT_M:
        return None
    there_ns = 1e9 * truth[min(np.searchsorted(driven_m, after_m), len(truth) - 1), 0]
    told = pd.read_csv(folder / "extrinsics.csv")
    told = told[(told.camera != reference) & (told.stamp_ns <= there_ns + _SAME_NS)]
    return float((told.groupby("camera").status.last() == "converged").mean())


def claim_row(claim: Claim, runs: Iterable[Run]) -> str:
    """Return a line of the table: what is wanted, what was measured, whether it holds."""
    mine = [run for run in runs if run.scenario in claim.scenarios and run.estimator == claim.estimator]
    if not mine:
        return f"| {claim.about} | {claim.limit_deg:g} deg, {claim.limit_mm:g} mm | no run | |"
    parts, holds = [], True
    for name in dict.fromkeys(run.scenario for run in mine):
        group = [run for run in mine if run.scenario == name]
        over_seeds = np.max if claim.worst_seed else np.median
        measured = [
            float(over_seeds([run.error(quantity, claim.after) for run in group]))
            for quantity in ("rotation_deg", "translation_mm")
        ]
        good = measured[0] <= claim.limit_deg and measured[1] <= claim.limit_mm
        weak = claim.or_weak and all(run.is_honestly_weak(claim) for run in group)
        note = " (weak)" if weak and not good else ""
        parts.append(f"{name} {measured[0]:.3f} deg, {measured[1]:.1f} mm{note}")
        holds &= good or weak
    verdict = "yes" if holds else "**no**"
    wanted = f"{claim.limit_deg:g} deg, {claim.limit_mm:g} mm" + (" or weak" if claim.or_weak else "")
    return f"| {claim.about} | {wanted} | {'; '.join(parts)} | {verdict} |"


def honesty_rows(runs: list[Run]) -> list[str]:
    """Return the lines on scale, coverage, sharpness, statuses and normalised errors."""
    plain = [run for run in runs if run.scenario in PLAIN]
    scale_percent = max((run.value("motion.scale_error_percent", np.inf) for run in plain), default=np.inf)
    cameras = [camera for run in runs for camera in run.cameras if camera["error"]]
    inside = 100 * np.mean([bool(camera["inside95"]) for camera in cameras])
    nees = [run.value("consistency.nees", np.nan) for run in runs]
    settled = [run.converged_at_50m for run in plain if run.converged_at_50m is not None]
    converged = 100 * np.mean(settled) if settled else np.nan
    worse = sum(_is_worse_and_says_nothing(camera) for camera in cameras)
    sure = [camera["error"] for camera in cameras if camera["status"] == "converged"]
    worst = [
        max((error[key] for error in sure), default=np.nan) for key in ("rotation_deg", "translation_mm")
    ]
    sharp = {
        "rotation": _sharpness("rotation_deg", cameras),
        "translation": _sharpness("translation_mm", cameras),
    }
    rows = (
        (
            "metric scale on flat road, worst plain run",
            "0.3 %",
            f"{scale_percent:.2f} %",
            scale_percent <= 0.3,
        ),
        (
            f"coverage of the stated 95 % regions, {len(cameras)} cameras",
            "90 to 98 %",
            f"{inside:.1f} %",
            90 <= inside <= 98,
        ),
        *(
            (f"median stated sigma over RMS error, {quantity}", "at most 2", f"{value:.2f}", value <= 2)
            for quantity, value in sharp.items()
        ),
        ("cameras converged after 50 m of plain drives", "95 %", f"{converged:.0f} %", converged >= 95),
        ("cameras worse than they started, `converged` all the same", "0", f"{worse}", worse == 0),
        (
            "mean NEES / 6",
            "0.5 to 1.5",
            f"{np.nanmean(nees):.2f} (median run {np.nanmedian(nees):.2f})",
            0.5 <= np.nanmean(nees) <= 1.5,
        ),
    )
    lines = [
        f"| {about} | {wanted} | {measured} | {'yes' if holds else '**no**'} |"
        for about, wanted, measured, holds in rows
    ]
    return [*lines, f"| worst of all that are `converged` | | {worst[0]:.3f} deg, {worst[1]:.1f} mm | |"]


def _is_worse_and_says_nothing(camera: dict[str, Any]) -> bool:
    return camera["status"] == "converged" and any(
        camera["error"][key] > camera["start_error"][key] for key in ("rotation_deg", "translation_mm")
    )


def _sharpness(quantity: str, cameras: list[dict[str, Any]]) -> float:
    """Return the median norm of the stated sigmas over the RMS error."""
    sigma = np.nanmedian([_sigma(camera, quantity) for camera in cameras])
    return float(sigma / np.sqrt(np.mean([camera["error"][quantity] ** 2 for camera in cameras])))


def scenario_rows(runs: list[Run]) -> list[str]:
    """Return a line a scenario: errors of the worst camera, coverage, NEES and statuses over its seeds."""
    lines = []
    for name in dict.fromkeys(run.scenario for run in runs):
        group = [run for run in runs if run.scenario == name]
        rotation = [run.error("rotation_deg", "") for run in group]
        translation = [run.error("translation_mm", "") for run in group]
        cameras = [camera for run in group for camera in run.cameras]
        nees = [run.value("consistency.nees", np.nan) for run in group]
        lines.append(
            f"| `{name}` | {np.median(rotation):.3f} ({max(rotation):.3f}) "
            f"| {np.median(translation):.1f} ({max(translation):.1f}) "
            f"| {sum(bool(c['inside95']) for c in cameras)} of {len(cameras)} "
            f"| {np.nanmean(nees):.2f} "
            f"| {sum(c['status'] == 'converged' for c in cameras)} |"
        )
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="*", type=Path, default=[SWEEPS / "accuracy", SWEEPS / "batch"])
    chosen = parser.parse_args()
    runs = [run for folder in chosen.folders for run in read_runs(folder)]
    if not runs:
        raise SystemExit(f"{' '.join(map(str, chosen.folders))}: no run; `rigtrue sweep accuracy` makes them")
    print("| on | at most | measured | holds |\n|---|---|---|---|")
    print("\n".join(claim_row(claim, runs) for claim in CLAIMS))
    for estimator in sorted({run.estimator for run in runs}):
        _print_tables_of(estimator, [run for run in runs if run.estimator == estimator])


def _print_tables_of(estimator: str, runs: list[Run]) -> None:
    print(f"\n| honesty of `{estimator}` | wanted | measured | holds |\n|---|---|---|---|")
    print("\n".join(honesty_rows(runs)))
    print("\n| scenario | rotation deg | translation mm | inside | NEES | converged |")
    print("|---|---|---|---|---|---|")
    print("\n".join(scenario_rows(runs)))


if __name__ == "__main__":
    main()
