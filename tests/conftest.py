"""What holds for all tests: which OpenGL they use, and what must stay in one process."""

import pytest

import sim  # noqa: F401  chooses OpenGL before any test imports MuJoCo, which binds it once and for all


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep a file's tests in one process, where several share the work: they share what is costly to make.

    The scenarios' tests share one set of rendered bundles, so they are kept together as a whole.
    """
    for item in items:
        folder = item.path.parent
        together = folder if folder.name == "scenarios" and folder.parent.name == "tests" else item.path
        item.add_marker(pytest.mark.xdist_group(str(together)))
