"""Sweeps: rows for every run and metric, resumed where they stopped, and not stopped by what fails."""

from pathlib import Path

import duckdb
import pytest

from tests.integration.conftest import Command

ESTIMATORS = "tests.throwaway_estimators"


def write_sweep(folder: Path, tiny: str, *names: str) -> Path:
    path = folder / "some.yaml"
    estimators = ", ".join(f"'{ESTIMATORS}:{name}'" for name in names)
    path.write_text(f"about: A sweep.\nscenarios: [{tiny}]\nseeds: [0]\nestimators: [{estimators}]\n")
    return path


def test_a_sweep_keeps_what_is_finished_and_says_what_failed(
    command: Command, tiny: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sweep = write_sweep(tmp_path, tiny, "Nominal", "Raises", "Dies")
    assert command("sweep", sweep, "--workers", 2, "--out", "out") == 1
    assert "3 runs" not in capsys.readouterr().err
    finished = tmp_path / "out" / f"tiny-0-{ESTIMATORS}.Nominal" / "scores.json"
    stamp = finished.stat().st_mtime_ns

    assert command("sweep", sweep, "--workers", 1, "--out", "out") == 1
    out, err = capsys.readouterr()
    assert "1 of 3 runs are there already" in err and "error: 2 runs failed" in err
    assert "a planted fault" in out and "the worker process died" in out
    assert finished.stat().st_mtime_ns == stamp

    table = tmp_path / "out" / "results.parquet"
    rows = duckdb.sql(f"SELECT estimator, key, value, unit, better, reason FROM '{table}'").fetchall()
    worst = {row[0].partition(":")[2]: row[2:] for row in rows if row[1] == "extrinsics.worst.rotation_deg"}
    assert worst["Nominal"] == (pytest.approx(3.0, abs=1e-3), "deg", "lower", None)
    assert worst["Raises"][0] is None and "a planted fault" in worst["Raises"][3]
    assert worst["Dies"][0] is None and "died" in worst["Dies"][3]
    assert len({row[:2] for row in rows}) == len(rows) and len(rows) % 3 == 0


def test_a_run_made_by_other_code_is_run_again(
    command: Command, tiny: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sweep = write_sweep(tmp_path, tiny, "Nominal")
    assert command("sweep", sweep, "--workers", 1, "--out", "out", "--quiet") == 0
    finished = tmp_path / "out" / f"tiny-0-{ESTIMATORS}.Nominal" / "scores.json"
    finished.write_text(finished.read_text().replace('"code": "', '"code": "x'))
    stamp = finished.stat().st_mtime_ns
    assert command("sweep", sweep, "--workers", 1, "--out", "out", "--quiet") == 0
    assert finished.stat().st_mtime_ns != stamp
