"""The files of a run folder: what is not finite, what was set, and files that no run wrote."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from estimator.bundle import FrameBundle
from estimator.errors import InputError
from estimator.estimate import CameraEstimate, Estimate, Match, Status
from estimator.se3 import SE3
from eval.collect import RunLog
from eval.header import RunHeader
from eval.json_text import json_text
from eval.report import rewrite_report, write_report
from eval.run_folder import final_rig, write_run_folder
from eval.scores import score
from tests.unit.eval.tiny_run import RIG, START_NS, run_log, straight, truth_of

NOWHERE = SE3(np.full((3, 3), np.nan), np.full(3, np.nan))
FOREIGN = ("{}", "[]", "no json", '{"cameras": 3, "reference": null, "metrics": []}')


def strictly(text: str) -> Any:
    """Parse JSON; NaN and Infinity, which Python would let through, are no JSON."""

    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} is no JSON")

    return json.loads(text, parse_constant=refuse)


def written(folder: Path, header: RunHeader) -> Mapping[str, Any]:
    log = run_log(straight(5))
    write_run_folder(folder, log, score(log, None), header, RIG, None)
    return dict(strictly((folder / "scores.json").read_text()))


def test_the_final_rig_has_the_lenses_that_were_refined() -> None:
    log = run_log(straight(3))
    refined = replace(RIG["rear"].camera, focal_px=(41.0, 41.0))
    cameras = dict(log.final.cameras)
    cameras["rear"] = replace(cameras["rear"], camera=refined)
    log.finish(replace(log.final, cameras=cameras))
    rig = final_rig(log, RIG)
    assert rig["rear"].camera == refined and rig["left"].camera == RIG["left"].camera


@pytest.mark.parametrize("number", [np.nan, np.inf, -np.inf])
def test_a_number_that_is_not_finite_is_written_as_null(number: float) -> None:
    value = {"a": [1.5, number, (np.float64(number), "b")], "c": {"d": number, "e": None, "f": True}}
    assert strictly(json_text(value)) == {
        "a": [1.5, None, [None, "b"]],
        "c": {"d": None, "e": None, "f": True},
    }


@pytest.mark.parametrize("truth", [None, truth_of(straight(3))], ids=["no truth", "truth"])
@pytest.mark.parametrize("number", [np.nan, np.inf])
def test_an_estimator_that_answers_no_finite_number_gets_a_run_folder(
    tmp_path: Path, number: float, truth: Any
) -> None:
    log = RunLog(RIG)
    cameras = {name: CameraEstimate(NOWHERE, np.full((6, 6), number), Status.LOST) for name in RIG.cameras}
    image = np.zeros((40, 64), np.uint8)
    for stamp_ns in (START_NS, START_NS + 1):
        estimate = Estimate(
            stamp_ns,
            cameras,
            NOWHERE,
            tracks_px={"front": np.full((2, 4), number)},
            matches=[Match("left", stamp_ns, (number, 6.0), "front", stamp_ns, (7.0, number))],
            stage_s={"track": number},
            trajectory=[(stamp_ns, NOWHERE)],
        )
        log.add(FrameBundle(stamp_ns, dict.fromkeys(RIG.cameras, image)), estimate)
    log.finish(estimate)
    header = RunHeader("bare", None, None, "bare", {"load": number})
    write_run_folder(tmp_path / "run", log, score(log, truth), header, RIG, truth)
    assert strictly((tmp_path / "run" / "scores.json").read_text())["provenance"] == {"load": None}
    strictly((tmp_path / "run" / "report_data.json").read_text())


def test_what_was_set_is_in_the_scores_and_in_the_header_of_the_report(tmp_path: Path) -> None:
    settings = {"drive.rate_hz": 30, "rig": "./<b>.yaml", "street": {"length_m": 90.5}}
    header = RunHeader("first_drive", None, 0, "online", settings=settings)
    assert written(tmp_path / "run", header)["settings"] == settings
    page = (tmp_path / "run" / "report.html").read_text()
    assert "set: drive.rate_hz=30, rig=./&lt;b&gt;.yaml, street={" in page.partition("</header>")[0]


def test_without_settings_the_report_speaks_of_none(tmp_path: Path) -> None:
    assert written(tmp_path / "run", RunHeader("first_drive", None, 0, "online"))["settings"] == {}
    assert "set: " not in (tmp_path / "run" / "report.html").read_text().partition("</header>")[0]


def test_a_run_from_before_settings_were_kept_still_has_a_report(tmp_path: Path) -> None:
    scores = dict(written(tmp_path / "run", RunHeader("first_drive", None, 0, "online")))
    before = (tmp_path / "run" / "report.html").read_bytes()
    del scores["settings"]
    (tmp_path / "run" / "scores.json").write_text(json.dumps(scores))
    assert write_report(tmp_path / "run").read_bytes() == before


@pytest.mark.parametrize("name", ["scores.json", "report_data.json"])
@pytest.mark.parametrize("content", FOREIGN)
def test_a_file_that_no_run_wrote_is_refused_in_one_line(tmp_path: Path, name: str, content: str) -> None:
    written(tmp_path / "run", RunHeader("first_drive", None, 0, "online"))
    (tmp_path / "run" / name).write_text(content)
    with pytest.raises(InputError, match=r"report_data\.json|scores\.json") as caught:
        rewrite_report(tmp_path / "run")
    assert str(tmp_path / "run") in str(caught.value) and "\n" not in str(caught.value)
