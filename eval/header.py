"""What a run was: the part of ``scores.json`` that is not a metric."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class RunHeader:
    """Names a run and says what made it.

    Attributes:
        scenario: Name of the scenario, or of the recording that was replayed.
        digest: Of everything that changes the recording; None where it is not known.
        seed: None for a recording that was not simulated here.
        estimator: Name of the estimator.
        provenance: Commit, versions, renderer, CPU and so on; JSON values.
        about: One sentence on what the scenario tests.
        warnings: What the reader of the recording complained of.
        settings: What was set on top of the scenario's file, by dotted path; JSON values.
    """

    scenario: str
    digest: str | None
    seed: int | None
    estimator: str
    provenance: Mapping[str, Any] = field(default_factory=dict)
    about: str = ""
    warnings: tuple[str, ...] = ()
    settings: Mapping[str, Any] = field(default_factory=dict)
