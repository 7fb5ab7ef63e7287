"""Plain progress lines."""

import pytest

from eval.console import PlainConsole, open_console


def test_a_stage_tells_its_first_and_last_step(capsys: pytest.CaptureFixture[str]) -> None:
    console = PlainConsole(verbose=False)
    for done in range(1, 101):
        console.progress("rendering", done, 100)
    console.progress("estimating", 1, 3)
    assert capsys.readouterr().err.splitlines() == ["rendering 1/100", "rendering 100/100", "estimating 1/3"]


def test_details_are_for_who_asked(capsys: pytest.CaptureFixture[str]) -> None:
    PlainConsole(verbose=False).detail("more")
    PlainConsole(verbose=True).detail("even more")
    assert capsys.readouterr().err == "even more\n"


def test_quiet_says_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    with open_console(quiet=True, verbose=True) as console:
        console.progress("rendering", 1, 1)
        console.say("hello")
        console.detail("hello")
    assert capsys.readouterr() == ("", "")
