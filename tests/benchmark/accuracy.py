"""The table of how accurate and how honest an estimator is, from the run folders of a sweep.

``rigtrue sweep accuracy`` makes the runs; ``python -m tests.benchmark.accuracy [FOLDER] [--estimator NAME]``
prints, for each claim, what is wanted and what was measured, and then every scenario by itself.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from eval.sweep import SWEEPS

PLAIN = ("first_drive", "t_junction", "roundabout")
EFFECTS = (
    *("light_traffic", "first_drive_low_sun", "steady_rain", "fog", "dusk"),
    *("sensor_noise", "defocus", "jpeg_artefacts"),
)


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
    """

    about: str
    scenarios: tuple[str, ...]
    after: str
    worst_seed: bool
    limit_deg: float
    limit_mm: float
    or_weak: bool = False


CLAIMS = (
    Claim("plain urban drives with a turn, 50 m, median", PLAIN, ".at_50m", False, 0.03, 10),
    Claim("the same, worst seed", PLAIN, ".at_50m", True, 0.05, 20),
    Claim("the same after 10 m, median", PLAIN, ".at_10m", False, 0.10, 40),
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

    def error(self, quantity: str, after: str) -> float:
        """Return an error of the worst camera; infinite where there is none."""
        return self.value(f"extrinsics.worst.{quantity}{after}", np.inf)

    def value(self, key: str, otherwise: float) -> float:
        """Return a metric, or what stands for one that could not be computed."""
        value = self.metrics[key]["value"]
        return otherwise if value is None else float(value)

    def is_honestly_weak(self, claim: Claim) -> bool:
        """Tell whether every camera beyond a limit says so: weak, stated above it, and inside its region."""
        return all(
            camera["status"] in ("weak", "lost", "initialising")
            and camera["inside95"]
            and _beyond(camera["stated95"], claim)
            for camera in self.cameras
            if _beyond(camera["error"], claim)
        )


def _beyond(pose_error: dict[str, float], claim: Claim) -> bool:
    return pose_error["rotation_deg"] > claim.limit_deg or pose_error["translation_mm"] > claim.limit_mm


def read_runs(folder: Path, estimator: str) -> list[Run]:
    """Return the finished runs of one estimator in a sweep folder."""
    runs = []
    for path in sorted(folder.glob("*/scores.json")):
        scores = json.loads(path.read_text())
        if scores["estimator"] == estimator:
            data = json.loads((path.parent / "report_data.json").read_text())
            cameras = [camera for camera in data["cameras"].values() if not camera["is_reference"]]
            runs.append(Run(scores["scenario"], scores["seed"], scores["metrics"], cameras))
    return runs


def claim_row(claim: Claim, runs: Iterable[Run]) -> str:
    """Return a line of the table: what is wanted, what was measured, whether it holds."""
    mine = [run for run in runs if run.scenario in claim.scenarios]
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
    cameras = [camera for run in runs for camera in run.cameras if camera["error"] and camera["stated95"]]
    inside = 100 * np.mean([bool(camera["inside95"]) for camera in cameras])
    nees = [run.value("consistency.nees", np.nan) for run in runs]
    settled = [camera["status"] == "converged" for run in plain for camera in run.cameras]
    converged = 100 * np.mean(settled) if settled else np.nan
    sharp = {quantity: _sharpness(quantity, cameras) for quantity in ("rotation_deg", "translation_mm")}
    rows = {
        "metric scale on flat road, worst plain run": ("0.3 %", f"{scale_percent:.2f} %"),
        f"coverage of the stated 95 % regions, {len(cameras)} cameras": ("90 to 98 %", f"{inside:.1f} %"),
        "median stated sigma over RMS error, rotation": ("at most 2", f"{sharp['rotation_deg']:.2f}"),
        "the same, translation": ("at most 2", f"{sharp['translation_mm']:.2f}"),
        "cameras converged at the end of plain drives": ("95 %", f"{converged:.0f} %"),
        "mean NEES / 6": ("0.5 to 1.5", f"{np.nanmean(nees):.2f} (median run {np.nanmedian(nees):.2f})"),
    }
    return [f"| {about} | {wanted} | {measured} |" for about, (wanted, measured) in rows.items()]


def _sharpness(quantity: str, cameras: list[dict[str, Any]]) -> float:
    """Return the median norm of the stated sigmas over the RMS error."""
    sigma = np.median([camera["stated95"][quantity] for camera in cameras]) / _NORM95_PER_SIGMA
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
    parser.add_argument("folder", nargs="?", type=Path, default=SWEEPS / "accuracy")
    parser.add_argument("--estimator", default="online")
    chosen = parser.parse_args()
    runs = read_runs(chosen.folder, chosen.estimator)
    if not runs:
        raise SystemExit(f"{chosen.folder}: no run of {chosen.estimator!r}; `rigtrue sweep` makes them")
    print("| on | at most | measured | holds |\n|---|---|---|---|")
    print("\n".join(claim_row(claim, runs) for claim in CLAIMS))
    print("\n| honesty | wanted | measured |\n|---|---|---|")
    print("\n".join(honesty_rows(runs)))
    print("\n| scenario | rotation deg | translation mm | inside | NEES | converged |")
    print("|---|---|---|---|---|---|")
    print("\n".join(scenario_rows(runs)))


if __name__ == "__main__":
    main()
