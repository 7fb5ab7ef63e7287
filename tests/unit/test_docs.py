"""The documentation's tables are what the code and the files say, and its pages lead somewhere."""

import re
from pathlib import Path

import pytest

from docs.tables import DOCS, TABLES, with_tables

PAGES = sorted(DOCS.glob("*.md"))


@pytest.mark.parametrize("page", TABLES)
def test_the_tables_are_up_to_date(page: str) -> None:
    text = (DOCS / page).read_text()
    assert with_tables(page, text) == text, "python -m docs.tables writes them anew"


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_every_link_and_picture_exists(page: Path) -> None:
    links = re.findall(r"\]\(([^)#:]+)\)", page.read_text())
    assert all((page.parent / link).exists() for link in links)


def test_a_page_without_its_mark_is_refused() -> None:
    with pytest.raises(ValueError, match="0 tables marked 'kinds'"):
        with_tables("faults.md", "no table here")
