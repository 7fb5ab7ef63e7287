"""Every command line of the documentation is one that the command line takes."""

import re
import shlex
from pathlib import Path

import pytest
import typer

from eval.cli import app
from scenarios.bundled import bundled_names

HOUSE = Path(__file__).parents[2]
PAGES = [
    HOUSE / "README.md",
    HOUSE / "CONTRIBUTING.md",
    HOUSE / "reports/README.md",
    *HOUSE.glob("docs/*.md"),
]
TEXT = "\n".join(page.read_text() for page in PAGES)
# A line of a code block up to its comment, or a whole `code span`.
COMMANDS = sorted(
    {line.partition(" #")[0].strip() for line in re.findall(r"^rigtrue .*$", TEXT, re.MULTILINE)}
    | set(re.findall(r"`(rigtrue (?:run|record|replay|sweep|report|list|doctor)[^`]*)`", TEXT))
)


@pytest.mark.parametrize("line", COMMANDS)
def test_a_documented_command_line_is_understood(line: str) -> None:
    _, name, *arguments = shlex.split(line)
    group = typer.main.get_command(app)
    command = group.commands[name]  # type: ignore[attr-defined]
    if arguments:
        command.make_context(name, list(arguments))
    named = bool(arguments) and "/" not in arguments[0] and not arguments[0].isupper()  # NAME stands for any
    if name in ("run", "record", "sweep") and named:
        assert arguments[0] in bundled_names("sweep" if name == "sweep" else "scenario")


def test_the_documentation_shows_every_command() -> None:
    shown = {shlex.split(line)[1] for line in COMMANDS}
    assert shown == set(typer.main.get_command(app).commands)  # type: ignore[attr-defined]


def test_every_documented_make_target_exists() -> None:
    targets = set(re.findall(r"^([a-z]+):", (HOUSE / "Makefile").read_text(), re.MULTILINE))
    documented = set(re.findall(r"(?:^|`)make ([a-z]+)", TEXT, re.MULTILINE))
    assert documented and documented <= targets


def test_every_linked_page_and_picture_exists() -> None:
    for page in PAGES:
        for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text()):
            assert (page.parent / link).exists(), f"{page.name}: {link}"


def test_every_documented_module_and_test_file_exists() -> None:
    modules = set(re.findall(r"python -m ((?:tests|docs)\.[\w.]+)", TEXT))
    tests = set(re.findall(r"\b(tests/[\w/]+\.py)", TEXT))
    assert modules and tests
    assert all((HOUSE / f"{module.replace('.', '/')}.py").exists() for module in modules), modules
    assert all((HOUSE / test).exists() for test in tests), tests
