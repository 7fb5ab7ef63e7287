"""The table of claims: what holds, what falls short, and when a weak answer counts."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.benchmark.accuracy import Claim, Run, claim_row, honesty_rows, main, read_runs, scenario_rows

CLAIM = Claim("a drive", ("some_drive",), "", False, 0.1, 40)
WIDE_MM = {"rotation_deg": 0.15, "translation_mm": 900.0}  # says nothing of how it is turned
WEAK = Claim("a drive", ("some_drive",), "", True, 0.1, 40, or_weak=True)


def camera(rotation_deg: float, status: str = "converged", stated_deg: float = 0.05) -> dict[str, Any]:
    return {
        "is_reference": False,
        "status": status,
        "inside95": stated_deg > rotation_deg,
        "error": {"rotation_deg": rotation_deg, "translation_mm": 1.0},
        "start_error": {"rotation_deg": 3.0, "translation_mm": 100.0},
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
        (camera(0.12, "weak", stated_deg=0.15), "mm | **no** |"),  # its sigma is 0.093
        (camera(0.5, "lost", stated_deg=0.6), "mm | **no** |"),
        (camera(0.12, "weak", stated_deg=0.15) | {"stated95": WIDE_MM}, "mm | **no** |"),
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


def test_a_claim_about_one_estimator_is_not_met_by_another() -> None:
    of_batch = Claim("batch", ("some_drive",), "", True, 0.02, 8, estimator="batch")
    assert "no run" in claim_row(of_batch, [run(0, camera(0.01))])
    assert claim_row(of_batch, [replace(run(0, camera(0.01)), estimator="batch")]).endswith("| yes |")


def test_honesty_counts_cameras() -> None:
    first = replace(run(0, camera(0.02), "first_drive"), converged_at_50m=1.0)
    runs = [first, replace(run(1, camera(0.5, "weak", 0.2), "first_drive"), converged_at_50m=0.5)]
    text = "\n".join(honesty_rows(runs))
    assert (
        "2 cameras | 90 to 98 % | 50.0 % | **no** |" in text
        and "| 95 % | 75 % | **no** |" in text
        and "0.80" in text
    )
    assert "all the same | 0 | 0 | yes |" in text and "0.020 deg, 1.0 mm" in text
    assert scenario_rows(runs) == ["| `first_drive` | 0.260 (0.500) | 1.0 (1.0) | 1 of 2 | 0.80 | 1 |"]


def test_a_camera_that_got_worse_counts_unless_its_status_says_so() -> None:
    runs = [run(0, camera(4.0)), run(1, camera(4.0, "weak"))]
    assert "all the same | 0 | 1 | **no** |" in "\n".join(honesty_rows(runs))


def write_run(folder: Path, estimator: str, driven_m: float) -> None:
    folder.mkdir()
    one = run(0, camera(0.02))
    scores = {"scenario": "some_drive", "seed": 0, "estimator": estimator, "metrics": one.metrics}
    (folder / "scores.json").write_text(json.dumps(scores))
    cameras = {"front": {"is_reference": True}, "rear": one.cameras[0]}
    (folder / "report_data.json").write_text(json.dumps({"reference": "front", "cameras": cameras}))
    poses = [
        f"{stamp_s} {x_m} 0 0 0 0 0 1\n" for stamp_s, x_m in ((1, 0.0), (2, driven_m), (3, driven_m + 9))
    ]
    (folder / "truth.tum").write_text("".join(poses))
    told = [f"{stamp}000000000,{name},{status}\n" for stamp, name, status in (
        (1, "rear", "initialising"), (2, "front", "weak"), (2, "rear", "converged"), (3, "rear", "weak"),
    )]  # fmt: skip
    (folder / "extrinsics.csv").write_text("stamp_ns,camera,status\n" + "".join(told))


def test_run_folders_are_read_and_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for estimator in ("online", "batch"):
        write_run(tmp_path / f"some_drive-0-{estimator}", estimator, 55.0)
    runs = read_runs(tmp_path)
    assert [(each.estimator, len(each.cameras)) for each in runs] == [("batch", 1), ("online", 1)]
    monkeypatch.setattr("sys.argv", ["accuracy", str(tmp_path)])
    main()
    printed = capsys.readouterr().out
    assert "honesty of `batch`" in printed and "honesty of `online`" in printed and "`some_drive`" in printed
    monkeypatch.setattr("sys.argv", ["accuracy", str(tmp_path / "nothing")])
    with pytest.raises(SystemExit, match="no run"):
        main()


@pytest.mark.parametrize(("driven_m", "share"), [(55.0, 1.0), (45.0, 0.0), (20.0, None)])
def test_statuses_count_where_the_car_had_come_fifty_metres(
    tmp_path: Path, driven_m: float, share: float | None
) -> None:
    write_run(tmp_path / "run", "online", driven_m)
    assert read_runs(tmp_path)[0].converged_at_50m == share


def test_a_camera_that_states_nothing_is_not_inside() -> None:
    silent = camera(0.02) | {"stated95": None, "inside95": None}
    text = "\n".join(honesty_rows([run(0, silent, "first_drive"), run(1, camera(0.02), "first_drive")]))
    assert "2 cameras | 90 to 98 % | 50.0 % | **no** |" in text
