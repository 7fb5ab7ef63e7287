"""Follow the location of a pydantic error through the settings it was found in.

Pydantic puts marks into a location that no file holds: the tag of a tagged union, the name of a type that was
tried. They are told from real keys by walking the types.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel

Location = Sequence[int | str]


def follow(model: type[BaseModel], location: Location) -> tuple[list[int | str], Any]:
    """Return the location as the file has it, and the type of what lies there (None if that is not known)."""
    kept: list[int | str] = []
    kind: Any = model
    for part in location:
        kind = _bare(kind)
        if _is_union(kind):
            members = [_bare(each) for each in get_args(kind)]
            kind = next((each for each in members if part in _tags(each)), kind)
            # the mark of a plain type stands for one of the members; an index says that it is the list
            if not isinstance(part, int):
                continue
            kind = next((each for each in members if get_origin(each) in (list, tuple)), None)
        kept.append(part)
        kind = _inside(kind, part)
    return kept, _bare(kind)


def _inside(kind: Any, part: int | str) -> Any:
    """Return the type of a field, an item, or the value of a mapping."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        field = kind.model_fields.get(str(part))
        return field.annotation if field else None
    arguments = get_args(kind)
    if not arguments:
        return None
    return arguments[1] if _is_mapping(kind) else arguments[0]


def _bare(kind: Any) -> Any:
    """Take off ``Annotated`` and ``| None``."""
    if get_origin(kind) is Annotated:
        return _bare(get_args(kind)[0])
    if _is_union(kind):
        members = [each for each in get_args(kind) if each is not NoneType]
        return _bare(members[0]) if len(members) == 1 else kind
    return kind


def _is_union(kind: Any) -> bool:
    return get_origin(kind) in (Union, UnionType)


def _is_mapping(kind: Any) -> bool:
    origin = get_origin(kind)
    return isinstance(origin, type) and issubclass(origin, Mapping)


def _tags(kind: Any) -> tuple[Any, ...]:
    """Return the values by which a member of a tagged union is known."""
    if not (isinstance(kind, type) and issubclass(kind, BaseModel)):
        return ()
    literals = (field.annotation for field in kind.model_fields.values())
    return tuple(tag for literal in literals if get_origin(literal) is Literal for tag in get_args(literal))
