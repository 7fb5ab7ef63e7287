"""How an estimator is found."""

from pathlib import Path

import pytest

from estimator.errors import InputError
from eval.code_digest import code_digest
from eval.estimators import find_estimator, installed_estimators
from tests.throwaway_estimators import Nominal, Raises


def test_the_own_estimator_is_installed() -> None:
    assert installed_estimators()["online"].value == "estimator.online:OnlineEstimator"


def test_module_and_class_find_any_estimator() -> None:
    assert find_estimator("tests.throwaway_estimators:Nominal") is Nominal


def test_a_module_in_the_working_folder_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.path", [*__import__("sys").path])
    (tmp_path / "my_own_estimator.py").write_text("class Mine:\n    pass\n")
    assert find_estimator("my_own_estimator:Mine").__name__ == "Mine"  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nope", "estimator 'nope' is not known; there are: batch, online, or any module:Class"),
        ("nope:X", "cannot import 'nope'"),
        (":X", "cannot import ''"),
        ("json:X", "module 'json' has no 'X'"),
        ("json:", "module 'json' has no ''"),
    ],
)
def test_an_estimator_that_is_not_there_is_one_line(name: str, message: str) -> None:
    with pytest.raises(InputError) as error:
        find_estimator(name)
    assert message in str(error.value)


def test_the_code_digest_tells_modules_apart_but_not_classes_of_one() -> None:
    assert code_digest(Nominal) == code_digest(Raises) != code_digest(Path)  # type: ignore[arg-type]
