"""Tell in one line what pydantic found wrong: the path of the key, what was got, what was wanted."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from estimator.config_path import follow
from estimator.config_range import range_at
from estimator.did_you_mean import did_you_mean

_LONGEST = 60


def describe_first_error(error: ValidationError, model: type[BaseModel]) -> str:
    """Return ``path: what is wrong`` for the first thing wrong; ``model`` is the root that was validated."""
    details = error.errors(include_url=False)
    # an unknown key often explains the key that is missing, so it is told first
    first = next((each for each in details if each["type"] == "extra_forbidden"), details[0])
    location, _ = follow(model, first["loc"])
    path = key_path(location)
    got = _shorten(first["input"])
    if first["type"] == "missing":
        return f"{path}: missing"
    if first["type"] == "extra_forbidden":
        keys = _keys_at(model, first["loc"][:-1])
        there = f"; there are: {', '.join(keys)}" if keys else ""
        return f"{path}: unknown key{there}{did_you_mean(str(first['loc'][-1]), keys)}"
    if first["type"] == "union_tag_not_found":
        return f"{key_path([*location, _tag_key(first)])}: missing"
    if first["type"] == "union_tag_invalid":
        there = first["ctx"]["expected_tags"].replace("'", "")
        return f"{key_path([*location, _tag_key(first)])}: got {first['ctx']['tag']!r}, wanted one of {there}"
    if first["type"] in ("model_type", "dict_type", "model_attributes_type"):
        return f"{path}: got {got}, wanted keys with values"
    if first["type"] in ("too_short", "too_long"):
        context = first["ctx"]
        wanted = context.get("min_length", context.get("max_length"))
        return f"{path}: got {context['actual_length']} values, wanted {wanted}"
    if first["type"] == "literal_error":
        return f"{path}: got {got}, wanted {_choices(details, path, model)}"
    if first["type"] == "value_error":
        return f"{path}: {first['ctx']['error']}"
    bounds = range_at(model, first["loc"])
    if bounds and first["type"].startswith(("greater_than", "less_than")):
        return f"{path}: got {got}, wanted {bounds}"
    wanted = first["msg"].removeprefix("Input should be ").replace("a valid tuple", "a list")
    wanted = wanted.replace("a valid ", "a ").replace("a integer", "an integer")
    return f"{path}: got {got}, wanted {wanted}{bounds and f', {bounds}'}"


def _choices(details: Sequence[ErrorDetails], path: str, model: type[BaseModel]) -> str:
    """Return what may stand at a path; of a union of choices every member tells its own."""
    texts = [
        each["ctx"]["expected"]
        for each in details
        if each["type"] == "literal_error" and key_path(follow(model, each["loc"])[0]) == path
    ]
    return " or ".join(texts)


def key_path(location: Sequence[int | str]) -> str:
    """Write a location as people do: ``cameras.rear.size_px[0]``."""
    text = ""
    for part in location:
        if part != "[key]":  # pydantic's mark for "the key itself, not its value"
            text += f"[{part}]" if isinstance(part, int) else f".{part}"
    return text.removeprefix(".") or "the file"


def _shorten(value: object) -> str:
    text = " ".join(repr(value).split())
    return text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "..."


def _keys_at(model: type[BaseModel], location: Sequence[int | str]) -> list[str]:
    """Return the fields of the model that lies at a location, or none where there is no single model."""
    _, kind = follow(model, location)
    return sorted(kind.model_fields) if isinstance(kind, type) and issubclass(kind, BaseModel) else []


def _tag_key(error: ErrorDetails) -> str:
    """Return the key whose value picks one of several models."""
    return str(error["ctx"]["discriminator"]).strip("'")
