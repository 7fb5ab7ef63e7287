"""A machine whose loader finds no OpenGL: what must render says so in one line, all else works."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.integration.conftest import Command

NOMINAL = "tests.throwaway_estimators:Nominal"
INSTALL = "apt-get install libegl1 libgl1 libgl1-mesa-dri"
# Python runs a module of this name at its start, in worker processes too.
SITECUSTOMIZE = """
import ctypes, re

class Refusing(ctypes.CDLL):
    def __init__(self, name, *arguments, **options):
        if re.search(r"lib(EGL|GL|OpenGL|GLESv\\w*|OSMesa)\\.so", str(name)):
            raise OSError(f"{name}: cannot open shared object file: No such file or directory")
        super().__init__(name, *arguments, **options)

ctypes.CDLL = ctypes.cdll._dlltype = Refusing
"""
LOADS_EGL = "import ctypes; ctypes.CDLL('libEGL.so.1')"


@pytest.fixture(params=["", "osmesa"])
def environment(request: pytest.FixtureRequest, house: Path, tmp_path: Path) -> dict[str, str]:
    """The environment of such a machine, without and with a choice of ``MUJOCO_GL``."""
    folder = tmp_path / "python"
    folder.mkdir()
    (folder / "sitecustomize.py").write_text(SITECUSTOMIZE)
    environment = os.environ | {
        "PYTHONPATH": str(folder),
        "MUJOCO_GL": request.param,
        "PYOPENGL_PLATFORM": "",
    }
    loading = subprocess.run(
        (sys.executable, "-c", LOADS_EGL), env=environment, capture_output=True, text=True
    )
    assert "libEGL.so.1: cannot open" in loading.stderr, "this test hides no library"
    return environment


def rigtrue(
    environment: dict[str, str], folder: Path, *arguments: object
) -> subprocess.CompletedProcess[str]:
    words = (sys.executable, "-c", "from eval.cli import main; main()", *map(str, arguments))
    return subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)


def test_doctor_names_the_remedy(environment: dict[str, str], tmp_path: Path) -> None:
    answer = rigtrue(environment, tmp_path, "doctor")
    assert answer.returncode == 1 and answer.stderr == ""
    osmesa = environment["MUJOCO_GL"] == "osmesa"
    assert f"BAD   {'osmesa: libOSMesa.so.8' if osmesa else 'egl: libEGL.so.1'} is missing" in answer.stdout
    assert f"to mend opengl: {'apt-get install libosmesa6' if osmesa else INSTALL}\n" in answer.stdout


@pytest.mark.parametrize(
    "arguments", ["run {tiny} --seed 6 --quiet", "record {tiny} --seed 6 --quiet --out bag"]
)
def test_what_must_render_is_refused_in_one_line(
    environment: dict[str, str], tiny: str, tmp_path: Path, arguments: str
) -> None:
    answer = rigtrue(environment, tmp_path, *arguments.format(tiny=tiny).split())
    assert answer.returncode == 2 and answer.stdout == ""
    assert answer.stderr.startswith("error: no off-screen OpenGL on this machine (")
    assert "is missing)" in answer.stderr and INSTALL in answer.stderr and answer.stderr.count("\n") == 1


def test_a_sweep_is_refused_once_unless_all_is_recorded(
    environment: dict[str, str], command: Command, tiny: str, tmp_path: Path
) -> None:
    assert command("record", tiny, "--out", "bag", "--quiet") == 0  # of seed 0, kept in the cache too
    for seed, code in ((6, 2), (0, 0)):
        (tmp_path / "some.yaml").write_text(
            f"about: A sweep.\nscenarios: [{tiny}]\nseeds: [{seed}]\nestimators: ['{NOMINAL}']\n"
        )
        answer = rigtrue(environment, tmp_path, "sweep", "./some.yaml", "--quiet", "--out", f"sweep{seed}")
        assert answer.returncode == code, answer.stderr
        assert (tmp_path / f"sweep{seed}").exists() == (code == 0)
        if code:
            assert answer.stderr.startswith("error: no off-screen OpenGL") and answer.stderr.count("\n") == 1
        else:
            again = rigtrue(environment, tmp_path, "sweep", "./some.yaml", "--out", f"sweep{seed}")
            assert "1 of 1 runs are there already" in again.stdout + again.stderr


def test_a_recording_is_replayed(
    environment: dict[str, str], command: Command, house: Path, tiny: str, tmp_path: Path
) -> None:
    assert command("record", tiny, "--out", "bag", "--quiet") == 0
    arguments = ("bag", "--rig", house / "tiny_rig.yaml", "--estimator", NOMINAL, "--out", "replayed")
    answer = rigtrue(environment, tmp_path, "replay", *arguments)
    assert answer.returncode == 0, answer.stderr
    assert (tmp_path / "replayed" / "scores.json").is_file()
