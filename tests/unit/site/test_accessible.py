"""Tables and parts of pages as those need them who do not look at them."""

from pathlib import Path

import pytest

from tests.support_site import built_site
from vrts.site.accessible import accessible, finding_beginnings
from vrts.site.build import mend_search

HEADLESS = (
    '<table><thead><tr class="row-odd"><th class="head"><p></p></th>\n'
    '<th class="head"></th></tr></thead>\n'
    '<tbody><tr class="row-even"><td><p>a</p></td>\n<td><p>b</p></td></tr></tbody></table>'
)


def test_a_table_without_heads_has_heads_of_rows() -> None:
    page = accessible(HEADLESS)
    assert "<thead>" not in page
    assert '<th scope="row"><p>a</p></th>' in page
    assert "<td><p>b</p></td>" in page


def test_a_table_with_one_head_keeps_it() -> None:
    page = accessible(HEADLESS.replace('<th class="head"></th>', '<th class="head"><p>x</p></th>'))
    assert '<td class="head"></td>\n<th class="head"><p>x</p></th>' in page
    assert '<th scope="row"><p>a</p></th>' in page


def test_other_tables_stay_as_they_are() -> None:
    table = '<table><thead><tr><th class="head"><p>x</p></th></tr></thead></table>'
    assert accessible(table) == table


def test_parts_of_a_page_have_names() -> None:
    page = accessible('<aside class="sidebar-drawer"><aside class="toc-drawer">')
    assert page.count("aria-label=") == 2
    page = (built_site() / "learn" / "01-cans-on-bases.html").read_text("utf-8")
    assert '<aside class="sidebar-drawer" aria-label="All pages">' in page
    assert '<aside class="toc-drawer" aria-label="This page">' in page
    search = (built_site() / "search.html").read_text("utf-8")
    assert '<h1 class="for-readers">Search</h1>' in search


def test_the_search_takes_the_beginning_of_a_title() -> None:
    script = (built_site() / "_static" / "searchtools.js").read_text("utf-8")
    half = "queryLower.length >= title.length / 2"
    begins = 'title.toLowerCase().startsWith(queryLower + " ")'
    assert f"({half} || {begins})" in script
    assert script.count(half) == script.count(begins)


def test_a_search_that_is_another_one_is_a_fault_of_the_build(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="in the search of this Sphinx"):
        finding_beginnings("if (title.includes(queryLower)) {}")
    script = tmp_path / "searchtools.js"
    assert len(mend_search(script)) == 1  # there is none
    script.write_text("if (title.includes(queryLower)) {}")
    assert "searchtools.js: there is no `queryLower" in mend_search(script)[0]
    script.write_text("if (queryLower.length >= title.length / 2) {}")
    assert mend_search(script) == []
