"""Rig files, good and bad."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from estimator.errors import InputError
from estimator.rig import Rig
from estimator.rig_file import read_rig, rig_to_yaml, write_rig

TEXT = """\
reference: front
cameras:
  front:
    model: pinhole
    size_px: [640, 400]
    focal_px: [457.0, 457.0]
    center_px: [319.5, 199.5]
    distortion: []
    ego_from_cam: {translation_m: [1.8, 0.1, 1.45], quaternion_xyzw: [-0.5, 0.5, -0.5, 0.5]}
  rear:
    model: brown_conrady
    size_px: [640, 400]
    focal_px: [320.00000000000006, 319.0]
    center_px: [319.5, 199.5]
    distortion: [-0.31, 0.11, 0.001, -0.0008, -0.018]
    ego_from_cam: {translation_m: [-1.9, 0.0, 1.2], quaternion_xyzw: [-0.5, -0.5, 0.5, 0.5]}
prior: {rotation_deg: 3.0, translation_mm: 100.0}
"""


def read_text(tmp_path: Path, text: str) -> Rig:
    file = tmp_path / "rig.yaml"
    file.write_text(text)
    return read_rig(file)


def refusal(tmp_path: Path, text: str) -> str:
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, text)
    message = str(caught.value)
    assert "\n" not in message
    assert message.startswith(str(tmp_path / "rig.yaml"))
    return message


def test_what_is_read_is_written_again_to_the_byte(tmp_path: Path) -> None:
    assert rig_to_yaml(read_text(tmp_path, TEXT)) == TEXT


def test_the_values_arrive(tmp_path: Path) -> None:
    rig = read_text(tmp_path, TEXT)
    assert rig.reference == "front" and list(rig.cameras) == ["front", "rear"]
    camera = rig["rear"].camera
    assert (camera.model, camera.size_px, camera.focal_px) == (
        "brown_conrady",
        (640, 400),
        (320.00000000000006, 319.0),
    )
    assert camera.distortion == (-0.31, 0.11, 0.001, -0.0008, -0.018)
    forward_ego = rig["front"].ego_from_cam.rotation @ [0.0, 0.0, 1.0]
    np.testing.assert_allclose(forward_ego, [1.0, 0.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(
        rig["rear"].ego_from_cam.rotation @ [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], atol=1e-12
    )


def test_prior_and_pinhole_distortion_may_be_left_out(tmp_path: Path) -> None:
    text = TEXT.replace("prior: {rotation_deg: 3.0, translation_mm: 100.0}\n", "")
    rig = read_text(tmp_path, text.replace("    distortion: []\n", ""))
    assert (rig.prior.rotation_deg, rig.prior.translation_mm) == (3.0, 100.0)
    assert rig["front"].camera.distortion == ()


def test_a_rounded_quaternion_is_normalised(tmp_path: Path) -> None:
    rig = read_text(tmp_path, TEXT.replace("[-0.5, 0.5, -0.5, 0.5]", "[-0.5004, 0.5, -0.5, 0.5]"))
    rotation = rig["front"].ego_from_cam.rotation
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)


def test_writing_makes_a_file_that_reads_back(tmp_path: Path) -> None:
    rig = read_text(tmp_path, TEXT)
    write_rig(rig, tmp_path / "again.yaml")
    assert rig_to_yaml(read_rig(tmp_path / "again.yaml")) == TEXT


BAD = [
    ("[640, 400]", "[-640, 400]", "cameras.front.size_px[0]: got -640, wanted over 0 to 100000"),
    ("[640, 400]", "[640.5, 400]", "cameras.front.size_px[0]: got 640.5, wanted an integer"),
    ("[640, 400]", "[true, 400]", "cameras.front.size_px[0]: got True, wanted an integer"),
    ("[640, 400]", "[640]", "cameras.front.size_px[1]: missing"),
    ("[640, 400]", "[640, 400, 3]", "cameras.front.size_px: got 3 values, wanted 2"),
    ("[640, 400]", "640", "cameras.front.size_px: got 640, wanted a list"),
    ("[457.0, 457.0]", "[.nan, 457.0]", "cameras.front.focal_px[0]: got nan, wanted a finite number"),
    ("[457.0, 457.0]", "[457.0, -1]", "cameras.front.focal_px[1]: got -1, wanted greater than 0"),
    ("[319.5, 199.5]", "[.inf, 199.5]", "cameras.front.center_px[0]: got inf"),
    ("[319.5, 199.5]", "['a', 199.5]", "cameras.front.center_px[0]: got 'a', wanted a number"),
    ("-0.018]", "-0.018, 0]", "cameras.rear.distortion: got 6 coefficients, wanted 5 for brown_conrady"),
    ("distortion: []", "distortion: [0.1]", "cameras.front.distortion: got 1 coefficients, wanted 0"),
    (
        "model: pinhole",
        "model: fish",
        "cameras.front.model: got 'fish', wanted 'pinhole', 'brown_conrady' or",
    ),
    ("model: pinhole", "modell: pinhole", "cameras.front.modell: unknown key; there are: center_px"),
    ("    model: pinhole\n", "", "cameras.front.model: missing"),
    (
        "[-0.5, 0.5, -0.5, 0.5]",
        "[0, 0, 0, 0]",
        "cameras.front.ego_from_cam.quaternion_xyzw: got a quaternion of",
    ),
    (
        "[-0.5, 0.5, -0.5, 0.5]",
        "[-0.5, 0.5, -0.5, 0.6]",
        "quaternion of norm 1.05357, wanted a rotation: norm 1",
    ),
    ("[1.8, 0.1, 1.45]", "[1.8, .nan, 1.45]", "cameras.front.ego_from_cam.translation_m[1]: got nan"),
    (
        "reference: front",
        "reference: roof",
        "reference: got 'roof', wanted one of the cameras; there are: front, rear",
    ),
    (
        "reference: front",
        "references: front",
        "references: unknown key; there are: cameras, prior, reference",
    ),
    ("reference: front\n", "", "reference: missing"),
    ("  rear:", "  front:", "line 10: key 'front' is given twice"),
    ("  rear:", '  "":', "got the camera name ''"),
    ("  rear:", "  rear/left:", "got the camera name 'rear/left'"),
    ("  rear:", "  worst:", "got the camera name 'worst'"),
    ("  rear:", "  3:", "cameras[3]: got 3, wanted a string"),
    ("rotation_deg: 3.0", "rotation_deg: 0", "prior.rotation_deg: got 0, wanted greater than 0"),
    ("rotation_deg: 3.0", "rotation_mm: 3.0", "prior.rotation_mm: unknown key; there are: rotation_deg"),
    (
        "prior: {rotation_deg: 3.0, translation_mm: 100.0}",
        "prior: 3",
        "prior: got 3, wanted keys with values",
    ),
    (
        "distortion: [-0.31",
        "distortion: [-5.0",
        "of the image a viewing ray, wanted at least 50%",
    ),
    ("[640, 400]", "[640, 400", "not valid YAML"),
    ("cameras:", "\tcameras:", "not valid YAML"),
    (TEXT, "", "got NoneType, wanted a rig"),
    (TEXT, "- 1\n", "got list, wanted a rig"),
    (TEXT, "[" * 500, "not valid YAML"),
    (TEXT, "a: !!python/object/apply:os.getcwd []", "not valid YAML"),
]


@pytest.mark.parametrize(("good", "bad", "message"), BAD)
def test_a_bad_file_is_refused_with_the_path_of_the_key(
    tmp_path: Path, good: str, bad: str, message: str
) -> None:
    assert message in refusal(tmp_path, TEXT.replace(good, bad, 1))


def test_what_is_no_rig_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "binary").write_bytes(b"\xff\xfe\x00\x01")
    for name, message in (("none.yaml", "no such rig file"), (".", "got a folder"), ("binary", "not text")):
        with pytest.raises(InputError, match=message):
            read_rig(tmp_path / name)


def test_a_reference_below_the_road_is_refused(tmp_path: Path) -> None:
    message = refusal(tmp_path, TEXT.replace("[1.8, 0.1, 1.45]", "[1.8, 0.1, -5.0]"))
    assert "reference: got 'front', whose translation_m has z = -5, wanted a camera above the road" in message
