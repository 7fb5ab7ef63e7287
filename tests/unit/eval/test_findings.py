"""Findings from an estimator's answers to events, to the page and to the terminal."""

from __future__ import annotations

import json
from dataclasses import replace

from estimator.estimate import Estimate
from estimator.finding import Finding, FindingKind
from eval.collect import RunLog
from eval.findings import finding_line, finding_rows, spells
from eval.header import RunHeader
from eval.report import render
from eval.report_data import report_data
from eval.run_folder import scores_json
from eval.scores import score
from eval.tables import events_jsonl
from tests.unit.eval.tiny_run import START_NS, STEP_NS, run_log, straight

BLACK = Finding(FindingKind.NO_TEXTURE, ("rear",), "rear has shown nothing", doubtful=False)
SWAPPED = Finding(FindingKind.SWAPPED_CAMERAS, ("left", "rear"), "swapped")
HOSTILE = replace(SWAPPED, about="</td></table><script>alert(1)</script>\x1b[31m<img src=x onerror=alert(2)>")


def log_of(found: list[tuple[Finding, ...]], final: tuple[Finding, ...]) -> RunLog:
    """Return the log of an estimator that noticed something at every bundle, and at its close."""
    log = run_log(straight(len(found)))
    log.entries[:] = [
        replace(entry, findings=findings) for entry, findings in zip(log.entries, found, strict=True)
    ]
    log.finish(Estimate(log.last_stamp_ns, log.final.cameras, findings=final))
    return log


def page(log: RunLog) -> str:
    header = RunHeader("bare", None, None, "bare")
    scores = json.loads(json.dumps(scores_json(score(log, None), header)))
    return render(scores, json.loads(json.dumps(report_data(log, header, None))))


def test_a_finding_lasts_from_its_first_bundle_to_the_first_without_it() -> None:
    black = spells(log_of([(), (BLACK,), (BLACK,), (), ()], ()))
    assert [(spell.begin_ns, spell.end_ns) for spell in black] == [
        (START_NS + STEP_NS, START_NS + 3 * STEP_NS)
    ]


def test_one_that_changes_its_words_goes_on_and_is_told_as_it_stood_last() -> None:
    longer = replace(BLACK, about="rear has shown nothing for long")
    (spell,) = spells(log_of([(BLACK,), (longer,)], (longer,)))
    assert spell.end_ns is None and spell.finding == longer and spell.begun_as == BLACK


def test_one_that_comes_back_is_told_twice() -> None:
    assert len(spells(log_of([(BLACK,), (), (BLACK,)], ()))) == 2


def test_what_only_the_close_found_is_told() -> None:
    assert [row["kind"] for row in finding_rows(log_of([(), ()], (SWAPPED,)))] == ["swapped_cameras"]


def test_events_tell_when_findings_begin_and_end() -> None:
    log = log_of([(), (BLACK,), ()], ())
    events = [json.loads(line) for line in events_jsonl(log, ()).splitlines()]
    begins, ends = (event for event in events if event["event"] == "finding")
    assert begins == {
        "event": "finding",
        "stamp_ns": START_NS + STEP_NS,
        "kind": "no_texture",
        "cameras": ["rear"],
        "about": BLACK.about,
        "state": "begins",
    }
    assert ends == begins | {"stamp_ns": START_NS + 2 * STEP_NS, "state": "ends"}
    assert [event["stamp_ns"] for event in events] == sorted(event["stamp_ns"] for event in events)


def test_the_page_shows_findings_before_the_pictures_and_says_which_poses_are_in_doubt() -> None:
    text = page(log_of([(BLACK,), (BLACK, SWAPPED)], (SWAPPED,)))
    assert text.index('id="findings"') < text.index('id="seen"')
    assert "pose in doubt" in text and "left, rear" in text and "rear has shown nothing" in text


def test_a_page_without_findings_has_no_such_section() -> None:
    assert 'id="findings"' not in page(log_of([()], ()))


def test_markup_in_a_finding_stays_text() -> None:
    text = page(log_of([(HOSTILE,)], (HOSTILE,)))
    assert "<script>alert" not in text and "<img src=x" not in text
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in text


def test_a_line_for_the_terminal_carries_no_control_characters() -> None:
    assert finding_line(SWAPPED) == "swapped_cameras: left, rear (in doubt): swapped"
    assert "\x1b" not in finding_line(HOSTILE) and "\n" not in finding_line(replace(BLACK, about="a\nb"))
