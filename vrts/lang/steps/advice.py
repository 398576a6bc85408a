"""What to say of a line that is no step, by what its writer most likely meant.

The idioms of other languages come first; then what the parser itself would say, if it has a fix;
then comments and signs of other languages; then the parser's word. Whatever is to be written
instead has been tried out.
"""

import re
from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Edit, Fix, Rule, Severity
from vrts.lang.grammar.shapes import LABEL_EXPECTED, TOO_MANY_OPERANDS, UNEXPECTED_TEXT
from vrts.lang.problems import LIMIT, Problems, short
from vrts.lang.reading.odd_signs import STRAY_CHARACTER
from vrts.lang.steps.habits import Habits
from vrts.lang.steps.idioms import comments, signs
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
from vrts.lang.steps.misread.table import meant_by_line
from vrts.lang.steps.missing_parts import MISSING_KEYWORD
from vrts.lang.steps.near_words import acting_at_once, meant_by, short_for, slips
from vrts.lang.steps.one_line import INNER, ONE_LINE, Rows, rows_of
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair, Tried
from vrts.lang.steps.unknown_words import (
    AMBIGUOUS_KEYWORD,
    MONITOR_COMMAND,
    OTHER_DIALECT,
    UNKNOWN_INSTRUCTION,
)
from vrts.lang.vocabulary.lookup import look_up, spellings

OTHER_LANGUAGE = Rule("V164", "other-language")

ELSE_IF = "ELSEIF"  # `ELSEIF x THEN`, which stands for ELSE and IF
_CASE_LABEL = re.compile(
    r"(?P<margin>[ \t]*)(?P<value>\d+(?:[ \t]*,[ \t]*\d+)*)[ \t]*(?P<colon>:)(?P<rest>.*)"
)
_BLOCK_WORD = re.compile(
    r"^[ \t]*(?:\d+[ \t]+)?(IF|FOR|WHILE|CASE|DO|END|UNTIL)\b(.*)$", re.I | re.M
)
_LETTERS = re.compile(r"[A-Za-z][A-Za-z0]*")
_NUMBER = re.compile(r"[ \t]*[\d.]+[ \t]*")
_PRECISE = frozenset(
    {
        UNEXPECTED_TEXT,
        TOO_MANY_OPERANDS,
        LABEL_EXPECTED,
        MONITOR_COMMAND,
        STRAY_CHARACTER,
        MISSING_KEYWORD,
    }
)  # codes that say what it is, whatever language it comes from
STRUCTURE = frozenset({"IF", "WHILE", "FOR", "CASE", "DO", "END", "UNTIL", "ELSE", "VALUE", "ANY"})


class Advised(NamedTuple):
    """A line that was explained: the structure word it stands for, and the steps that are meant."""

    word: str | None
    meant: str | None = None


class Line(NamedTuple):
    """The statement of a line in its file."""

    text: str
    at: int
    raw: str  # with what would be its comment
    kept: str | None  # the structure word that the parser knows


class Advice:
    """Explains lines that are no steps, each by one diagnostic."""

    def __init__(self, problems: Problems, repair: Repair, habits: Habits) -> None:
        self.problems = problems
        self.repair = repair
        self.habits = habits
        self.open_comment = False  # of `/*`

    def explain(self, line: Line, mark: int) -> Advised | None:
        """Put something better in the place of what was reported since a mark, if there is."""
        problems = self.problems
        if mark >= LIMIT:
            return None  # it would not be shown
        told = problems.found[mark:]
        if line.text.upper() == "THEN" and self._then(line, mark):
            return Advised(None)
        for better in (
            self._quoted,
            self._comment,
            self._case_label,
            self._misread,
            self._idiom,
            self._rows,
            self._word,
            self._qualifier,
        ):
            found = better(line, mark)
            if found is not None:
                return found
        if len(told) == 1 and told[0].fix is not None:
            return self._decimal(line, mark)
        return self._signs(line, mark) or self._comment_behind(line, mark, alone=False)

    def _then(self, line: Line, mark: int) -> bool:
        """`THEN` below its IF, which was told to have none: one mistake, mended in both lines."""
        before = self.problems.found[mark - 1] if mark else None
        if before is None or before.rule != MISSING_KEYWORD or before.fix is None:
            return False
        place, source = before.fix.span, self.problems.source
        between = source.text[place.end : line.at]
        if place.source is not source or between.strip() or between.count("\n") != 1:
            return False
        self.problems.forget(mark)
        fix = Fix.from_edits((*before.fix.edits, *self._without(line).edits))
        help_ = "write THEN at the end of the line of its IF"
        self.problems.found[mark - 1] = replace(before, help=(help_,), fix=fix)
        return True

    def _quoted(self, line: Line, mark: int) -> Advised | None:
        """Quotes and per cent before they are taken for comments; comments before idioms."""
        found = comments.behind(line.text)
        if found is None:
            return None
        divides = found.sign == "//" and _NUMBER.fullmatch(line.text[found.end :]) is not None
        if found.sign == "'":  # `print('part')`
            return self._idiom(line, mark) or self._signs(line, mark)
        if found.sign in ("%", "!") or (divides and found.before):
            return self._signs(line, mark)
        return self._comment_behind(line, mark)

    def _rows(self, line: Line, mark: int) -> Advised | None:
        """Several steps on one line; where the END of an open one belongs, the blocks say."""
        rows = self._apart(line.text)
        if rows is None or self.problems.dialect.is_as:
            return None
        told = self.problems.found[mark:]
        headline = "each step stands on a line of its own"
        if rows.between:
            headline = f"`{rows.between}` separates no steps: {headline}"
        elif len(told) == 1 and told[0].headline.endswith("its line"):
            headline = told[0].headline
        elif len(told) == 1 and told[0].headline.endswith("takes no operand"):
            headline = f"{rows.words[0]} ends its line"
        elif rows.words[0] in STRUCTURE:
            headline = f"{rows.words[0]} ends its line: {headline}"
        self.problems.forget(mark)
        written, rows = rows, rows.settled
        help_ = "give each a line of its own"
        if rows != written:
            help_ = "a setting stands on the line before the motion it is for"
        shown = ", ".join(f"`{text}`" for text in rows.texts)
        instead = indented(rows.indented(), self._indent(line))
        ends = line.at + len(line.text)
        self.problems.error(
            UNEXPECTED_TEXT,
            headline,
            line.at + rows.second,
            ends,
            "another step begins here",
            notes=("VAL-II says *Unexpected text at end of line*",),
            help=(f"{help_}: {shown}",),
            fix=self.problems.replace(line.at, ends, instead)
            if rows.word not in ONE_LINE.values()
            else None,
        )
        self.habits.note(self.problems, "steps on one line")
        return Advised(rows.word, rows.indented())

    def _apart(self, text: str) -> Rows | None:
        return rows_of(text, spellings(self.problems.dialect), self._is_step)

    def _is_step(self, text: str) -> bool:
        tried = self.repair.steps(text)
        return tried is not None and not tried.fixes

    def comment(self, line: Line, mark: int) -> Advised | None:
        """Explain a line by the comment in it alone."""
        return self._comment(line, mark) or self._comment_behind(line, mark, alone=False)

    # --- comments -------------------------------------------------------------------------------

    def _comment(self, line: Line, mark: int) -> Advised | None:
        found = comments.leading(line.text)
        if found is None:
            return None
        self.problems.forget(mark)
        self._comment_told(line, found)
        return Advised(None)

    def _comment_behind(self, line: Line, mark: int, *, alone: bool = True) -> Advised | None:
        """A comment behind a step; `alone`: which is right but for it."""
        found = comments.behind(line.text)
        tried = self.repair.steps(found.before) if found is not None else None
        if found is None or tried is None or tried.fixes > (not alone):
            return None
        self.problems.forget(mark)
        self._comment_told(line, found)
        return Advised(self._word_of(tried.text))

    def _comment_told(self, line: Line, found: comments.Comment) -> None:
        start, end = line.at + found.start, line.at + found.end
        self.open_comment = found.goes_on and "*/" not in line.raw and "*)" not in line.raw
        closing = found.closed_in(line.text)
        fix = self.problems.replace(start, end, ";")
        if closing is not None:
            first, last = line.at + closing[0], line.at + closing[1]
            fix = fix._replace(more=(Edit(self.problems.span(first, last), ""),))
        self.problems.error(
            OTHER_LANGUAGE,
            f"`{found.sign}` begins no comment",
            start,
            end,
            help=("begin comments with `;`",),
            fix=fix,
        )
        self.habits.note(self.problems, f"comment {found.sign}")

    def inside_comment(self, start: int, end: int, text: str) -> None:
        """Report a line of a comment that began with `/*` in a line above."""
        self.open_comment = "*/" not in text and "*)" not in text
        self.problems.error(
            OTHER_LANGUAGE,
            "this is meant as a comment",
            start,
            end,
            help=("begin comments with `;`",),
            fix=self.problems.replace(start, start, "; "),
        )
        self.habits.note(self.problems, "comment /*")

    def _case_label(self, line: Line, mark: int) -> Advised | None:
        """`1:` inside a CASE, where C has `case 1:`."""
        text = self.problems.source.text
        begin = text.rfind("\n", 0, line.at) + 1
        found = _CASE_LABEL.fullmatch(text[begin : line.at] + line.text)
        if found is None or not _in_case(text[:begin]):
            return None
        self.problems.forget(mark)
        start, end = begin + found.start("value"), begin + found.end("colon")
        rest = found["rest"].strip()
        instead = f"VALUE {found['value'].strip()}:"
        if rest:
            instead += f"\n{found['margin']}{INNER}{rest}"
        self.problems.error(
            OTHER_LANGUAGE,
            "a group of a CASE begins with VALUE",
            start,
            end,
            help=(f"write `VALUE {found['value'].strip()}:`",),
            fix=self.problems.replace(start, line.at + len(line.text) if rest else end, instead),
        )
        self.habits.note(self.problems, "cases")
        return Advised("VALUE")

    def _misread(self, line: Line, mark: int) -> Advised | None:
        found = meant_by_line(line.text, self.repair, self.problems.dialect)
        if found is None:
            return None
        told = self.problems.found[mark:]
        if told and told[0].headline.endswith("is a program, not an instruction"):
            return None
        self.problems.forget(mark)
        start, end = line.at + found.start, line.at + found.end
        fix = None
        if found.instead is not None:
            instead = indented(found.instead, self._indent(line))
            fix = self.problems.replace(start, end, instead, sure=found.sure)
        self.problems.error(
            found.rule, found.headline, start, end, notes=found.notes, help=found.help, fix=fix
        )
        self.habits.note(self.problems, f"misread {found.headline}")
        return Advised(line.kept)

    # --- idioms ---------------------------------------------------------------------------------

    def _idiom(self, line: Line, mark: int) -> Advised | None:
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

    def _is_right(self, text: str) -> bool:
        tried = self.repair.steps(text)
        return tried is not None and not tried.fixes

    def _fits(self, found: Matched, line: Line, mark: int) -> Advised | None:
        idiom = found.idiom
        if idiom.word == ELSE_IF:
            return self._else_if(found, line, mark)
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
        precise = told is not None and told.rule in _PRECISE and not (foreign and (stray or group))
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
            f"VAL-II has no {else_word(line.text)}",
            line.at,
            line.at + len(line.text),
            help=("write ELSE, in the line below a new IF, and an END of its own for that",),
        )
        self.habits.note(self.problems, ELSE_IF)
        return Advised(ELSE_IF, tried.text if tried is not None else None)

    def _without(self, line: Line) -> Fix:
        """Return a fix that takes a step out: its whole line, where nothing else stands there."""
        text = self.problems.source.text
        begin = text.rfind("\n", 0, line.at) + 1
        end = line.at + len(line.text)
        finish = text.find("\n", end)
        finish = len(text) if finish < 0 else finish + 1
        if text[begin : line.at].strip() or text[end:finish].strip(" \t;\n"):
            return self.problems.replace(line.at, end, "")
        return self.problems.replace(begin, finish, "")

    # --- words that are nearly right ------------------------------------------------------------

    def _word(self, line: Line, mark: int) -> Advised | None:
        """A first word with a slip in it: what is near and makes a step of the line."""
        told = self.problems.found[mark:]
        first = first_word(line.text)
        if len(told) == 1 and told[0].rule == AMBIGUOUS_KEYWORD:
            return self._short(line, mark, first)
        if len(told) != 1 or told[0].rule != UNKNOWN_INSTRUCTION:
            return None
        rest, dialect = line.text[len(first) :], self.problems.dialect
        rivals = meant_by(first, rest, self.repair, dialect)
        if not rivals:
            return None
        word, tried = rivals[0]
        self.problems.forget(mark)
        start, end = line.at, line.at + len(first)
        names = " or ".join(f"`{rival}`" for rival, _ in rivals[:3])
        names += acting_at_once(word) if len(rivals) == 1 else ""
        self.problems.error(
            UNKNOWN_INSTRUCTION,
            f"`{short(first)}` is not an instruction",
            start,
            end,
            notes=("VAL-II says *Unknown instruction*",),
            help=(f"did you mean {names}?",),
            fix=self.problems.replace(start, end, word) if len(rivals) == 1 else None,
            data={"word": first},
        )
        return Advised(self._word_of(tried.text))

    def _qualifier(self, line: Line, mark: int) -> Advised | None:
        """`IF x THNE`: a slip in a word that the instruction wants."""
        told = self.problems.found[mark]
        word = look_up(first_word(line.text), self.problems.dialect).word
        if word is None or not word.qualifiers:
            return None
        for found in _LETTERS.finditer(line.text, len(first_word(line.text))):
            for meant in slips(found.group().upper(), word.qualifiers):
                text = f"{line.text[: found.start()]}{meant}{line.text[found.end() :]}"
                tried = self.repair.steps(text)
                if tried is None or tried.fixes:
                    continue
                self.problems.forget(mark)
                start, end = line.at + found.start(), line.at + found.end()
                self.problems.error(
                    told.rule,
                    f"`{found.group()}` is misspelt",
                    start,
                    end,
                    notes=told.notes,
                    help=(f"did you mean `{meant}`?",),
                    fix=self.problems.replace(start, end, meant),
                )
                return Advised(self._word_of(tried.text))
        return None

    def _short(self, line: Line, mark: int, first: str) -> Advised | None:
        """A word that several begin with: the one that begins all the others, or alone fits."""
        rest = line.text[len(first) :]
        meant = short_for(first, rest, self.repair, self.problems.dialect)
        if meant is None:
            return None
        told = self.problems.found[mark]
        self.problems.forget(mark)
        fix = self.problems.replace(line.at, line.at + len(first), meant)
        help_ = f"did you mean `{meant}`{acting_at_once(meant)}? Write the word in full"
        self.problems.add(replace(told, help=(help_,), fix=fix))
        return Advised(self._word_of(meant + rest))

    # --- signs ----------------------------------------------------------------------------------

    def _decimal(self, line: Line, mark: int) -> Advised | None:
        """`IF x > 2,5 THEN`, where the parser would break the step at the comma."""
        return self._signs(line, mark, signs.decimals(line.text), at_once=True)

    def _signs(
        self,
        line: Line,
        mark: int,
        ways: Iterable[tuple[signs.Signs, str]] | None = None,
        *,
        at_once: bool = False,
    ) -> Advised | None:
        """Signs of other languages; `at_once`: with nothing else to mend."""
        for found, text in signs.replaced(line.text) if ways is None else ways:
            tried = self.repair.steps(text)
            if tried is None or (at_once and tried.fixes):
                continue
            told = self.problems.found[mark]
            self.problems.forget(mark)
            start, end, instead = smallest_change(line.text, tried.text)
            primary = self.problems.label(line.at + start, line.at + max(end, start))
            precise = (told.rule in _PRECISE and not at_once) or not found.says
            self.problems.add(
                Diagnostic(
                    told.rule if precise else OTHER_LANGUAGE,
                    Severity.ERROR,
                    found.says or told.headline,
                    (told.primary or primary) if precise else primary,
                    notes=told.notes,
                    help=(found.help,),
                    fix=self.problems.replace(
                        line.at + start, line.at + end, instead, sure=found.sure
                    ),
                )
            )
            return Advised(self._word_of(tried.text))
        return None

    # --- help for all of them -------------------------------------------------------------------

    def _word_of(self, text: str) -> str | None:
        """Return the structure word that steps begin with."""
        first = text.split("\n")[0].strip()
        word = look_up(first_word(first), self.problems.dialect).word if first else None
        if word is None or word.text not in STRUCTURE:
            return word.text if word is not None else None
        if "\n" in text and text.rstrip().upper().endswith("END"):
            return None  # it closes what it opens
        if word.text == "IF" and " GOTO " in first.upper():
            return None
        return word.text

    def _indent(self, line: Line) -> str:
        text = self.problems.source.text
        begin = text.rfind("\n", 0, line.at) + 1
        before = text[begin : line.at]
        return before if not before.strip() else " " * len(before.expandtabs(8))


def _in_case(above: str) -> bool:
    """Whether the innermost structure that lines leave open is a CASE, by their first words."""
    begin = above.upper().rfind(".PROGRAM")
    depth = 0
    for word, rest in reversed(_BLOCK_WORD.findall(above[max(begin, 0) :])):
        upper = word.upper()
        if upper in ("END", "UNTIL"):
            depth += 1
        elif upper != "IF" or "GOTO" not in rest.upper():
            if not depth:
                return bool(upper == "CASE")
            depth -= 1
    return False


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
