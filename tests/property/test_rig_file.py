"""Any rig survives its file; any flaw planted anywhere in one is refused with its path."""

from __future__ import annotations

import copy
import tempfile
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ruamel.yaml import YAML

from estimator.camera import COEFFICIENT_COUNT, Camera, CameraModel
from estimator.errors import InputError
from estimator.rig import MountedCamera, Rig, RigPrior
from estimator.rig_file import read_rig, rig_to_yaml
from estimator.se3 import SE3

names = st.text("abcdefghijklmnopqrstuvwxyz_0123456789-é", min_size=1, max_size=12).filter(
    lambda name: name not in {"worst", "median"}
)


across_road = st.tuples(st.floats(-5, 5), st.floats(-5, 5))
height_m = st.floats(1e-3, 5)


@st.composite
def mounted_cameras(draw: st.DrawFn) -> MountedCamera:
    model: CameraModel = draw(st.sampled_from(list(COEFFICIENT_COUNT)))
    size = (draw(st.integers(1, 9000)), draw(st.integers(1, 9000)))
    # A lens that sees its own image: the reader refuses those that turn back within most of it.
    focal = tuple(max(size) * draw(st.floats(0.8, 30)) for _ in size)
    center = tuple(side * draw(st.floats(0.3, 0.7)) for side in size)
    distortion = tuple(draw(st.floats(-0.05, 0.05)) for _ in range(COEFFICIENT_COUNT[model]))
    tangent = np.array([draw(st.floats(-3, 3)) for _ in range(6)])
    camera = Camera(model, size, (focal[0], focal[1]), (center[0], center[1]), distortion)
    return MountedCamera(camera, SE3.exp(tangent))


@st.composite
def rigs(draw: st.DrawFn) -> Rig:
    cameras = draw(st.dictionaries(names, mounted_cameras(), min_size=1, max_size=4))
    prior = RigPrior(draw(st.floats(1e-3, 90)), draw(st.floats(1e-3, 1e4)))
    reference = draw(st.sampled_from(list(cameras)))
    # The reader wants the reference above the road, since its height gives the scale.
    raised = SE3(cameras[reference].ego_from_cam.rotation, np.array([*draw(across_road), draw(height_m)]))
    cameras[reference] = MountedCamera(cameras[reference].camera, raised)
    return Rig(reference, cameras, prior)


def read_text(text: str) -> Rig:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rig.yaml"
        file.write_text(text, encoding="utf-8")
        return read_rig(file)


@given(rigs())
@settings(deadline=None, max_examples=60)
def test_a_rig_survives_its_file(rig: Rig) -> None:
    text = rig_to_yaml(rig)
    assert rig_to_yaml(rig) == text
    again = read_text(text)
    assert (again.reference, list(again.cameras), again.prior) == (
        rig.reference,
        list(rig.cameras),
        rig.prior,
    )
    for name, mounted in rig.cameras.items():
        assert again[name].camera == mounted.camera
        np.testing.assert_allclose(again[name].ego_from_cam.matrix, mounted.ego_from_cam.matrix, atol=1e-9)


GOOD: dict[str, Any] = {
    "reference": "front",
    "cameras": {
        name: {
            "model": "kannala_brandt",
            "size_px": [640, 400],
            "focal_px": [457.0, 457.0],
            "center_px": [319.5, 199.5],
            "distortion": [0.1, 0.0, 0.0, 0.0],
            "ego_from_cam": {"translation_m": [1.8, 0.1, 1.45], "quaternion_xyzw": [-0.5, 0.5, -0.5, 0.5]},
        }
        for name in ("front", "rear")
    },
    "prior": {"rotation_deg": 3.0, "translation_mm": 100.0},
}


def places(node: Any, path: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Return the path of every value in the file but the root."""
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    return [found for key, child in children for found in ((*path, key), *places(child, (*path, key)))]


def written(path: tuple[str | int, ...]) -> str:
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path).lstrip(".")


def refusal(values: dict[str, Any]) -> str:
    text = StringIO()
    YAML(typ="safe", pure=True).dump(values, text)
    with pytest.raises(InputError) as caught:
        read_text(text.getvalue())
    message = str(caught.value)
    assert "\n" not in message
    return message


@given(st.sampled_from(places(GOOD)), st.sampled_from([float("nan"), None, "wrong", [], {}, True, -1e9]))
@settings(deadline=None, max_examples=150)
def test_a_wrong_value_anywhere_is_refused_with_its_path(path: tuple[str | int, ...], wrong: Any) -> None:
    values = copy.deepcopy(GOOD)
    parent: Any = values
    for part in path[:-1]:
        parent = parent[part]
    free_sign = path[-2:-1] in (("center_px",), ("distortion",), ("translation_m",))
    if (wrong == -1e9 and free_sign) or (wrong == {} and path[-1] == "prior"):
        return  # these are right there
    parent[path[-1]] = wrong
    message = refusal(values)
    # a quaternion is judged as a whole; the rest is told at the place or below it
    whole = written(path[:-1]) if path[-2:-1] == ("quaternion_xyzw",) and wrong == -1e9 else written(path)
    assert f": {whole}" in message


@given(st.sampled_from([p for p in places(GOOD) if not isinstance(p[-1], int)]), names)
@settings(deadline=None, max_examples=80)
def test_an_unknown_key_anywhere_is_refused_with_its_path(path: tuple[str | int, ...], extra: str) -> None:
    values = copy.deepcopy(GOOD)
    parent: Any = values
    for part in path[:-1]:
        parent = parent[part]
    if extra in parent or path == ("cameras", "front") or path == ("cameras", "rear"):
        return
    parent[extra] = 1
    assert f"{written((*path[:-1], extra))}: unknown key; there are: " in refusal(values)
