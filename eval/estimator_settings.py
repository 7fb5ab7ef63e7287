"""Settings of the estimator on the command line: ``--set estimator.refine=intrinsics``."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any, cast

from pydantic import ValidationError

from estimator.config import Config
from estimator.config_error import describe_first_error
from estimator.errors import InputError
from estimator.interface import Estimator, EstimatorFactory
from scenarios.overrides import merge, parse_overrides

_PREFIX = "estimator."


def is_of_estimator(setting: str) -> bool:
    """Tell whether a ``KEY=VALUE`` text concerns the estimator, and so not the recording."""
    return setting.strip().startswith(_PREFIX)


def with_settings(name: str, factory: EstimatorFactory, settings: Iterable[str]) -> EstimatorFactory:
    """Return what constructs an estimator with the settings that concern it; others are left aside.

    Args:
        name: The estimator, for errors.
        factory: What constructs it; if it takes settings, its ``config_type`` is their ``Config``.
        settings: ``dotted.path=value`` texts.

    Raises:
        InputError: It takes no settings, or not these.
    """
    own = [setting for setting in settings if is_of_estimator(setting)]
    if not own:
        return factory
    config_type = getattr(factory, "config_type", None)
    if not (isinstance(config_type, type) and issubclass(config_type, Config)):
        raise InputError(f"--set {own[0]}: estimator {name!r} takes no settings: it has no config_type")
    try:
        config = _with_defaults(config_type, parse_overrides(own)["estimator"])
    except ValidationError as error:
        raise InputError(f"--set {_PREFIX}{describe_first_error(error, config_type)}") from None
    return cast(EstimatorFactory, partial(cast(Callable[..., Estimator], factory), config=config))


def _with_defaults(config_type: type[Config], chosen: Mapping[str, Any]) -> Config:
    """Return settings with everything that was not chosen as the whole has it.

    A group that stands inside another may have other defaults there than by itself, so the chosen values are
    put into the whole's own, not into those of their group.
    """
    config_type.model_validate(chosen, strict=True)  # what is wrong is told by what was given
    return config_type.model_validate(merge(config_type().model_dump(), chosen), strict=True)
