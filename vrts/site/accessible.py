"""What Sphinx and furo leave out of a page for people who do not look at it, or use no mouse."""

import re

_TABLE = re.compile(r"<table\b.*?</table>", re.S)
_EMPTY_HEAD = re.compile(r'<th class="head">\s*(?:<p>\s*</p>)?\s*</th>')
_HEAD = re.compile(r"<thead>.*?</thead>\s*", re.S)
_FIRST_CELL = re.compile(r'(<tr class="row-(?:odd|even)">\s*)<td>(.*?)</td>', re.S)
_HALF = "queryLower.length >= title.length / 2"  # a condition of Sphinx's search
_LANDMARKS = (
    ('<aside class="sidebar-drawer">', '<aside class="sidebar-drawer" aria-label="All pages">'),
    ('<aside class="toc-drawer">', '<aside class="toc-drawer" aria-label="This page">'),
    ('<div id="search-results">', '<h1 class="for-readers">Search</h1>\n<div id="search-results">'),
)


def accessible(page: str) -> str:
    """Return a page with names for its parts and heads for the rows of its tables."""
    for found, better in _LANDMARKS:
        page = page.replace(found, better)
    return _TABLE.sub(lambda match: _table(match[0]), page)


def finding_beginnings(script: str) -> str:
    """Return Sphinx's search such that `V301` finds the section `V301 out-of-reach`, too.

    Sphinx leaves out titles that are more than twice as long as what was typed.

    Raises:
        ValueError: The script is another one: there is nothing to replace.
    """
    if _HALF not in script:
        raise ValueError(f"there is no `{_HALF}` in the search of this Sphinx")
    begins = 'title.toLowerCase().startsWith(queryLower + " ")'
    return script.replace(_HALF, f"({_HALF} || {begins})")


def _table(table: str) -> str:
    """Return a table; where its first column has no head, its cells are the heads of their rows."""
    if not _EMPTY_HEAD.search(table):
        return table
    head = _HEAD.search(table)
    if head is not None and '<th class="head"><p>' not in _EMPTY_HEAD.sub("", head[0]):
        table = _HEAD.sub("", table, count=1)
    table = _EMPTY_HEAD.sub(r'<td class="head"></td>', table)
    return _FIRST_CELL.sub(r'\1<th scope="row">\2</th>', table)
