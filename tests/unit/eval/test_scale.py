"""What a run tells of its metres and its weak axes: terminal, events, report."""

import json
from dataclasses import replace

from estimator.estimate import Estimate, Status
from estimator.scale import NOMINAL_RIG, REAR_AXLE, ROAD, scale_evidence
from eval.collect import RunLog
from eval.scale import scale_line
from eval.tables import events_jsonl
from tests.unit.eval.test_report import page
from tests.unit.eval.tiny_run import run_log, straight

EVIDENCE = scale_evidence({ROAD: 9.5e4, REAR_AXLE: 400.0, NOMINAL_RIG: 4600.0}, 0.002)


def log_of(final: Estimate) -> RunLog:
    log = run_log(straight(4))
    log.finish(final)
    return log


def told() -> Estimate:
    """Return an answer that says where its metres come from and that the rear camera's height is weak."""
    final = run_log(straight(4)).final
    rear = replace(final.cameras["rear"], status=Status.WEAK, weak_axes=("yaw", "height"))
    return replace(final, scale=EVIDENCE, cameras={**final.cameras, "rear": rear})


def test_the_terminal_names_the_largest_source_first_and_writes_no_share_as_nothing():
    line = scale_line(told())
    assert line is not None and line.startswith("scale: sigma 0.37 %")
    assert line.endswith("from road 95 %, nominal rig 5 %, rear axle < 1 %")


def test_the_last_event_is_the_evidence_for_scale():
    event = json.loads(events_jsonl(log_of(told()), ()).splitlines()[-1])
    assert event["event"] == "scale" and event["common_sigma_percent"] == 0.2
    assert abs(sum(event["share"].values()) - 1) < 1e-4


def test_the_report_shows_the_sources_and_names_the_weak_axes():
    text = page(log_of(told()), None)
    assert "Where the metres come from" in text and "nominal rig 5 %" in text
    assert "weak in yaw, height" in text


def test_an_estimator_that_says_nothing_of_scale_gets_no_line_event_or_bar():
    log = run_log(straight(4))
    assert scale_line(log.final) is None
    assert '"scale"' not in events_jsonl(log, ())
    assert "Where the metres come from" not in page(log, None)
