"""The report as a person meets it: in a real browser, on a laptop and on a phone."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from estimator.errors import InputError
from eval.collect import RunLog
from eval.header import RunHeader
from eval.report import write_report
from eval.run_folder import write_run_folder
from eval.scores import score
from tests.unit.eval.tiny_run import RIG, off_by, run_log, straight, truth_of

EVIL = "<script>alert(1)</script>"
MAX_BYTES = 15_000_000


@dataclass
class Visit:
    """A page that was opened, and what happened meanwhile."""

    page: Page
    console: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)
    dialogs: list[str] = field(default_factory=list)


def starts(program: str) -> bool:
    """Tell a browser from a stub of its name that cannot start it."""
    return subprocess.run([program, "--version"], capture_output=True, timeout=60).returncode == 0


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    names = map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))
    path = next((name for name in names if name and starts(name)), None)
    if path is None:
        pytest.fail("no Chromium on this machine that starts; get one with: ./setup.sh browser")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        yield chromium
        chromium.close()


def shrinking_errors() -> RunLog:
    return run_log(
        straight(30),
        lambda index: {"left": off_by(2 / (1 + index), 100 / (1 + index)), "rear": off_by(0.01, 2)},
    )


@pytest.fixture(scope="module")
def run_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("runs") / "with-truth"
    log, truth = shrinking_errors(), truth_of(straight(30))
    header = RunHeader(
        EVIL, "d", 3, EVIL, {"cpu": EVIL, "versions": {"numpy": np.__version__}}, EVIL, (EVIL,)
    )
    write_run_folder(folder, log, score(log, truth), header, RIG, truth)
    return folder


@pytest.fixture(scope="module")
def run_folder_without_truth(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("runs") / "without-truth"
    log = shrinking_errors()
    write_run_folder(folder, log, score(log, None), RunHeader("own_drive", None, None, "online"), RIG, None)
    return folder


def visit(browser: Browser, folder: Path, width: int = 1280) -> Visit:
    context = browser.new_context(viewport={"width": width, "height": 800})
    seen = Visit(context.new_page())
    seen.page.on("console", lambda message: seen.console.append(message.text))
    seen.page.on("pageerror", lambda error: seen.console.append(str(error)))
    seen.page.on("request", lambda request: seen.requests.append(request.url))
    seen.page.on("dialog", lambda dialog: (seen.dialogs.append(dialog.message), dialog.dismiss()))
    seen.page.goto((folder / "report.html").as_uri())
    seen.page.wait_for_function(
        "Array.from(document.querySelectorAll('.plot')).every(p => p.querySelector('.main-svg'))"
    )
    return seen


@pytest.fixture(scope="module")
def with_truth(browser: Browser, run_folder: Path) -> Visit:
    return visit(browser, run_folder)


@pytest.fixture(scope="module")
def without_truth(browser: Browser, run_folder_without_truth: Path) -> Visit:
    return visit(browser, run_folder_without_truth)


@pytest.mark.parametrize("kind", ["with_truth", "without_truth"])
def test_the_page_is_quiet_and_asks_no_network(request, kind):
    seen = request.getfixturevalue(kind)
    assert seen.console == []
    assert seen.dialogs == []
    outside = [url for url in seen.requests if not url.startswith("data:")]
    assert outside == [seen.page.url]
    assert len(seen.page.content().encode()) < MAX_BYTES


@pytest.mark.parametrize("kind", ["with_truth", "without_truth"])
def test_every_figure_has_drawn_its_curves_and_names_its_axes(request, kind):
    page = request.getfixturevalue(kind).page
    figures = page.evaluate(
        """Array.from(document.querySelectorAll('.plot')).map(place => ({
            id: place.id,
            shapes: place.querySelectorAll('.trace path, .bars path').length,
            titles: ['x', 'y'].map(
                axis => place.querySelectorAll(`[class^="${axis}"][class$="title"]`).length),
        }))"""
    )
    cameras = {f"error-{index}" for index in range(len(RIG.estimated_names))}
    apart = {"apart"} if kind == "with_truth" else set()
    assert {figure["id"] for figure in figures} == {"path", "rig", "stages"} | cameras | apart
    for figure in figures:
        assert figure["shapes"] > 0, figure
        assert min(figure["titles"]) >= 1, figure


def test_text_from_outside_is_shown_and_not_run(with_truth, run_folder):
    seen = with_truth
    assert seen.page.title() == f"{EVIL} · rigtrue"
    assert seen.page.locator("header.top b").inner_text() == EVIL
    assert EVIL not in (run_folder / "report.html").read_text()
    assert seen.dialogs == []


def test_every_image_is_shown_with_its_tracks(with_truth):
    page = with_truth.page
    montage = page.locator("#seen > .row")
    assert montage.locator("svg").count() == len(RIG.cameras)
    assert montage.nth(0).locator("b").all_inner_texts() == ["left", "front"]
    assert montage.nth(1).locator("b").all_inner_texts() == ["rear"]
    assert montage.locator("polyline").count() == len(RIG.cameras)
    widths = page.evaluate(
        """Promise.all(Array.from(document.querySelectorAll('#seen > .row image')).map(element => {
            const image = new Image();
            image.src = element.getAttribute('href');
            return image.decode().then(() => image.naturalWidth);
        }))"""
    )
    assert widths == [64] * len(RIG.cameras)


def test_matches_are_drawn_between_their_two_images(with_truth):
    page = with_truth.page
    pair = page.locator(".pair")
    assert pair.count() == 1
    assert pair.locator("image").count() == 2
    assert pair.locator("line").count() == 1
    assert "front" in pair.inner_text() and "left" in pair.inner_text()


def test_the_headline_tells_the_worst_camera(with_truth):
    text = with_truth.page.locator(".verdict").inner_text()
    assert "Every camera was found" in text
    assert "0.067°" in text and "3.3 mm" in text and "left" in text


def test_without_truth_the_headline_claims_nothing(without_truth):
    page = without_truth.page
    assert "nothing here can check it" in page.locator(".verdict").inner_text()
    assert page.locator("tr.true").count() == 0


@pytest.mark.parametrize("width", [390, 768, 1280])
def test_the_page_never_scrolls_sideways(browser, run_folder, width):
    page = visit(browser, run_folder, width).page
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_null_metrics_show_their_reason(with_truth):
    page = with_truth.page
    row = page.locator("tr", has_text="extrinsics.worst.bound_ratio").first
    assert "no bound was computed for this run" in row.inner_text()


def test_the_report_can_be_made_again_from_the_folder(run_folder):
    before = (run_folder / "report.html").read_bytes()
    (run_folder / "report.html").unlink()
    assert write_report(run_folder).read_bytes() == before


def test_the_folder_holds_exactly_the_promised_files(run_folder, run_folder_without_truth):
    names = {path.name for path in run_folder.iterdir()}
    assert names == {
        *("scores.json", "extrinsics.csv", "rig.yaml", "trajectory.tum", "truth.tum"),
        *("events.jsonl", "report.html", "report_data.json"),
    }
    assert {path.name for path in run_folder_without_truth.iterdir()} == names - {"truth.tum"}
    scores = json.loads((run_folder / "scores.json").read_text())
    assert set(scores) == {
        *("schema", "scenario", "digest", "seed", "estimator", "settings", "provenance", "metrics")
    }
    assert scores["schema"] == 1


def test_truth_changes_nothing_that_the_estimator_answered(run_folder, run_folder_without_truth):
    for name in ("rig.yaml", "extrinsics.csv", "trajectory.tum"):
        assert (run_folder / name).read_bytes() == (run_folder_without_truth / name).read_bytes()


def test_a_folder_that_exists_is_left_alone(run_folder, tmp_path):
    (tmp_path / "mine.txt").write_text("keep")
    log = shrinking_errors()
    with pytest.raises(InputError, match="exists"):
        write_run_folder(tmp_path, log, score(log, None), RunHeader("a", None, None, "b"), RIG, None)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


def test_a_failure_while_writing_leaves_nothing(tmp_path):
    log = shrinking_errors()
    header = RunHeader("a", None, None, "b", {"not json": object()})
    with pytest.raises(TypeError):
        write_run_folder(tmp_path / "run", log, score(log, None), header, RIG, None)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_without_a_run_is_refused_in_one_line(tmp_path):
    with pytest.raises(InputError, match=r"holds no scores\.json"):
        write_report(tmp_path)
