"""Idioms of other languages, told with what the language has for them."""

import re

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.lang.problems import short
from vrts.lang.reading.odd_signs import STRAY_CHARACTER
from vrts.lang.said_by_relatives import help_in_as, step_in_as
from vrts.lang.steps.advising.adviser import (
    OTHER_LANGUAGE,
    PRECISE,
    STRUCTURE,
    Advised,
    Adviser,
    Line,
)
from vrts.lang.steps.advising.open_case import in_case, open_words
from vrts.lang.steps.idioms.idiom import Idiom, Matched, filled
from vrts.lang.steps.idioms.tables import matches
from vrts.lang.steps.idioms.wording import (
    else_word,
    first_word,
    indented,
    same_steps,
    smallest_change,
    what_to_write,
    with_article,
)
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Tried
from vrts.lang.steps.unknown_words import (
    OTHER_DIALECT,
)
from vrts.lang.vocabulary.lookup import look_up

_CALL = "call_{n} , {e}"  # an argument, or another program
_MMPS, _MM_S = "MMPS", "MM/S"  # of VAL-II and V+, and of AS
_CONTINUE = "continue"
_RELATIVES = ("V+", "AS")  # which have such words themselves
_TWAIT = "TWAIT holds the program for seconds, DELAY the arm"
_NEXT = ("next", "next_{n}")  # of BASIC, which end a FOR, or of V+, which go on with the loop
_BASIC_NEXT = "NEXT of V+ goes on with the next pass of a loop"
_OVER_END = (
    "put the steps that follow between IF and END, or jump to a label before the END of the loop: "
    "`GOTO 10`, and `10 END`"
)
_LOOPS = frozenset({"FOR", "WHILE", "DO"})
_ANY = "ANY"  # which an IF has ELSE for
_OF_IF = "in an IF the steps for where the condition is false stand behind ELSE"
_KRL_LOOP = "LOOP"  # which begins what ENDLOOP ends
_ENDLOOP = re.compile(r"^[ \t]*END[ _]?LOOP\b", re.I | re.M)
_OPENS_LOOP = re.compile(r"^[ \t]*(?:\d+[ \t]+)?(?:DO|WHILE|FOR)\b", re.I | re.M)
ELSE_IF = "ELSEIF"  # `ELSEIF x THEN`, which stands for ELSE and IF


class IdiomAdvice(Adviser):
    """Explains lines by the idioms of other languages."""

    def explain(self, line: Line, mark: int) -> Advised | None:
        """Explain a line that is an idiom of another language."""
        told = self.problems.found[mark:]
        if told and told[0].headline.endswith("is a program, not an instruction"):
            return None
        if self._parenthesised(line, told):
            return None
        for text in dict.fromkeys((line.text, line.raw)):
            for found in matches(text):
                advised = self._fits(found, line._replace(text=text), mark)
                if advised is not None:
                    return advised
        return None

    def _parenthesised(self, line: Line, told: list[Diagnostic]) -> bool:
        """Whether a function lacks its parentheses, and is right with them."""
        if len(told) != 1 or not told[0].headline.endswith("without parentheses"):
            return False
        if told[0].fix is None:
            return False
        edit = told[0].fix
        shift = edit.span.start - self.problems.span(line.at, line.at).start
        end = shift + edit.span.end - edit.span.start
        return self._is_right(line.text[:shift] + edit.replacement + line.text[end:])

    def _fits(self, found: Matched, line: Line, mark: int) -> Advised | None:
        if found.idiom.of in _RELATIVES and not self.problems.dialect.has("2"):
            return None
        found = self._in_dialect(found)
        idiom = found.idiom
        if idiom.word == ELSE_IF:
            return self._else_if(found, line, mark)
        if idiom.pattern == _CALL and self._is_program(found.parts["e"]):
            says, instead = "CALL runs one program", "CALL {n}\nCALL {e}"
            idiom = idiom._replace(says=says, instead=instead)
            found = found._replace(idiom=idiom)
        if idiom.word == _ANY and not in_case(self.problems.source.text[: line.at]):
            if idiom.pattern.startswith("<others|"):
                return None
            idiom = idiom._replace(instead="ELSE", word="ELSE", note=_OF_IF)
            found = found._replace(idiom=idiom)
        if idiom.pattern in _NEXT and self._goes_on(line):
            idiom = idiom._replace(says=_BASIC_NEXT, instead="", help=_OVER_END, word="")
            found = found._replace(idiom=idiom)
        if idiom.word == _KRL_LOOP:
            if not self._begins_loop(line):
                return None  # the one of BASIC, which ends
            idiom = idiom._replace(word="")
            found = found._replace(idiom=idiom)
        tried = self.repair.steps(indented(found.instead, self._indent(line)))
        if idiom.instead and tried is None:
            return None
        guessed = tried is not None and (tried.fixes or not idiom.sure)
        if guessed and self._apart(line.text) is not None:
            return None
        named = look_up(first_word(line.text), self.problems.dialect).word is not None
        if named and idiom.pattern.startswith("{n} :"):
            return None  # `READY:` is no label
        if not idiom.sure and self.problems.found[mark].rule == INVALID_EXPRESSION:
            return None
        if tried is not None and self._mends(line, mark, tried):
            return Advised(line.kept)
        reported = self.problems.found[mark:]
        told = reported[0] if len(reported) == 1 else None
        self.problems.forget(mark)
        word = idiom.word or (self._word_of(tried.text) if tried is not None else None)
        self._told(found, line, tried, told)
        return Advised(word)

    def _in_dialect(self, found: Matched) -> Matched:
        """An idiom with what the relatives of VAL-II have for it."""
        idiom, dialect = found.idiom, self.problems.dialect
        if dialect.is_as:
            note = _TWAIT if idiom.instead.startswith("DELAY ") else idiom.note
            says, instead = idiom.says.replace(_MMPS, _MM_S), step_in_as(idiom.instead)
            idiom = idiom._replace(says=says, instead=instead, note=note)
            idiom = idiom._replace(help=help_in_as(idiom.help, ""))
        if dialect.is_vplus and idiom.pattern == _CONTINUE:
            idiom = idiom._replace(instead="NEXT", help="")
        return found._replace(idiom=idiom)

    def _goes_on(self, line: Line) -> bool:
        """Whether NEXT stands in an IF within a loop, which has an END of its own."""
        around = open_words(self.problems.source.text[: line.at])
        return around[:1] == ["IF"] and not _LOOPS.isdisjoint(around) and self._is_closed(line)

    def _is_closed(self, line: Line) -> bool:
        """Whether END or ELSE follows for the IF around a line."""
        rest = self.problems.source.text[line.at + len(line.text) :]
        first = rest.lstrip().split("\n", 1)[0].split(";")[0].strip().upper()
        return first in ("END", "ELSE", "ENDIF", "END IF")

    def _begins_loop(self, line: Line) -> bool:
        """Whether LOOP begins a loop, as in KRL: ENDLOOP follows, or it ends nothing."""
        text = self.problems.source.text
        if _ENDLOOP.search(text, line.at):
            return True
        program = text[text.upper().rfind(".PROGRAM", 0, line.at) + 1 : line.at]
        return _OPENS_LOOP.search(program) is None

    def _is_program(self, name: str) -> bool:
        headed = rf"^[ \t]*\.PROGRAM[ \t]+{re.escape(name)}(?![\w.])"
        return re.search(headed, self.problems.source.text, re.I | re.M) is not None

    def _mends(self, line: Line, mark: int, tried: Tried) -> bool:
        """Whether what the parser has to say leads to the same step."""
        told = self.problems.found[mark:]
        if len(told) != 1 or told[0].fix is None or told[0].fix.more:
            return False
        fix = told[0].fix
        shift = fix.span.start - self.problems.span(line.at, line.at).start
        finish = shift + fix.span.end - fix.span.start
        before, after = line.text[: max(shift, 0)], line.text[finish:]
        found = self.repair.steps(before + fix.replacement + after)
        return found is not None and not found.fixes and same_steps(found.text, tried.text)

    def _told(
        self, found: Matched, line: Line, tried: Tried | None, told: Diagnostic | None
    ) -> None:
        """Report an idiom; what was told keeps its code and place where that says enough."""
        idiom = found.idiom
        start, end = line.at, line.at + len(line.text)
        help_ = filled(idiom.help, found.parts) or (
            what_to_write(tried.text, line.text) if tried is not None else ""
        )
        fix = None
        if idiom.drop:
            fix = self._without(line)
        elif tried is not None and idiom.sure:
            begin, finish, instead = smallest_change(line.text, tried.text)
            fix = self.problems.replace(start + begin, start + finish, instead)
        first = first_word(line.text)
        title = self.problems.dialect.title
        says = filled(idiom.says, found.parts)
        notes = (idiom.note,) if idiom.note else ()
        first_known = look_up(first, self.problems.dialect).word is not None
        foreign = bool(first) and not first_known and _is_word(idiom)
        stray = told is not None and told.rule == STRAY_CHARACTER  # `print('part')`
        group = idiom.instead in STRUCTURE  # `DEFAULT:` of a CASE is no command for the monitor
        precise = told is not None and told.rule in PRECISE and not (foreign and (stray or group))
        known = told is not None and (precise or not (says or idiom.of))
        rule, primary, about = OTHER_LANGUAGE, self.problems.label(start, end), notes
        written = f"`{short(line.text)}`"
        of = idiom.of if "other" not in idiom.of else ""
        headline = says or (f"{written} is {of}, not {title}" if of else f"{written} is no step")
        if known:
            assert told is not None
            rule, about = told.rule, (*notes, *told.notes)
            primary = told.primary or primary
            headline = says or told.headline
        elif foreign:
            label = f"a word of {of}" if of else ""
            rule, primary = OTHER_DIALECT, self.problems.label(start, start + len(first), label)
            headline = f"{first.upper()} is not {with_article(title)} instruction"
            about = (*((says,) if says else ()), *notes, "VAL-II says *Unknown instruction*")
        self.problems.add(
            Diagnostic(
                rule,
                Severity.ERROR,
                headline,
                primary,
                notes=about,
                help=(help_,) if help_ else (),
                fix=fix,
            )
        )
        self.habits.note(self.problems, _habit(line, idiom, tried, first.upper()))

    def _else_if(self, found: Matched, line: Line, mark: int) -> Advised:
        """`ELSEIF x THEN`: where its END belongs is for the blocks to say."""
        tried = self.repair.steps(f"IF {found.parts['e']} THEN")
        self.problems.forget(mark)
        self.problems.error(
            OTHER_LANGUAGE,
            f"{self.problems.dialect.title} has no {else_word(line.text)}",
            line.at,
            line.at + len(line.text),
            help=("write ELSE, in the line below a new IF, and an END of its own for that",),
        )
        self.habits.note(self.problems, ELSE_IF)
        return Advised(ELSE_IF, tried.text if tried is not None else None)


def _is_word(idiom: Idiom) -> bool:
    """Whether an idiom begins with a word of its own."""
    return idiom.pattern[0] == "<" or idiom.pattern[0].isalpha()


def _habit(line: Line, idiom: Idiom, tried: Tried | None, first: str) -> str:
    """Return what an idiom is a habit of: braces, cases, or itself."""
    if idiom.habit:
        return idiom.habit
    if "{" in line.raw or "}" in line.raw:
        return "braces"
    instead = tried.text.split()[0] if tried is not None else ""
    ends_cases = line.text.upper().endswith(("SELECT", "SWITCH", "TEST", "CASE"))
    if instead in ("CASE", "VALUE", "ANY") or (instead == "END" and ends_cases):
        return "cases"
    return f"idiom {idiom.pattern} {first}"
