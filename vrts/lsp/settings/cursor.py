"""Where a place in a TOML file stands, also while a line is half typed: table, key and value."""

import re
from typing import NamedTuple

_HEADER = re.compile(r"\s*(?P<open>\[\[?)\s*(?P<path>[^\]#]*)(?P<close>\]\]?)?")
_KEY = re.compile(r"\s*(?P<key>(?:[\w.-]|\"[^\"]*\"|'[^']*'|\s(?=\s*\.)|(?<=\.)\s)+?)\s*=")
_PART = re.compile(r"\"([^\"]*)\"|'([^']*)'|([\w-]+)")
_WORD = re.compile(r"[\w.-]*")
_BOUNDARY = frozenset("{[,")


class Cursor(NamedTuple):
    """What stands at a place."""

    path: tuple[str, ...]  # keys from the top of the file to the table that the place is in
    key: tuple[str, ...]  # of the value that the place is in; empty: it is at a key, or at none
    header: bool  # in the brackets of a table's name
    start: int  # offset of the word at the place
    end: int  # and its end
    array: bool = False  # in `[[ ]]`


def cursor_at(text: str, offset: int) -> Cursor:
    """Return where an offset stands; never fails."""
    offset = max(0, min(offset, len(text)))
    start_of_line = text.rfind("\n", 0, offset) + 1
    end_of_line = text.find("\n", offset)
    end_of_line = len(text) if end_of_line < 0 else end_of_line
    table, opened = _table_before(text, start_of_line)
    if opened:  # a value that goes on over several lines
        return _inside(text, table, opened, offset)
    line = text[start_of_line:end_of_line]
    header = _HEADER.match(line)
    if header and header["open"]:
        start, end = _word(text, offset, start_of_line)
        path_start = start_of_line + header.start("path")
        return Cursor(
            keys(text[path_start:start].rstrip(".")), (), True, start, end, header["open"] == "[["
        )
    key = _KEY.match(line)
    if key is None or offset < start_of_line + key.end():
        start, end = _word(text, offset, start_of_line)
        dotted = keys(text[start_of_line:start])
        return Cursor((*table, *dotted), (), False, start, end)
    return _inside(text, (*table, *keys(key["key"])), start_of_line + key.end(), offset)


def tables_before(text: str, offset: int) -> list[tuple[str, ...]]:
    """Return the names of all tables of a text that begin before an offset, in their order."""
    found: list[tuple[str, ...]] = []
    for line in text[:offset].split("\n"):
        header = _HEADER.match(line)
        if header and header["close"]:
            found.append(keys(header["path"]))
    return found


def keys_of(text: str, path: tuple[str, ...], offset: int) -> frozenset[str]:
    """Return the keys that the table round an offset has, beside the one on the offset's line."""
    begin = 0
    for found in re.finditer(r"(?m)^\s*\[.*$", text[:offset]):
        begin = found.end()
    after = re.search(r"(?m)^\s*\[(?!.*,\s*$)", text[offset:])
    end = len(text) if after is None else offset + after.start()
    at = text.count("\n", 0, offset)
    first = text.count("\n", 0, begin)
    given: set[str] = set()
    for number, line in enumerate(text[begin:end].split("\n"), start=first):
        key = _KEY.match(line)
        if key is not None and number != at:
            given.update(keys(key["key"])[:1])
    return frozenset(given)


def keys(dotted: str) -> tuple[str, ...]:
    """Return the parts of a dotted key."""
    return tuple(
        next((part for part in found.groups() if part is not None), "")
        for found in _PART.finditer(dotted)
    )


def _table_before(text: str, end: int) -> tuple[tuple[str, ...], int]:
    """Return the table that a line begins in, and where a value began that is still open; 0: none.

    The keys of that value are part of the table then.
    """
    table: tuple[str, ...] = ()
    at = 0
    while at < end:
        line_end = text.find("\n", at, end)
        line_end = end if line_end < 0 else line_end
        line = text[at:line_end]
        header = _HEADER.match(line)
        key = _KEY.match(line)
        if header and header["close"]:
            table = keys(header["path"])
        elif key is not None:
            begun = at + key.end()
            closed = _value_end(text, begun)
            if closed >= end:
                return (*table, *keys(key["key"])), begun
            line_end = max(line_end, closed)
        at = line_end + 1
    return table, 0


def _value_end(text: str, at: int) -> int:
    """Return where a value ends: at the end of its line, or of what it has opened."""
    depth, quote = 0, ""
    lines = 0
    while at < len(text):
        if quote:
            if text.startswith(quote, at):
                at, quote = at + len(quote), ""
            elif quote in ('"', '"""') and text[at] == "\\":
                at += 2
            elif text[at] == "\n" and len(quote) == 1:
                quote = ""  # a text that nobody has closed ends with its line
            else:
                at += 1
            continue
        letter = text[at]
        if letter in "\"'":
            quote = letter * 3 if text.startswith(letter * 3, at) else letter
            at += len(quote)
            continue
        if letter == "#":
            at = text.find("\n", at)
            if at < 0:
                return len(text)
            letter = "\n"
        if letter == "\n":
            lines += 1
            if depth <= 0 or _HEADER_LINE.match(text, at + 1):
                return at
        depth += (letter in "[{") - (letter in "]}")
        at += 1
    return at


_HEADER_LINE = re.compile(r"\s*\[\[?[A-Za-z][\w.-]*\]\]?\s*(#.*)?$", re.MULTILINE)


def _inside(text: str, key: tuple[str, ...], begun: int, offset: int) -> Cursor:
    """Return where an offset stands within a value: in an inline table, in an array, or plainly."""
    path, inner = key, False
    opened: list[tuple[str, int]] = []
    at, quote = begun, ""
    while at < offset:
        letter = text[at]
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        elif letter in "{[":
            opened.append((letter, at))
        elif letter in "}]" and opened:
            opened.pop()
        at += 1
    start, end = _word(text, offset, begun)
    table = next((place for letter, place in reversed(opened) if letter == "{"), None)
    if table is not None:
        part = text[table + 1 : offset]
        part = part[_last_comma(part) :]
        inside = _KEY.match(part)
        inner = inside is None
        if inside is not None:
            path = (*key, *keys(inside["key"]))
    if quote:
        start = max(text.rfind(quote, begun, offset), begun)
        closing = re.compile(f"[^{quote}\\n]*{quote}?").match(text, start + 1)
        end = closing.end() if closing else offset
    if inner:
        return Cursor(path, (), False, start, end)
    return Cursor(path[:-1], path[-1:], False, start, end)


def _last_comma(text: str) -> int:
    """Return where what stands after the last comma begins, outside of brackets and texts."""
    depth, quote, found = 0, "", 0
    for at, letter in enumerate(text):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        elif letter in "[{":
            depth += 1
        elif letter in "]}":
            depth -= 1
        elif letter == "," and depth == 0:
            found = at + 1
    return found


def _word(text: str, offset: int, least: int) -> tuple[int, int]:
    """Return the word at an offset: of one part of a key, or of a plain value."""
    start = offset
    while start > least and (text[start - 1].isalnum() or text[start - 1] in "_-"):
        start -= 1
    found = _WORD.match(text, offset)
    end = offset if found is None else found.end()
    dot = text.find(".", offset, end)
    return start, end if dot < 0 else dot
