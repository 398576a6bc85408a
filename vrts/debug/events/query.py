"""What somebody asks a table: `can1 where time > 3 and not kind = motion by time down first 5`.

Words that a row has to have come first, then a condition, an order, and how many rows. Conditions
are written as those of the debugger are; a row that has nothing in a column fits no comparison.
"""

import operator
import re
from collections.abc import Callable, Iterator
from typing import Generic, NamedTuple, TypeAlias, TypeVar

from vrts.debug.evaluating import CannotTell
from vrts.debug.events.columns import Column, Columns, no_such, texts_of
from vrts.debug.near import near_words

R = TypeVar("R")

LONGEST = 500  # characters of a question
DEEPEST = 20  # conditions within conditions
USUAL = 200  # rows of an answer
MOST = 1_000

_TOKEN = re.compile(r'\s*(?:("(?:[^"]*)")|(<=|=<|>=|=>|<>|!=|==|[=<>~()])|([^\s"()<>=!~]+))')
_CLAUSES = frozenset({"where", "by", "first", "last"})
_SIGNS = {"==": "=", "=<": "<=", "=>": ">=", "!=": "<>"}
_COMPARED: dict[str, Callable[[float, float], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}
_STATES = {"on": 1.0, "off": 0.0, "true": 1.0, "false": 0.0}
_UNITS = frozenset({"s", "ms", "min", "m", "mm", "cm", "deg", "%"})

Fits: TypeAlias = Callable[[R], bool]


class Compared(NamedTuple):
    """A comparison of a column with a text, as it was written."""

    column: str
    text: str


class Query(NamedTuple, Generic[R]):
    """A question that was understood."""

    words: tuple[str, ...]  # in small letters, which the text of a row has to have
    fits: Fits[R] | None  # None: every row
    by: str  # column; empty: in the order of the table
    down: bool  # the largest first
    first: int | None
    last: int | None
    equal: tuple[Compared, ...]  # texts that are to be equal
    kinds: frozenset[str] | None  # None: a row of any kind may fit


class _Token(NamedTuple):
    text: str
    quoted: bool = False
    sign: bool = False


def read_query(text: str, columns: Columns[R], here_s: float, table: str) -> Query[R]:
    """Read a question.

    Args:
        text: What stands behind the name of the table.
        columns: Of the table.
        here_s: What `here` stands for [s].
        table: Its name, for what is said.

    Raises:
        CannotTell: It cannot be read; the text says why.
    """
    if len(text) > LONGEST:
        raise CannotTell(f"a question has at most {LONGEST} characters")
    return _Reader(_tokens(text), columns, here_s, table).query()


class _Reader(Generic[R]):
    def __init__(
        self, tokens: list[_Token], columns: Columns[R], here_s: float, table: str
    ) -> None:
        self._tokens, self._columns, self._here_s = tokens, columns, here_s
        self._table = table
        self._at = 0
        self._equal: list[Compared] = []

    def query(self) -> Query[R]:
        words = tuple(self._words())
        fits: Fits[R] | None = None
        kinds: frozenset[str] | None = None
        if self._taken("where"):
            fits, kinds = self._either(0)
        by, down = "", False
        if self._taken("by"):
            by, down = self._name(), self._taken("down")
            _ = down or self._taken("up")
        first = self._count("first") if self._is("first") else None
        last = self._count("last") if first is None and self._is("last") else None
        if self._at < len(self._tokens):
            raise CannotTell(
                f"`{self._tokens[self._at].text}` is not understood here: {self._table} [WORD ...]"
                " [where CONDITION] [by COLUMN [down]] [first N|last N]"
            )
        return Query(words, fits, by, down, first, last, tuple(self._equal), kinds)

    def _words(self) -> Iterator[str]:
        begin = True
        while self._at < len(self._tokens):
            token = self._tokens[self._at]
            if not token.quoted and token.text.lower() in _CLAUSES:
                return
            if token.sign:
                example = "program = pick" if self._table == "calls" else "body = can1"
                raise CannotTell(
                    f"a condition begins with `where`: `{self._table} where {example}`"
                )
            self._at += 1
            if not (begin and token == _Token("all")):
                yield token.text.lower()
            begin = False

    # --- conditions: fits, and the kinds of rows that can fit ----------------------------------

    def _either(self, depth: int) -> tuple[Fits[R], frozenset[str] | None]:
        if depth > DEEPEST:
            raise CannotTell(f"conditions stand at most {DEEPEST} deep within one another")
        fits, kinds = self._both(depth)
        while self._taken("or"):
            other, more = self._both(depth)
            fits = _or(fits, other)
            kinds = None if kinds is None or more is None else kinds | more
        return fits, kinds

    def _both(self, depth: int) -> tuple[Fits[R], frozenset[str] | None]:
        fits, kinds = self._one(depth)
        while self._taken("and"):
            other, more = self._one(depth)
            fits = _and(fits, other)
            kinds = more if kinds is None else kinds if more is None else kinds & more
        return fits, kinds

    def _one(self, depth: int) -> tuple[Fits[R], frozenset[str] | None]:
        if self._taken("not"):
            if depth > DEEPEST:
                raise CannotTell(f"conditions stand at most {DEEPEST} deep within one another")
            fits, _ = self._one(depth + 1)
            return _not(fits), None
        if self._taken("("):
            found = self._either(depth + 1)
            if not self._taken(")"):
                raise CannotTell("a `)` is missing")
            return found
        return self._comparison()

    def _comparison(self) -> tuple[Fits[R], frozenset[str] | None]:
        name = self._name()
        column = self._columns[name]
        sign = self._next("a comparison is missing", f"`{name}` is compared with something")
        if not sign.sign or sign.text in "()":
            raise CannotTell(
                f"`{name}` is compared by `=`, `<>`, `<`, `>` or `~`: not `{sign.text}`"
            )
        value = self._next("a value is missing", f"`{name} {sign.text}` takes a value behind it")
        kind = _SIGNS.get(sign.text, sign.text)
        if column.number:
            number = self._number(name, column, value)
            if kind == "~":
                raise CannotTell(f"`{name}` is a number: `~` is for texts")
            return _numeric(column.of, _COMPARED[kind], number), None
        if kind not in ("=", "<>", "~"):
            raise CannotTell(f"`{name}` is a text: `=`, `<>`, or `~` for a part of it")
        text = value.text.lower()
        if column.only and kind != "~" and text not in column.only:
            near = near_words(text, column.only) or ": it is one of " + ", ".join(column.only)
            raise CannotTell(f"`{name}` is never `{value.text}`{near}")
        if kind == "=":
            self._equal.append(Compared(name, value.text))
        of_kinds = frozenset({text}) if name == "kind" and kind == "=" else None
        return _textual(column.of, kind, text), of_kinds

    def _number(self, name: str, column: Column[R], value: _Token) -> float:
        word = value.text.lower()
        known = {"here": self._here_s} if column.unit == "s" else {} if column.unit else _STATES
        unit = f" [{column.unit}]" if column.unit else ""
        try:
            number = known[word] if word in known else float(word)
        except ValueError:
            raise CannotTell(f"`{name}` is a number{unit}, not `{value.text}`") from None
        if not abs(number) < 1e300:  # no number as well: NaN
            raise CannotTell(f"`{name}` is a number{unit}, not `{value.text}`")
        if self._at < len(self._tokens) and self._tokens[self._at].text in _UNITS:
            behind = self._tokens[self._at].text
            if behind != column.unit:
                has = f"in {column.unit}" if column.unit else "a number without a unit"
                raise CannotTell(f"`{name}` is {has}, not in {behind}")
            self._at += 1
        return number

    # --- tokens -------------------------------------------------------------------------------

    def _name(self) -> str:
        token = self._next("a column is missing", "it is one of its columns")
        name = token.text.lower()
        if token.quoted or name not in self._columns:
            raise CannotTell(no_such(token.text, self._columns))
        return name

    def _count(self, word: str) -> int:
        self._at += 1
        token = self._next(f"`{word}` takes how many rows", f"`{word} 10`")
        if not token.text.isdecimal() or not 1 <= int(token.text[:9]) <= MOST:
            raise CannotTell(f"`{word}` takes how many rows: from 1 to {MOST:,}")
        return int(token.text[:9])

    def _next(self, missing: str, hint: str) -> _Token:
        if self._at == len(self._tokens):
            raise CannotTell(f"{missing} at the end: {hint}")
        self._at += 1
        return self._tokens[self._at - 1]

    def _is(self, word: str) -> bool:
        if self._at == len(self._tokens):
            return False
        token = self._tokens[self._at]
        return not token.quoted and token.text.lower() == word

    def _taken(self, word: str) -> bool:
        found = self._is(word)
        self._at += found
        return found


def _tokens(text: str) -> list[_Token]:
    found: list[_Token] = []
    at, end = 0, len(text.rstrip())
    while at < end:
        match = _TOKEN.match(text, at)
        if match is None:
            raise CannotTell(f"`{text[at:].strip()[:20]}` is not understood")
        quoted, sign, word = match.groups()
        found.append(
            _Token(quoted[1:-1], quoted=True) if quoted else _Token(sign or word, sign=bool(sign))
        )
        at = match.end()
    return found


def _or(one: Fits[R], other: Fits[R]) -> Fits[R]:
    return lambda row: one(row) or other(row)


def _and(one: Fits[R], other: Fits[R]) -> Fits[R]:
    return lambda row: one(row) and other(row)


def _not(one: Fits[R]) -> Fits[R]:
    return lambda row: not one(row)


def _numeric(
    of: Callable[[R], object], compare: Callable[[float, float], bool], number: float
) -> Fits[R]:
    def fits(row: R) -> bool:
        found = of(row)
        return found is not None and compare(found, number)  # type: ignore[arg-type]

    return fits


def _textual(of: Callable[[R], object], kind: str, wanted: str) -> Fits[R]:
    def fits(row: R) -> bool:
        found = of(row)
        if found is None:
            return False
        texts = [text.lower() for text in texts_of(found)]  # type: ignore[arg-type]
        if kind == "~":
            return any(wanted in text for text in texts)
        return (wanted in texts) is (kind == "=")

    return fits
