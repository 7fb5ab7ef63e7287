"""The text files of a run folder."""

import csv
import json
from io import StringIO

import numpy as np

from estimator.estimate import Status
from estimator.se3 import SE3
from eval.run_folder import final_rig
from eval.tables import events_jsonl, extrinsics_csv, seconds_text, tum
from eval.trajectory import Trajectory
from tests.unit.eval.tiny_run import RIG, START_NS, off_by, run_log, straight

COLUMNS = (
    "stamp_ns,camera,tx_m,ty_m,tz_m,qx,qy,qz,qw,sigma_rx_rad,sigma_ry_rad,sigma_rz_rad,"
    "sigma_tx_m,sigma_ty_m,sigma_tz_m,status"
)


def test_the_csv_has_exactly_these_columns_and_a_row_a_bundle_and_camera():
    text = extrinsics_csv(run_log(straight(3)))
    assert text.splitlines()[0] == COLUMNS
    rows = list(csv.DictReader(StringIO(text)))
    assert [row["camera"] for row in rows] == ["front", "left", "rear"] * 3
    assert rows[0]["sigma_rx_rad"] == "0.000000000"
    assert rows[1]["sigma_tx_m"] == "0.010000000"
    assert rows[1]["status"] == "converged"


def test_the_csv_row_gives_the_pose_back():
    rows = list(
        csv.DictReader(StringIO(extrinsics_csv(run_log(straight(1), lambda index: {"left": off_by(1, 50)}))))
    )
    quaternion = np.array([float(rows[1][name]) for name in ("qx", "qy", "qz", "qw")])
    translation = np.array([float(rows[1][name]) for name in ("tx_m", "ty_m", "tz_m")])
    pose = SE3.from_quaternion_xyzw(quaternion, translation)
    assert np.abs(RIG["left"].ego_from_cam.local(pose) - off_by(1, 50)).max() < 1e-8


def test_a_pose_that_is_not_finite_is_written_as_such_and_never_as_an_answer():
    text = extrinsics_csv(run_log(straight(1), lambda index: {"left": np.full(6, np.nan)}))
    row = next(row for row in csv.DictReader(StringIO(text)) if row["camera"] == "left")
    assert row["tx_m"] == row["qw"] == "nan"


def test_tum_seconds_are_exact_to_the_nanosecond():
    line = tum(Trajectory.from_poses([START_NS + 1], [SE3(np.eye(3), np.array([1.0, -2.0, 0.0]))]))
    zero, one = "0.000000000", "1.000000000"
    assert line == " ".join(["1700000000.000000001", one, "-2.000000000", zero, zero, zero, zero, one]) + "\n"


def test_seconds_of_small_and_negative_stamps():
    assert [seconds_text(ns) for ns in (0, 5, -5, 10**9)] == [
        "0.000000000",
        "0.000000005",
        "-0.000000005",
        "1.000000000",
    ]


def test_events_are_warnings_then_changes_of_status():
    log = run_log(straight(4), statuses_at=lambda index: {"rear": Status.WEAK} if index < 2 else {})
    events = [json.loads(line) for line in events_jsonl(log, ("cut short",)).splitlines()]
    assert events[0] == {"event": "warning", "text": "cut short"}
    assert [(event["camera"], event["from"], event["to"]) for event in events[1:]] == [
        ("left", None, "converged"),
        ("rear", None, "weak"),
        ("rear", "weak", "converged"),
    ]


def test_the_final_rig_keeps_the_reference_and_a_camera_without_a_finite_answer():
    log = run_log(
        straight(2), lambda index: {"front": off_by(5, 5), "left": off_by(1, 1), "rear": np.full(6, np.nan)}
    )
    rig = final_rig(log, RIG)
    assert rig["front"] is not None
    assert np.array_equal(rig["front"].ego_from_cam.matrix, RIG["front"].ego_from_cam.matrix)
    assert np.array_equal(rig["rear"].ego_from_cam.matrix, RIG["rear"].ego_from_cam.matrix)
    assert np.allclose(RIG["left"].ego_from_cam.local(rig["left"].ego_from_cam), off_by(1, 1))
