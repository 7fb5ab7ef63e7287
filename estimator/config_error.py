"""Tell in one line what pydantic found wrong: the path of the key, what was got, what was wanted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

_LONGEST = 60


def describe_first_error(error: ValidationError, model: type[BaseModel]) -> str:
    """Return ``path: what is wrong`` for the first thing wrong; ``model`` is the root that was validated."""
    details = error.errors(include_url=False)
    # an unknown key often explains the key that is missing, so it is told first
    first = next((each for each in details if each["type"] == "extra_forbidden"), details[0])
    path = key_path(first["loc"])
    got = _shorten(first["input"])
    if first["type"] == "missing":
        return f"{path}: missing"
    if first["type"] == "extra_forbidden":
        keys = _keys_at(model, first["loc"][:-1])
        return f"{path}: unknown key" + (f"; there are: {', '.join(keys)}" if keys else "")
    if first["type"] in ("model_type", "dict_type", "model_attributes_type"):
        return f"{path}: got {got}, wanted keys with values"
    if first["type"] in ("too_short", "too_long"):
        context = first["ctx"]
        wanted = context.get("min_length", context.get("max_length"))
        return f"{path}: got {context['actual_length']} values, wanted {wanted}"
    if first["type"] == "value_error":
        return f"{path}: {first['ctx']['error']}"
    wanted = first["msg"].removeprefix("Input should be ").replace("a valid tuple", "a list")
    return f"{path}: got {got}, wanted {wanted.replace('a valid ', 'a ').replace('a integer', 'an integer')}"


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
    models: list[type[BaseModel]] = [model]
    for part in location:
        found: list[type[BaseModel]] = []
        for each in models:
            name = str(part)
            field = each.model_fields.get(name)
            if field is None:  # a key of a mapping or an index: the model was already found in the value type
                found.append(each)
            else:
                found.extend(_models_in(field.annotation))
        models = found
    return sorted({name for each in models for name in each.model_fields}) if len(models) == 1 else []


def _models_in(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    else:
        for argument in get_args(annotation):
            yield from _models_in(argument)
