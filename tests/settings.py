"""Every setting of a scenario, found by walking the types: its path, its range, and how to set it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt
from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from scenarios.scenario import ScenarioEntry


@dataclass(frozen=True)
class Setting:
    """One field, wherever it lies.

    Attributes:
        path: As an error names it, ``faults[0].probability``.
        model: The model it belongs to.
        field: Its type, bounds and default.
    """

    path: str
    model: type[BaseModel]
    field: FieldInfo

    @property
    def kinds(self) -> tuple[Any, ...]:
        """The types that its value may have."""
        return tuple(each for each in _members(self.field.annotation) if each is not NoneType)

    @property
    def is_number(self) -> bool:
        return any(kind in (int, float) for kind in self.kinds)

    @property
    def low(self) -> float | None:
        """The smallest value, or one just above a bound that is excluded."""
        return _bound(self.field, Ge, Gt, 1e-3)

    @property
    def high(self) -> float | None:
        """The largest value."""
        return _bound(self.field, Le, Lt, -1e-3)

    @property
    def range(self) -> str:
        """Both ends of the range, as an error tells it."""
        low = f"{self._mark('ge'):g}" if self._mark("ge") is not None else f"over {self._mark('gt'):g}"
        return f"{low} to {self._mark('le'):g}"

    def _mark(self, name: str) -> Any:
        return next((getattr(mark, name) for mark in self.field.metadata if hasattr(mark, name)), None)

    def set_to(self, value: str) -> str:
        """Return the text after ``--set`` that gives this setting a value, all around it being valid."""
        path, index, key = self.path.partition("[0].")
        if not index:
            return f"{self.path}={value}"
        given = _valid(self.model) | {key: value}
        return f"{path}=[{{{', '.join(f'{name}: {text}' for name, text in given.items())}}}]"


def all_settings(model: type[BaseModel] = ScenarioEntry, prefix: str = "") -> Iterator[Setting]:
    """Yield the settings below a model."""
    for name, field in model.model_fields.items():
        setting = Setting(prefix + name, model, field)
        models = [kind for kind in setting.kinds if _is_model(kind)]
        items = [item for kind in setting.kinds for item in _models_of_list(kind)]
        for each in models:
            yield from all_settings(each, f"{prefix}{name}.")
        for each in items:
            yield from all_settings(each, f"{prefix}{name}[0].")
        if not models and not items:
            yield setting


def all_models(model: type[BaseModel] = ScenarioEntry) -> set[type[BaseModel]]:
    """Return every model that a scenario file may hold."""
    return {model} | {setting.model for setting in all_settings(model)}


def _valid(model: type[BaseModel]) -> dict[str, str]:
    """Return the smallest set of keys that a model of a list accepts, as YAML."""
    values = {}
    for name, field in model.model_fields.items():
        setting = Setting(name, model, field)
        if get_origin(field.annotation) is Literal and len(get_args(field.annotation)) == 1:
            values[name] = str(get_args(field.annotation)[0])
        elif name == "camera":
            values[name] = "[left_rear, rear]"
        elif field.default is PydanticUndefined and field.default_factory is None:
            values[name] = str(setting.low if setting.low is not None else 1)
    return values


def _bound(field: FieldInfo, closed: type, open_: type, step: float) -> float | None:
    for mark in field.metadata:
        if isinstance(mark, closed):
            return float(getattr(mark, closed.__name__.lower()))
        if isinstance(mark, open_):
            return float(getattr(mark, open_.__name__.lower())) + step
    return None


def _members(annotation: Any) -> tuple[Any, ...]:
    if get_origin(annotation) is Annotated:
        return _members(get_args(annotation)[0])
    if get_origin(annotation) in (Union, UnionType):
        return tuple(member for each in get_args(annotation) for member in _members(each))
    return (annotation,)


def _models_of_list(annotation: Any) -> list[type[BaseModel]]:
    if get_origin(annotation) is not list:
        return []
    return [member for member in _members(get_args(annotation)[0]) if _is_model(member)]


def _is_model(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, BaseModel)
