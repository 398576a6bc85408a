"""Tables and parts of pages as those need them who do not look at them."""

from vrts.site.accessible import accessible, finding_beginnings

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


def test_the_search_takes_the_beginning_of_a_title() -> None:
    script = "if (a && queryLower.length >= title.length / 2) {}"
    assert 'startsWith(queryLower + " ")' in finding_beginnings(script)
