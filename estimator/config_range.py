"""The range of a number among settings, read off its type and written as people do."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Annotated, Any, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from estimator.config_path import Location, follow

_LOW = {"gt": "over ", "ge": ""}
_HIGH = {"lt": "below ", "le": ""}


def range_at(model: type[BaseModel], location: Location) -> str:
    """Return the range of the number that a location means: "0.2 to 40", "over 0 to 1"; "" if it has none."""
    _, group = follow(model, location[:-1])
    if isinstance(group, type) and issubclass(group, BaseModel):
        field = group.model_fields.get(str(location[-1]))
        return range_of(field.metadata) if field else ""
    items = get_args(group)
    return range_of(_marks(items[0])) if items else ""


def range_of(marks: Iterable[Any]) -> str:
    """Return the range that the marks of a type give; "" unless they give both its ends."""
    bounds = [
        (key, getattr(mark, key))
        for mark in marks
        for key in (*_LOW, *_HIGH)
        if getattr(mark, key, None) is not None
    ]
    low = next((f"{_LOW[key]}{bound:g}" for key, bound in bounds if key in _LOW), "")
    high = next((f"{_HIGH[key]}{bound:g}" for key, bound in bounds if key in _HIGH), "")
    return f"{low} to {high}" if low and high else ""


def _marks(kind: Any) -> Iterator[Any]:
    """Yield the marks of an annotated type."""
    if get_origin(kind) is Annotated:
        for mark in get_args(kind)[1:]:
            yield from mark.metadata if isinstance(mark, FieldInfo) else (mark,)
