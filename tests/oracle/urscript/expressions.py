"""Expressions of URScript: numbers, booleans, poses, lists, structs, calls, and `run`.

Members of structs (`time().sec`) and `run` came later, from the pages on time (SW 5.19) and threads
(SW 5.20) of UR's script manual, before any export used them.
"""

import math
import re
from typing import Any, Protocol

from tests.oracle.urscript.values import NotTaken, element, member

TOKEN = re.compile(
    r"\s*(\"[^\"]*\"|\d+\.?\d*(?:[eE][+-]?\d+)?|p\[|[A-Za-z_]\w*|==|!=|<=|>=|[-+*/%()\[\],=<>.])"
)
LEVELS = (("or", "xor"), ("and",), ("==", "!=", "<", ">", "<=", ">="), ("+", "-"), ("*", "/", "%"))


class Running(Protocol):
    """What carries calls out and knows the global variables."""

    globals: dict[str, Any]

    def call(self, name: str, given: list[Any], named: dict[str, float]) -> Any:
        """Carry a function out."""
        ...

    def begin(self, name: str) -> Any:
        """Begin a thread."""
        ...


class Expression:
    """Works an expression out as it reads it."""

    def __init__(self, text: str, local: dict[str, Any], running: "Running") -> None:
        """Take an expression apart."""
        self.tokens: list[str] = []
        self.local, self.running, self.at = local, running, 0
        place = 0
        while place < len(text.rstrip()):
            match = TOKEN.match(text, place)
            if match is None:
                raise NotTaken(f"`{text[place:]}` is no expression")
            self.tokens.append(match.group(1))
            place = match.end()

    def next(self) -> str:
        """Return the next token; empty at the end."""
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, wanted: str = "") -> str:
        """Return the next token and go on."""
        found = self.next()
        if not found or (wanted and found != wanted):
            raise NotTaken(f"`{wanted or 'more'}` is missing")
        self.at += 1
        return found

    def level(self, k: int) -> Any:
        """Return what operators from a level on make."""
        if k == len(LEVELS):
            return self.unary()
        found = self.level(k + 1)
        while self.next() in LEVELS[k]:
            operator = self.take()
            found = operation(operator, found, self.level(k + 1))
        return found

    def unary(self) -> Any:
        """Return what signs, elements and members make."""
        if self.next() == "-":
            self.take()
            return -self.unary()
        if self.next() == "not":
            self.take()
            value = self.unary()
            if not isinstance(value, bool):
                raise NotTaken("`not` takes True or False")
            return not value
        found = self.primary()
        while self.next() in ("[", "."):
            if self.take() == ".":
                found = member(found, self.take())
                continue
            found = element(found, self.level(0))
            self.take("]")
        return found

    def primary(self) -> Any:
        """Return a value that stands in the text, or that a name has."""
        token = self.take()
        if token == "(":
            found = self.level(0)
            self.take(")")
            return found
        if token in ("[", "p["):
            items: list[Any] = []
            while self.next() != "]":
                items.append(self.level(0))
                if self.next() != "]":
                    self.take(",")
            self.take("]")
            if token == "p[" and len(items) != 6:
                raise NotTaken("a pose has six numbers")
            return tuple(items) if token == "p[" else items
        if token == "run":
            name = self.take()
            self.take("(")
            self.take(")")
            return self.running.begin(name)
        if token[0] == '"':
            return token[1:-1]
        if token[0].isdigit():
            return int(token) if token.isdigit() else float(token)
        if token in ("True", "False"):
            return token == "True"
        if self.next() == "(":
            return self._call(token)
        if token in self.local:
            return self.local[token]
        if token in self.running.globals:
            return self.running.globals[token]
        raise NotTaken(f"`{token}` has no value")

    def _call(self, name: str) -> Any:
        self.take("(")
        given: list[Any] = []
        named: dict[str, float] = {}
        while self.next() != ")":
            if self.at + 1 < len(self.tokens) and self.tokens[self.at + 1] == "=":
                key = self.take()
                self.take("=")
                named[key] = self.level(0)
            else:
                given.append(self.level(0))
            if self.next() != ")":
                self.take(",")
        self.take(")")
        return self.running.call(name, given, named)


def operation(operator: str, a: Any, b: Any) -> Any:
    """Return what an operator makes of two values."""
    if operator in ("and", "or", "xor"):
        if not (isinstance(a, bool) and isinstance(b, bool)):
            raise NotTaken(f"`{operator}` takes True and False")
        return {"and": a and b, "or": a or b, "xor": a != b}[operator]
    if isinstance(a, bool) or isinstance(b, bool):
        raise NotTaken("True and False are no numbers")
    match operator:
        case "+":
            return a + b
        case "-":
            return a - b
        case "*":
            return a * b
        case "/":
            if isinstance(a, int) and isinstance(b, int):
                raise NotTaken("the manual does not say how whole numbers divide")
            return a / b
        case "%":
            return math.fmod(a, b)
        case "==":
            return a == b
        case "!=":
            return a != b
        case "<":
            return a < b
        case ">":
            return a > b
        case "<=":
            return a <= b
        case _:
            return a >= b
