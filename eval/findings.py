"""When each finding of an estimator began and ended, over a run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from estimator.finding import Finding
from eval.collect import RunLog

_Key = tuple[str, tuple[str, ...]]


@dataclass(frozen=True)
class Spell:
    """One finding from the bundle at which it began to the first at which it no longer held.

    Attributes:
        finding: As it stood last.
        begin_ns: Stamp of the first bundle that had it.
        end_ns: Stamp of the first bundle that had it no more; None if it held to the end.
        begun_as: As it stood first.
    """

    finding: Finding
    begin_ns: int
    end_ns: int | None
    begun_as: Finding


def spells(log: RunLog) -> list[Spell]:
    """Return the findings of a run by when they began; one that came back is told again."""
    ended: list[Spell] = []
    open_now: dict[_Key, Spell] = {}
    told = [(entry.stamp_ns, entry.findings) for entry in log.entries]
    for stamp_ns, findings in [*told, (log.last_stamp_ns, log.final.findings)]:
        held = {_key(finding): finding for finding in findings}
        for key in [key for key in open_now if key not in held]:
            ended.append(replace(open_now.pop(key), end_ns=stamp_ns))
        for key, finding in held.items():
            before = open_now.get(key)
            open_now[key] = (
                Spell(finding, stamp_ns, None, finding)
                if before is None
                else replace(before, finding=finding)
            )
    return sorted([*ended, *open_now.values()], key=lambda spell: spell.begin_ns)


def finding_events(log: RunLog) -> Iterator[dict[str, Any]]:
    """Yield an event when a finding begins, and one when it ends, in order of time."""
    events = []
    for spell in spells(log):
        events.append(_event(spell.begin_ns, spell.begun_as, "begins"))
        if spell.end_ns is not None:
            events.append(_event(spell.end_ns, spell.finding, "ends"))
    yield from sorted(events, key=lambda event: event["stamp_ns"])


def finding_rows(log: RunLog) -> list[Mapping[str, Any]]:
    """Return the findings as the report shows them, times in seconds since the first bundle."""
    return [
        {
            "kind": str(spell.finding.kind),
            "cameras": list(spell.finding.cameras),
            "about": spell.finding.about,
            "doubtful": spell.finding.doubtful,
            "begin_s": (spell.begin_ns - log.first_stamp_ns) * 1e-9,
            "end_s": None if spell.end_ns is None else (spell.end_ns - log.first_stamp_ns) * 1e-9,
        }
        for spell in spells(log)
    ]


def finding_line(finding: Finding) -> str:
    """Return one line for a terminal: control characters of a foreign estimator stay out."""
    mark = " (in doubt)" if finding.doubtful else ""
    text = f"{finding.kind}: {', '.join(finding.cameras)}{mark}: {finding.about}"
    return "".join(c if c.isprintable() else " " for c in text)


def _event(stamp_ns: int, finding: Finding, state: str) -> dict[str, Any]:
    return {
        "event": "finding",
        "stamp_ns": stamp_ns,
        "kind": str(finding.kind),
        "cameras": list(finding.cameras),
        "about": finding.about,
        "state": state,
    }


def _key(finding: Finding) -> _Key:
    return str(finding.kind), tuple(finding.cameras)
