"""``rigtrue doctor``: can this machine do the work, and if not, what exactly would mend it."""

from __future__ import annotations

import typer


def doctor_command() -> None:
    """Check Python, packages, renderers, cache and memory; print the fix for what is missing."""
    from eval.doctor import diagnose
    from eval.print_table import print_table

    checks = diagnose()
    print_table(("check", "", "found"), [(check.name, check.verdict, check.found) for check in checks])
    for check in checks:
        if not check.ok:
            print(f"to {'get' if check.optional else 'mend'} {check.name}: {check.remedy}")
    bad = [check for check in checks if not check.ok and not check.optional]
    if bad:
        raise typer.Exit(1)
    print("all is well: rigtrue run quick_look")
