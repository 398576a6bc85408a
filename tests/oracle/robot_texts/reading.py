"""Reads a text in AS or V+ by the syntax of the manuals; what they do not list is refused."""

import re
from typing import Any, NamedTuple

from tests.oracle.robot_texts import words
from tests.oracle.robot_texts.expressions import Expressions, Node, NotTaken


class Line(NamedTuple):
    """A step: its label, its word and operands."""

    number: int  # of the text
    label: str
    word: str
    given: tuple[Any, ...]


class Text(NamedTuple):
    """A file."""

    programs: dict[str, tuple[list[Node], list[Line]]]  # formals and steps
    data: dict[tuple[str, tuple[int, ...]], Any]


def read(text: str, language: str) -> Text:
    """Return what a text says.

    Raises:
        NotTaken: With the line and the reason.
    """
    found = Text({}, {})
    section, name = "", ""
    for number, raw in enumerate(text.split("\n"), 1):
        line = _Line(raw, language)
        try:
            row = line.source.strip()
            if not row:
                continue
            if row.upper().startswith(".END"):
                section = ""
            elif row.startswith(".") and not section:
                section = row.split("(")[0].split()[0].upper()
                if section == ".PROGRAM":
                    name, formals = line.header()
                    found.programs[name] = (formals, [])
                elif section not in _SECTIONS[language]:
                    raise NotTaken(f"no section {section}")
            elif section == ".PROGRAM":
                found.programs[name][1].append(line.step(number))
            elif section:
                line.datum(section, found.data)
            else:
                raise NotTaken("a line outside of programs and data")
        except NotTaken as why:
            raise NotTaken(f"line {number}: {why}: {raw.strip()}") from None
    return found


_SECTIONS = {
    "as": (".TRANS", ".JOINTS", ".REALS", ".STRINGS"),
    "vplus": (".LOCATIONS", ".REALS", ".STRINGS"),
}


class _Line(Expressions):
    # --- lines ---------------------------------------------------------------------------------

    def header(self) -> tuple[str, list[Node]]:
        self.tokens = [".", *self.tokens[0][1:].split(), *self.tokens[1:]]
        self.at = 2
        name = self.take().lower()
        formals: list[Node] = []
        if self.has("("):
            while not self.has(")"):
                formals.append(self.variable())
                if self.language == "as" and not str(formals[-1][1]).startswith("."):
                    raise NotTaken("a formal argument of AS begins with a dot")
                if self.next() != ")":
                    self.take(",")
        self.end()
        return name, formals

    def datum(self, section: str, data: dict[tuple[str, tuple[int, ...]], Any]) -> None:
        target = self.variable()
        if section in (".REALS", ".STRINGS") and self.language == "as":
            self.take("=")
        values: list[Any] = []
        while self.next():
            sign = -1.0 if self.has("-") else 1.0
            token = self.take()
            values.append(token[1:-1] if token[0] == '"' else sign * float(token))
        wanted = 1 if section in (".REALS", ".STRINGS") else 6
        if len(values) != wanted:
            raise NotTaken(f"{wanted} values are wanted")
        subscripts = tuple(round(float(node[1])) for node in target[2])
        data[target[1], subscripts] = values[0] if wanted == 1 else tuple(values)

    def step(self, number: int) -> Line:
        label = ""
        if self.next().isdigit():
            label = self.take()
        if not self.next():
            return Line(number, label, "", ())
        word, given = self.statement()
        self.end()
        return Line(number, label, word, given)

    def statement(self) -> tuple[str, tuple[Any, ...]]:
        word = self.next()
        if len(self.tokens) > self.at + 1 and self.tokens[self.at + 1] in ("=", "["):
            special = {"BITS", "TIMER"}
            if word not in special:
                return "=", self._assignment()
        self.take()
        own = getattr(self, f"_{word.lower()}", None) if word.isalpha() else None
        if own is not None:
            return word, own()
        if word in words.WORDS[self.language]:
            return word, self._operands(words.WORDS[self.language][word])
        if self.language == "vplus" and word in words.SETTINGS["vplus"] | dict.fromkeys(
            words.SINGLES
        ):
            if self.next() not in ("", "ALWAYS"):
                self.real()
            return word, (self.has("ALWAYS"),)
        if self.language == "as" and (self.next() in ("ON", "OFF") or self.next() == ","):
            while self.has(","):
                self.take()
            return "SWITCH", (self.take("ON", "OFF"),)
        raise NotTaken(f"the manual has no instruction {word}")

    def _assignment(self) -> tuple[Any, ...]:
        target = self.variable()
        self.take("=")
        value = self.expression()
        if target[1].lstrip(".&").startswith("$") != self.is_string(value):
            raise NotTaken("a string is given to a number, or a number to a string")
        if self.is_location(value):
            raise NotTaken("a location is assigned without POINT or SET")
        return target, value

    def _operands(self, kinds: str) -> tuple[Any, ...]:
        found: list[Any] = []
        for position, (kind, mark) in enumerate(re.findall(r"([rln])([?*]?)", kinds)):
            if not self.next() or (position and not self.has(",")):
                if mark == "?":
                    continue
                raise NotTaken("an operand is missing")
            if mark == "?" and self.next() == ",":
                found.append(None)
                continue
            found.append(self.operand(kind))
            while mark == "*" and self.has(","):
                found.append(self.operand(kind))
        return tuple(found)

    def operand(self, kind: str) -> Node:
        if kind == "r":
            return self.real()
        found = self.expression()
        if kind == "n" and not self.is_named(found):
            raise NotTaken("the name of a location is wanted")
        if self.is_string(found) or found[0] == "number":
            raise NotTaken("a location is wanted")
        return found

    def _if(self) -> tuple[Any, ...]:
        condition = self.real()
        if self.has("GOTO"):
            return condition, self.take()
        self.take("THEN")
        return (condition,)

    def _goto(self) -> tuple[Any, ...]:
        return self.take(), self.real() if self.has("IF") else None

    def _else(self) -> tuple[Any, ...]:
        return ()

    def _end(self) -> tuple[Any, ...]:
        return ()

    def _while(self) -> tuple[Any, ...]:
        condition = self.real()
        self.take("DO")
        return (condition,)

    def _do(self) -> tuple[Any, ...]:
        return ()

    def _until(self) -> tuple[Any, ...]:
        return (self.real(),)

    def _for(self) -> tuple[Any, ...]:
        variable = self.variable()
        self.take("=")
        first = self.real()
        self.take("TO")
        last = self.real()
        return variable, first, last, self.real() if self.has("STEP") else ("number", 1.0)

    def _case(self) -> tuple[Any, ...]:
        value = self.real()
        self.take("OF")
        return (value,)

    def _value(self) -> tuple[Any, ...]:
        found = [self.real()]
        while self.has(","):
            found.append(self.real())
        self.take(":")
        return tuple(found)

    def _any(self) -> tuple[Any, ...]:
        if self.language == "as":
            self.take(":")
        else:
            self.has(":")
        return ()

    def _call(self) -> tuple[Any, ...]:
        name = self.take().lower()
        given: list[Node] = []
        if self.has("("):
            while not self.has(")"):
                given.append(self.argument())
                if self.next() != ")":
                    self.take(",")
        return name, given

    def argument(self) -> Node:
        token = self.next()
        if token.startswith(("&", ".&")):
            return self.variable()
        found = self.expression()
        if self.language == "as" and self.is_location(found):
            raise NotTaken("a location is passed without &")
        return found

    def _on(self) -> tuple[Any, ...]:
        return self._reacting("as", "ON")

    def _write(self) -> tuple[Any, ...]:
        if self.language == "as":
            raise NotTaken("the manual has no instruction WRITE")
        self.take("(")
        self.real()
        self.take(")")
        return self._typed("vplus")

    def _prompt(self) -> tuple[Any, ...]:
        while self.next():
            self.expression()
            if self.next():
                self.take(",")
        return ()

    def _accel(self) -> tuple[Any, ...]:
        value = self.real()
        if self.language == "vplus" and self.has(","):
            return value, self.real()
        return value, self.has("ALWAYS")

    def _decel(self) -> tuple[Any, ...]:
        if self.language == "vplus":
            raise NotTaken("the manual has no instruction DECEL")
        return self._accel()

    def _duration(self) -> tuple[Any, ...]:
        if self.language == "as":
            raise NotTaken("the manual has no instruction DURATION")
        return self.real(), self.has("ALWAYS")

    def _pack(self) -> tuple[Any, ...]:
        if self.language == "as":
            raise NotTaken("the manual has no instruction PACK")
        target = self.variable()
        self.take(",")
        first = self.real()
        self.take(",")
        count = self.real()
        self.take("=")
        return target, first, count, self.expression()

    def _calls(self) -> tuple[Any, ...]:
        return self._named_in_a_string("vplus", "CALLS")

    def _scall(self) -> tuple[Any, ...]:
        return self._named_in_a_string("as", "SCALL")

    def _named_in_a_string(self, language: str, word: str) -> tuple[Any, ...]:
        if language != self.language:
            raise NotTaken(f"the manual has no instruction {word}")
        name = self.expression()
        given: list[Node] = []
        if not self.is_string(name):
            raise NotTaken("a string is wanted")
        if self.has("("):
            while not self.has(")"):
                given.append(self.argument())
                if self.next() != ")":
                    self.take(",")
        return name, given

    def _scase(self) -> tuple[Any, ...]:
        if self.language != "as":
            raise NotTaken("the manual has no instruction SCASE")
        value = self.expression()
        self.take("OF")
        return (value,)

    def _svalue(self) -> tuple[Any, ...]:
        if self.language != "as":
            raise NotTaken("the manual has no instruction SVALUE")
        while True:
            self.expression()
            if not self.has(","):
                break
        self.take(":")
        return ()

    def _one(self) -> tuple[Any, ...]:
        return (self._named("as", "ONE"),)

    def _reacte(self) -> tuple[Any, ...]:
        return (self._named("vplus", "REACTE"),)

    def _named(self, language: str, word: str) -> str:
        if language != self.language:
            raise NotTaken(f"the manual has no instruction {word}")
        return self.take() if self.next() else ""

    def _print(self) -> tuple[Any, ...]:
        return self._typed("as")

    def _type(self) -> tuple[Any, ...]:
        return self._typed(self.language)

    def _typed(self, language: str) -> tuple[Any, ...]:
        if language != self.language:
            raise NotTaken("the manual has no such instruction")
        while self.next():
            if self.next().startswith("/") and len(self.next()) > 1:
                self.take()
            else:
                self.expression()
            if self.next():
                self.take(",")
        return ()

    def _speed(self) -> tuple[Any, ...]:
        value = self.real()
        if self.language == "as":
            if self.has("MM"):
                self.take("/")
                self.take("S")
        elif not self.has("MMPS", "IPS", "MONITOR") and self.has(","):
            self.real()
        return value, self.has("ALWAYS")

    def _accuracy(self) -> tuple[Any, ...]:
        if self.language != "as":
            raise NotTaken("the manual has no instruction ACCURACY")
        return self.real(), self.has("ALWAYS"), self.has("FINE")

    def _point(self) -> tuple[Any, ...]:
        return self._located("as")

    def _set(self) -> tuple[Any, ...]:
        return self._located("vplus")

    def _located(self, language: str) -> tuple[Any, ...]:
        if language != self.language:
            raise NotTaken("the manual has no such instruction")
        target = self.variable()
        self.take("=")
        return target, self.operand("l")

    def _here(self) -> tuple[Any, ...]:
        return (self.variable(),)

    def _bits(self) -> tuple[Any, ...]:
        first = [self.real()]
        if self.has(","):
            first.append(self.real())
        self.take("=")
        return *first, self.real()

    def _timer(self) -> tuple[Any, ...]:
        number = self.real()
        self.take("=")
        return number, self.real()

    def _oni(self) -> tuple[Any, ...]:
        return self._reacting("as", "ONI")

    def _reacti(self) -> tuple[Any, ...]:
        return self._reacting("vplus", "REACTI")

    def _react(self) -> tuple[Any, ...]:
        return self._reacting("vplus", "REACT")

    def _reacting(self, language: str, word: str) -> tuple[Any, ...]:
        if language != self.language:
            raise NotTaken(f"the manual has no instruction {word}")
        signal = self.real()
        if language == "as":
            self.take("CALL", "GOTO")
            self.take()
        elif self.has(","):
            self.take()
        return signal, self.real() if self.has(",") else None

    def _auto(self) -> tuple[Any, ...]:
        if self.language == "as":
            raise NotTaken("AS declares no variables")
        names = [self.variable()]
        while self.has(","):
            names.append(self.variable())
        return (names,)

    def _enable(self) -> tuple[Any, ...]:
        return self._switches("ENABLE")

    def _disable(self) -> tuple[Any, ...]:
        return self._switches("DISABLE")

    def _switches(self, word: str) -> tuple[Any, ...]:
        if self.language == "as":
            raise NotTaken(f"the manual has no instruction {word}")
        self.take()
        while self.has(","):
            self.take()
        return ()

    def _parameter(self) -> tuple[Any, ...]:
        if self.language == "as":
            raise NotTaken("the manual has no instruction PARAMETER")
        self.variable()
        self.take("=")
        return (self.real(),)

    def _execute(self) -> tuple[Any, ...]:
        """`EXECUTE task program(arguments), cycles, step, priority` [V+ Language Reference]."""
        if self.language != "vplus":
            raise NotTaken("AS starts programs with PCEXECUTE")
        task = self.take()
        if not task.isdigit() or not 0 <= int(task) <= 27:
            raise NotTaken("the number of a task is wanted")
        name = self.take()
        if self.has("("):
            self.take(")")  # nothing is passed to programs that are read here
        more: list[Any] = []
        while self.has(","):
            more.append(self.real())
        if len(more) > 3:
            raise NotTaken("cycles, a step and a priority may stand behind the program")
        return int(task), name, more

    def _pcexecute(self) -> tuple[Any, ...]:
        if self.language != "as":
            raise NotTaken("V+ starts programs with EXECUTE")
        if self.next().isdigit():
            self.take()
            self.take(":")
        if self.next():
            self.take()
        while self.has(","):
            self.real()
        return ()
