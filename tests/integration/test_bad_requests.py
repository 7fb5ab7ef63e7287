"""What a user may get wrong on the command line: one line, exit code 2, and nothing left that looks whole."""

import errno
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.integration.conftest import Command

ESTIMATORS = "tests.throwaway_estimators"
RIGTRUE = (sys.executable, "-c", "from eval.cli import main; main()")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("run nope", "scenario 'nope' is not known; there are: "),
        ("run first_drive --estimator nope", "estimator 'nope' is not known; there are: batch, online"),
        ("run first_drive --estimator nope:X", "cannot import 'nope'"),
        (f"run first_drive --estimator {ESTIMATORS}:X", "has no 'X'"),
        (f"run first_drive --estimator {ESTIMATORS}:__doc__", "got a str, wanted a class or function"),
        ("run first_drive --set drive.speed=3", "drive.speed: unknown key; there are: distance_m"),
        ("run first_drive --set sensor.noise=.nan", "sensor.noise: got nan"),
        ("run first_drive --set rig=nope", "rig 'nope' is not known; there are: "),
        ("run ./none.yaml", "none.yaml: no such scenario file"),
        ("run first_drive --seed -1", "'--seed'"),
        ("run first_drive --sed 1", "No such option: --sed"),
        ("run", "Missing argument 'SCENARIO'"),
        ("rum first_drive", "No such command 'rum'"),
        ("list colours", "'scenarios', 'sweeps', 'rigs', 'estimators', 'metrics'"),
        ("report .", "is no run folder, wanted one that holds scores.json"),
        ("replay none --rig {rig}", "none: no such recording"),
        ("run first_drive --set estimator.refin=none", "--set estimator.refin: unknown key; there are: "),
        (
            "run first_drive --set estimator.front_end.tracker.flow.window_px=2",
            "--set estimator.front_end.tracker.flow.window_px: got 2, wanted 3 to 101",
        ),
        ("replay none --rig {rig} --set drive.speed_mps=3", "--set drive.speed_mps=3: a recording is as it"),
        ("replay . --rig none.yaml", "none.yaml: no such rig file"),
        ("sweep nope", "sweep 'nope' is not known; there are: "),
        ("run {tiny} --out file/below", "file: cannot write this folder"),
        ("run {tiny} --out file", "file: exists and is no run folder"),
        ("run {tiny} --out full", "full: exists and is no run folder (it has no scores.json)"),
        ("record {tiny} --out full", "full: exists; wanted a name that is free"),
        ("record {tiny} --out file/below", "file: cannot write this folder"),
        ("sweep first_drive --out full", "full: exists and is no sweep folder"),
    ],
)
def test_a_wrong_request_is_one_line(
    command: Command,
    house: Path,
    tiny: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: str,
    message: str,
) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "precious").touch()
    words = arguments.format(rig=house / "tiny_rig.yaml", tiny=tiny).split()
    if "{tiny}" in arguments and words[0] == "run":
        words += ["--estimator", f"{ESTIMATORS}:Nominal"]
    assert command(*words) == 2
    out, err = capsys.readouterr()
    assert out == "" and message in err and err.count("\n") == 1
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["file", "full", "precious"]


def test_a_run_folder_with_foreign_data_is_one_line(
    command: Command, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("scores.json", "report_data.json"):
        (tmp_path / name).write_text("{}")
    assert command("report", ".") == 2
    out, err = capsys.readouterr()
    assert out == "" and "are not as a run writes them (KeyError: " in err and err.count("\n") == 1
    assert not (tmp_path / "report.html").exists()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("size_px: [64, 40]", "size_px: [-64, 40]", "cameras.front.size_px[0]: got -64"),
        (
            "[-0.5, 0.5, -0.5, 0.5]",
            "[-0.5, 0.5, -0.5, 0.9]",
            "cameras.front.ego_from_cam.quaternion_xyzw: got a",
        ),
        (
            "reference: front",
            "reference: forward",
            "reference: got 'forward', wanted one of the cameras; there are: front",
        ),
        ("focal_px: [40.0, 40.0]", "focal_px: [.nan, 40.0]", "cameras.front.focal_px[0]: got nan"),
        ("model: pinhole", "modle: pinhole", "cameras.front.modle: unknown key"),
        ("reference: front", "reference: [", "not valid YAML"),
    ],
)
def test_a_wrong_rig_is_one_line(
    command: Command,
    house: Path,
    tiny: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    old: str,
    new: str,
    message: str,
) -> None:
    (tmp_path / "wrong.yaml").write_text((house / "tiny_rig.yaml").read_text().replace(old, new, 1))
    assert command("run", tiny, "--set", "rig=./wrong.yaml") == 2
    err = capsys.readouterr().err
    assert message in err and err.count("\n") == 1


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("Raises", "failed at bundle 2 of 3: RuntimeError: a planted fault; traceback in "),
        (
            "AnswersNonsense",
            "failed at bundle 1 of 3: TypeError: got NoneType as an answer, wanted an Estimate",
        ),
        ("ForgetsACamera", "failed at bundle 1 of 3: ValueError: the estimate lacks the camera rear"),
    ],
)
def test_a_failed_estimator_is_exit_code_1_with_a_log(
    command: Command, tiny: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, message: str
) -> None:
    assert command("run", tiny, "--estimator", f"{ESTIMATORS}:{name}", "--out", tmp_path / "out") == 1
    assert message in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["out.error.log"]
    assert "Traceback" in (tmp_path / "out.error.log").read_text()


def test_ctrl_c_while_estimating_leaves_nothing(house: Path, tiny: str, tmp_path: Path) -> None:
    arguments = ("run", tiny, "--estimator", f"{ESTIMATORS}:Sleeps", "--out", "runs/out")
    assert _interrupt(arguments, tmp_path, when="estimating 1/3") == 130
    assert list((tmp_path / "runs").iterdir()) == []


def test_ctrl_c_while_rendering_leaves_nothing(house: Path, tiny: str, tmp_path: Path) -> None:
    arguments = ("record", tiny, "--seed", "4", "--out", "bags/drive")
    before = sorted(path.name for path in (house / "cache").glob("*") if not path.suffix)
    assert _interrupt(arguments, tmp_path, when="rendering 0/3") == 130
    assert list((tmp_path / "bags").iterdir()) == []
    assert sorted(path.name for path in (house / "cache").glob("*") if path.suffix != ".lock") == before


def test_ctrl_c_in_a_sweep_stops_its_workers(house: Path, tiny: str, tmp_path: Path) -> None:
    names = ", ".join(f"'{ESTIMATORS}:{name}'" for name in ("Sleeps", "Nominal"))
    (tmp_path / "some.yaml").write_text(
        f"about: A sweep.\nscenarios: [{tiny}]\nseeds: [0]\nestimators: [{names}]\n"
    )
    arguments = ("sweep", "./some.yaml", "--workers", "2", "--out", "sweep")
    assert _interrupt(arguments, tmp_path, when="done: ") == 130
    left = sorted(path.name for path in (tmp_path / "sweep").iterdir())
    assert left == ["sweep.yaml", f"tiny-0-{ESTIMATORS}.Nominal"]


def _heed_interrupts() -> None:
    """Undo what a shell hands down to its background jobs: that they ignore Ctrl-C."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def _interrupt(arguments: tuple[str, ...], folder: Path, when: str) -> int:
    """Start a command, send it Ctrl-C at a line of its standard error, and return its exit code."""
    with subprocess.Popen(
        (*RIGTRUE, *arguments),
        cwd=folder,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=_heed_interrupts,
    ) as process:
        assert process.stderr is not None
        lines = []
        for line in process.stderr:
            lines.append(line)
            if when in line:
                process.send_signal(signal.SIGINT)
                break
        rest = process.stderr.read()
        code = process.wait(60)
    assert rest.splitlines()[-1:] == ["interrupted"], (lines, rest)
    assert "Traceback" not in rest
    return code


def test_a_full_disk_is_one_line_and_leaves_nothing(
    command: Command,
    tiny: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert command("record", tiny, "--out", "first", "--quiet") == 0  # so that it is in the cache

    def copy_some(source: Path, target: Path) -> None:
        target.write_bytes(source.read_bytes()[:100])
        raise OSError(errno.ENOSPC, "No space left on device", str(source), None, str(target))

    monkeypatch.setattr("shutil.copyfile", copy_some)
    assert command("record", tiny, "--out", "second", "--quiet") == 2
    err = capsys.readouterr().err
    assert "second" in err and err.endswith(": No space left on device\n") and err.count("\n") == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "first.rig.yaml"]


def test_without_opengl_the_remedy_is_named(house: Path, tiny: str, tmp_path: Path) -> None:
    environment = os.environ | {"MUJOCO_GL": "egl", "__EGL_VENDOR_LIBRARY_DIRS": str(tmp_path)}
    for arguments, code in ((("record", tiny, "--seed", "5", "--out", "drive"), 2), (("doctor",), 1)):
        answer = subprocess.run(
            (*RIGTRUE, *arguments), cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120
        )
        assert answer.returncode == code
        assert "apt-get install libegl1 libgl1 libgl1-mesa-dri" in answer.stdout + answer.stderr
        assert "Traceback" not in answer.stderr
    assert list(tmp_path.iterdir()) == []
