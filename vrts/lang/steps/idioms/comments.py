"""Comments as other languages begin them."""

import re
from typing import NamedTuple


class Comment(NamedTuple):
    """Where a comment of another language begins in a step."""

    start: int
    end: int  # of its sign
    sign: str
    before: str  # the step before it, if any

    @property
    def goes_on(self) -> bool:
        """Whether it may end in a later line."""
        return self.sign in ("/*", "(*", *_OF_PYTHON)

    def closed_in(self, text: str) -> tuple[int, int] | None:
        """Return where the sign that ends it stands, if that is the end of the step."""
        closing = _CLOSING.get(self.sign, "")
        end = len(text.rstrip())
        if not closing or not text[self.end : end].endswith(closing):
            return None
        return len(text[: end - len(closing)].rstrip()), end


_OF_PYTHON = ('"""', "'''")
_FIRST = re.compile(
    r"(?P<sign>\"{3}|'{3}|//+|#+|/\*|\(\*|--+|!+|%+|'|\\+|\*+|<!--|\{(?=[^{}]*\}[ \t]*$)|@+|~+"
    r"|REM(?![\w.])[:.]?)",
    re.IGNORECASE,
)
_BEHIND = re.compile(
    r"(?<=[\s\"\w)\]])[ \t]*(?P<sign>//+|#+(?!\[|[A-Za-z][\w.]*[ \t]*$)|/\*|\(\*|--+(?=\s)|!+(?=\s)"
    r"|%+(?=\s)|'(?=\s|\w))"
)
_ASSIGNED = re.compile(r"#[A-Za-z][\w.]*[ \t]*=")  # a precision point
_CLOSING = {"/*": "*/", "(*": "*)", "{": "}", "<!--": "-->"} | dict(
    zip(_OF_PYTHON, _OF_PYTHON, strict=True)
)
_STRING = re.compile(r'"[^"]*"')


def leading(text: str) -> Comment | None:
    """Return the comment that a whole step is."""
    found = _FIRST.match(text)
    if found is None or _ASSIGNED.match(text):
        return None
    sign = found["sign"].upper()
    rest = text[found.end() :]
    if sign[0] == "R" and rest.lstrip()[:1] in ("=", "["):
        return None
    if sign in ("--", "!", "~", "*") and rest[:1].isalnum() and " " not in rest:
        return None  # --n
    return Comment(found.start("sign"), found.end("sign"), _kind(sign), "")


def behind(text: str) -> Comment | None:
    """Return the first comment behind a step, outside of strings."""
    plain = _STRING.sub(lambda string: '"' + "s" * (len(string.group()) - 2) + '"', text)
    found = _BEHIND.search(plain)
    if found is None:
        return None
    start, end = found.span("sign")
    return Comment(start, end, _kind(found["sign"]), text[: found.start()].rstrip())


def _kind(sign: str) -> str:
    """Return a sign as it is named: `//` for any number of strokes."""
    return "//" if sign[:2] == "//" else "REM" if sign[0] == "R" else sign
