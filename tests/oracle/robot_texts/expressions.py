"""A line in tokens, and the expressions in it, as the manuals have them."""

import re
from typing import Any

from tests.oracle.robot_texts import words

TOKEN = re.compile(
    r"\s*(\"[^\"]*\"|\^[BH][0-9A-Fa-f]+|\d+\.?\d*(?:[Ee][+-]?\d+)?|\.\d+|(?<=[,\s])/[A-Z][\d.]*"
    r"|\.?&?[#$]?[A-Za-z][\w.]*|<=|>=|=<|=>|==|<>|\*\*|[-+*/^()\[\],=<>:;])"
)
Node = tuple[Any, ...]


class NotTaken(Exception):  # noqa: N818 -- names the situation
    """A line that the manuals do not allow."""


class Expressions:
    """Reads expressions from one line."""

    def __init__(self, raw: str, language: str) -> None:
        self.language, self.at = language, 0
        quoted = re.match(r"(?:[^\";]|\"[^\"]*\")*", raw)
        self.source = quoted.group() if quoted else ""
        self.tokens: list[str] = []
        at, end = 0, len(self.source.rstrip())
        while at < end:
            match = TOKEN.match(self.source, at)
            if match is None:
                self.tokens.append(self.source[at:])
                break
            self.tokens.append(match.group(1))
            at = match.end()

    # --- what is next --------------------------------------------------------------------------

    def next(self) -> str:
        return self.tokens[self.at].upper() if self.at < len(self.tokens) else ""

    def take(self, *wanted: str) -> str:
        found = self.next()
        if not found or (wanted and found not in wanted):
            raise NotTaken(f"{' or '.join(wanted) or 'more'} is missing before `{found}`")
        self.at += 1
        return self.tokens[self.at - 1]

    def has(self, *wanted: str) -> bool:
        if self.next() in wanted:
            self.at += 1
            return True
        return False

    def end(self) -> None:
        if self.next():
            raise NotTaken(f"nothing may follow before `{self.next()}`")

    # --- expressions ---------------------------------------------------------------------------

    def real(self) -> Node:
        found = self.expression()
        if self.is_location(found) or self.is_string(found):
            raise NotTaken("a number is wanted")
        return found

    def expression(self, level: int = 0) -> Node:
        order = words.ORDER[self.language]
        if self.language == "vplus" and level == len(order):
            found = self.unary()
            while self.next() == ":" and self.at + 1 < len(self.tokens):
                self.take()
                found = (":", found, self.unary())
            return found
        if level == len(order):
            return self.unary()
        found = self.expression(level + 1)
        while self.next() in order[level]:
            operator = self.take().upper()
            found = (operator, found, self.expression(level + 1))
        return found

    def unary(self) -> Node:
        if self.next() in words.BEFORE:
            operator = self.take().upper()
            return (f"{operator} before", self.unary())
        found = self.primary()
        if self.language == "as" and self.has("^"):
            return ("^", found, self.unary())
        return found

    def primary(self) -> Node:
        token = self.take()
        word = token.upper()
        if word == "(":
            found = self.expression()
            self.take(")")
            return found
        if token[0] == '"':
            return ("string", token[1:-1])
        if token[0].isdigit() or (token[0] == "." and token[1:2].isdigit()):
            return ("number", float(token))
        if token[0] == "^":
            return ("number", float(int(token[2:], 2 if word[1] == "B" else 16)))
        if word in words.CONSTANTS:
            return ("number", words.CONSTANTS[word])
        known = words.OF[self.language] | words.LOCATIONS
        if word in known and word not in words.NOT_IN[self.language]:
            return self._applied(word, *known[word])
        if word in words.STRINGS:
            return self._applied(word, 0, 9)
        if word in words.WORDS[self.language] or not re.fullmatch(r"\.?&?[#$]?[A-Z][\w.]*", word):
            raise NotTaken(f"`{token}` is no value")
        self.at -= 1
        return self.variable()

    def _applied(self, word: str, least: int, most: int) -> Node:
        given: list[Node | None] = []
        if self.has("("):
            while not self.has(")"):
                given.append(None if self.next() in (",", ")") else self._given(word))
                if self.next() != ")":
                    self.take("BY" if word in ("SHIFT", "SCALE") and len(given) == 1 else ",")
                    if self.next() == ")":
                        given.append(None)
        if not least <= len(given) <= most:
            raise NotTaken(f"{word} takes {least} to {most} arguments")
        return (word, *given)

    def _given(self, word: str) -> Node:
        if word == "$ENCODE" and self.next()[0] == "/":
            return ("format", self.take())
        return self.expression()

    def variable(self) -> Node:
        name = self.take().lower()
        if not re.fullmatch(r"\.?&?[#$]?[a-z][\w.]*", name):
            raise NotTaken(f"`{name}` is no name")
        subscripts: list[Node] = []
        if self.has("["):
            while not self.has("]"):
                subscripts.append(self.expression())
                if self.next() != "]":
                    self.take(",")
        return ("variable", name.replace("&", ""), tuple(subscripts))

    # --- kinds, as far as names tell them ------------------------------------------------------

    def is_string(self, node: Node) -> bool:
        if node[0] == "variable":
            return node[1].lstrip(".").startswith("$")
        if node[0] == "+":
            return self.is_string(node[1])
        return node[0] == "string" or node[0] in words.STRINGS

    def is_location(self, node: Node) -> bool:
        if node[0] == "variable":
            return node[1].lstrip(".").startswith("#")
        if node[0] in ("+", "-"):
            return self.is_location(node[1]) or self.is_location(node[2])
        return (
            node[0] == ":"
            or node[0] in words.LOCATIONS
            or (node[0] == "- before" and (self.is_location(node[1])))
        )

    def is_named(self, node: Node) -> bool:
        if node[0] in ("+", "-", ":"):
            return self.is_named(node[1]) and self.is_named(node[2])
        return node[0] in ("variable", "NULL")
