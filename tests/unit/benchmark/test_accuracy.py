"""The table of claims: what holds, what falls short, and when a weak answer counts."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.benchmark.accuracy import Claim, Run, claim_row, honesty_rows, main, read_runs, scenario_rows

CLAIM = Claim("a drive", ("some_drive",), "", False, 0.1, 40)
WEAK = Claim("a drive", ("some_drive",), "", True, 0.1, 40, or_weak=True)


def camera(rotation_deg: float, status: str = "converged", stated_deg: float = 0.05) -> dict[str, Any]:
    return {
        "is_reference": False,
        "status": status,
        "inside95": stated_deg > rotation_deg,
        "error": {"rotation_deg": rotation_deg, "translation_mm": 1.0},
        "stated95": {"rotation_deg": stated_deg, "translation_mm": 3.0},
    }


def run(seed: int, one: dict[str, Any], scenario: str = "some_drive") -> Run:
    values = {
        "extrinsics.worst.rotation_deg": one["error"]["rotation_deg"],
        "extrinsics.worst.translation_mm": one["error"]["translation_mm"],
        "motion.scale_error_percent": 0.1,
        "consistency.nees": 0.8,
    }
    return Run(scenario, seed, {key: {"value": value} for key, value in values.items()}, [one])


def test_a_claim_holds_by_the_median_or_by_the_worst_seed() -> None:
    runs = [run(0, camera(0.02)), run(1, camera(0.03)), run(2, camera(0.5))]
    assert claim_row(CLAIM, runs).endswith("| some_drive 0.030 deg, 1.0 mm | yes |")
    worst = Claim("a drive", ("some_drive",), "", True, 0.1, 40)
    assert claim_row(worst, runs).endswith("| some_drive 0.500 deg, 1.0 mm | **no** |")


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        (camera(0.5, "weak", stated_deg=0.6), "(weak) | yes |"),
        (camera(0.5, "converged", stated_deg=0.6), "mm | **no** |"),
        (camera(0.5, "weak", stated_deg=0.2), "mm | **no** |"),
    ],
)
def test_weak_counts_only_where_the_region_is_wide_and_holds_the_truth(
    answer: dict[str, Any], verdict: str
) -> None:
    assert claim_row(WEAK, [run(0, answer)]).endswith(verdict)


def test_a_claim_without_runs_says_so() -> None:
    assert "no run" in claim_row(CLAIM, [])


def test_a_metric_that_is_missing_is_no_success() -> None:
    broken = run(0, camera(0.02))
    broken.metrics["extrinsics.worst.rotation_deg"]["value"] = None
    assert claim_row(CLAIM, [broken]).endswith("**no** |")


def test_honesty_counts_cameras() -> None:
    runs = [run(0, camera(0.02), "first_drive"), run(1, camera(0.5, "weak", 0.2), "first_drive")]
    text = "\n".join(honesty_rows(runs))
    assert "2 cameras | 90 to 98 % | 50.0 %" in text and "| 95 % | 50 % |" in text and "0.80" in text
    assert scenario_rows(runs) == ["| `first_drive` | 0.260 (0.500) | 1.0 (1.0) | 1 of 2 | 0.80 | 1 |"]


def test_run_folders_are_read_and_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for estimator in ("online", "batch"):
        folder = tmp_path / f"some_drive-0-{estimator}"
        folder.mkdir()
        one = run(0, camera(0.02))
        scores = {"scenario": "some_drive", "seed": 0, "estimator": estimator, "metrics": one.metrics}
        (folder / "scores.json").write_text(json.dumps(scores))
        cameras = {"front": {"is_reference": True}, "rear": one.cameras[0]}
        (folder / "report_data.json").write_text(json.dumps({"cameras": cameras}))
    assert [len(each.cameras) for each in read_runs(tmp_path, "batch")] == [1]
    monkeypatch.setattr("sys.argv", ["accuracy", str(tmp_path)])
    main()
    assert "`some_drive`" in capsys.readouterr().out
    monkeypatch.setattr("sys.argv", ["accuracy", str(tmp_path), "--estimator", "nobody"])
    with pytest.raises(SystemExit, match="no run of 'nobody'"):
        main()
