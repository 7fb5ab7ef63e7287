"""The length of a path, stretch by stretch, against the true one."""

from pathlib import Path

import numpy as np
import pytest

from tests.benchmark.stretch_scale import main, stretches


def straight(scale: float) -> np.ndarray:
    """Return the rows of a drive of 30 m at 5 m/s, the last third of it of another length."""
    times_s = np.arange(0.0, 6.01, 0.1)
    driven_m = 5 * times_s + np.where(times_s > 4, (scale - 1) * 5 * (times_s - 4), 0)
    zeros = np.zeros_like(times_s)
    return np.column_stack([times_s, driven_m, zeros, zeros, zeros, zeros, zeros, zeros + 1])


def test_a_stretch_that_came_out_short_is_told_from_those_that_did_not() -> None:
    told = list(stretches(straight(1.0), straight(0.99)[::2]))
    assert [(each.from_m, each.to_m) for each in told] == [(0.0, 10.0), (10.0, 20.0), (20.0, 30.0)]
    np.testing.assert_allclose([each.error_percent for each in told], [0, 0, -1], atol=1e-6)
    np.testing.assert_allclose([each.acceleration_mps2 for each in told], 0, atol=1e-6)


def test_a_run_folder_is_printed_and_another_folder_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    np.savetxt(tmp_path / "truth.tum", straight(1.0))
    np.savetxt(tmp_path / "trajectory.tum", straight(0.99))
    monkeypatch.setattr("sys.argv", ["stretch_scale", str(tmp_path)])
    main()
    assert "20 to   30 m   0.00  -1.000" in capsys.readouterr().out
    monkeypatch.setattr("sys.argv", ["stretch_scale", str(tmp_path / "nothing")])
    with pytest.raises(SystemExit, match="no run folder"):
        main()
