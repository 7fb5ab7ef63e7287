"""``rigtrue doctor``: can this machine do the work, and if not, what exactly would mend it."""

from __future__ import annotations

import typer


def doctor_command() -> None:
    """Check Python, packages, off-screen OpenGL, cache and memory; print the fix for what is missing."""
    from eval.doctor import diagnose
    from eval.print_table import print_table

    checks = diagnose()
    print_table(
        ("check", "", "found"), [(check.name, "ok" if check.ok else "BAD", check.found) for check in checks]
    )
    bad = [check for check in checks if not check.ok]
    for check in bad:
        print(f"to mend {check.name}: {check.remedy}")
    if bad:
        raise typer.Exit(1)
    print("all is well: rigtrue run quick_look")
