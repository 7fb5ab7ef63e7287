"""Rigs as YAML files, both ways. What a file may hold is in ``estimator.rig_schema``."""

from __future__ import annotations

from collections.abc import Iterable
from io import StringIO
from pathlib import Path

from pydantic import ValidationError
from ruamel.yaml import YAML
from ruamel.yaml.comments import CommentedMap, CommentedSeq

from estimator.config_error import describe_first_error
from estimator.errors import InputError
from estimator.rig import MountedCamera, Rig
from estimator.rig_schema import RigEntry
from estimator.yaml_file import read_yaml

_POSE_DECIMALS = 12
_LINE_WIDTH = 1000  # never fold a list


def read_rig(path: Path | str) -> Rig:
    """Read a rig file; quaternions are normalised, a missing ``prior`` is the default one.

    Raises:
        InputError: One line with the file, the path of the key, what was got and what was wanted.
    """
    path = Path(path)
    values = read_yaml(path, "rig file")
    if not isinstance(values, dict):
        raise InputError(f"{path}: got {type(values).__name__}, wanted a rig: keys reference, cameras, prior")
    try:
        return RigEntry.model_validate(values).rig()
    except ValidationError as error:
        raise InputError(f"{path}: {describe_first_error(error, RigEntry)}") from None


def write_rig(rig: Rig, path: Path | str) -> None:
    """Write a rig file. The same rig gives the same bytes, and reading them gives the rig to 1e-9."""
    Path(path).write_text(rig_to_yaml(rig), encoding="utf-8", newline="\n")


def rig_to_yaml(rig: Rig) -> str:
    """Return the text of a rig file: one line a field, small lists in brackets."""
    cameras = CommentedMap((name, _camera_entry(mounted)) for name, mounted in rig.cameras.items())
    prior = _flow_map(rotation_deg=rig.prior.rotation_deg, translation_mm=rig.prior.translation_mm)
    yaml = YAML(pure=True)
    yaml.width = _LINE_WIDTH
    text = StringIO()
    yaml.dump(CommentedMap(reference=rig.reference, cameras=cameras, prior=prior), text)
    return text.getvalue()


def _camera_entry(mounted: MountedCamera) -> CommentedMap:
    camera, pose = mounted.camera, mounted.ego_from_cam
    return CommentedMap(
        model=camera.model,
        size_px=_flow_list(camera.size_px),
        focal_px=_flow_list(map(float, camera.focal_px)),
        center_px=_flow_list(map(float, camera.center_px)),
        distortion=_flow_list(map(float, camera.distortion)),
        ego_from_cam=_flow_map(
            translation_m=_flow_list(_rounded(pose.translation)),
            quaternion_xyzw=_flow_list(_rounded(pose.quaternion_xyzw)),
        ),
    )


def _rounded(values: Iterable[float]) -> Iterable[float]:
    """Drop the digits that differ between machines; adding zero turns -0.0 into 0.0."""
    return (round(float(value), _POSE_DECIMALS) + 0.0 for value in values)


def _flow_list(values: Iterable[float]) -> CommentedSeq:
    result = CommentedSeq(values)
    result.fa.set_flow_style()
    return result


def _flow_map(**values: object) -> CommentedMap:
    result = CommentedMap(**values)
    result.fa.set_flow_style()
    return result
