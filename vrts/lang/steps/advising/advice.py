"""What to say of a line that is no step, by what its writer most likely meant.

The idioms of other languages come first; then what the parser itself would say, if it has a fix;
then comments and signs of other languages; then the parser's word. Whatever is to be written
instead has been tried out.
"""

import re
from dataclasses import replace

from vrts.base.diagnostic import Fix
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.reading.nesting import MISSING_BRACKET, MISSING_PARENTHESIS
from vrts.lang.steps.advising.adviser import OTHER_LANGUAGE, STRUCTURE, Advised, Adviser, Line
from vrts.lang.steps.advising.comments_told import CommentAdvice
from vrts.lang.steps.advising.continued import ContinuedAdvice
from vrts.lang.steps.advising.idioms_told import IdiomAdvice
from vrts.lang.steps.advising.open_case import in_case
from vrts.lang.steps.advising.signs_told import SignAdvice
from vrts.lang.steps.advising.words_told import WordAdvice
from vrts.lang.steps.habits import Habits
from vrts.lang.steps.idioms import comments
from vrts.lang.steps.idioms.wording import indented, smallest_change
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.misread.relatives.slips import slip
from vrts.lang.steps.misread.table import meant_after_all, meant_by_line
from vrts.lang.steps.missing_parts import MISSING_KEYWORD
from vrts.lang.steps.one_line import INNER, ONE_LINE
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.unknown_words import MONITOR_COMMAND

_CASE_LABEL = re.compile(
    r"(?P<margin>[ \t]*)(?P<value>\d+(?:[ \t]*,[ \t]*\d+)*)[ \t]*(?P<colon>:)(?P<rest>.*)"
)
_BEHIND = re.compile(r"[ \t]*(?=[,)=:]|[-+*/]|[ \t](?:THEN|DO|OF|TO|STEP|GOTO)\b)", re.IGNORECASE)
_GOES_ON = re.compile(r"[ \t]+(?=(?:THEN|DO|OF|TO|STEP|GOTO)\b)", re.IGNORECASE)
_CLOSES_DO = re.compile(r"^[ \t]*(?:\d+[ \t]+)?(?:UNTIL|LOOP|WHILE|REPEAT|\}|END[ \t]*DO)", re.M)
_NEVER_CLOSED = (MISSING_PARENTHESIS, MISSING_BRACKET)
_NUMBER = re.compile(r"[ \t]*[\d.]+[ \t]*")


class Advice(Adviser):
    """Explains lines that are no steps, each by one diagnostic."""

    def __init__(self, problems: Problems, repair: Repair, habits: Habits) -> None:
        super().__init__(problems, repair, habits)
        self.comments = CommentAdvice(problems, repair, habits)
        self.idioms = IdiomAdvice(problems, repair, habits)
        self.words = WordAdvice(problems, repair, habits)
        self.signs = SignAdvice(problems, repair, habits)
        self.continued = ContinuedAdvice(problems, repair, habits)

    def explain(self, line: Line, mark: int) -> Advised | None:
        """Put something better in the place of what was reported since a mark, if there is."""
        problems = self.problems
        if mark >= LIMIT:
            return None  # it would not be shown
        told = problems.found[mark:]
        if line.text.upper() == "THEN" and self._then(line, mark):
            return Advised(None)
        for better in (
            self.continued.explain,
            self._semicolons,
            self._quoted,
            self.comments.leading,
            self._case_label,
            self._misread,
            self._at_the_monitor,
            self.idioms.explain,
            self._rows,
            self._after_all,
            self.words.first,
            self.words.qualifier,
        ):
            found = better(line, mark)
            if found is not None:
                return found
        if len(told) == 1 and told[0].rule in _NEVER_CLOSED and told[0].fix is None:
            self._closed(line, mark)
            return None
        if len(told) == 1 and told[0].fix is not None:
            return self.signs.decimal(line, mark)
        return self.signs.explain(line, mark) or self.comments.behind(line, mark, alone=False)

    def _closed(self, line: Line, mark: int) -> None:
        """`IF (SIG(1001) THEN`, `MAX(1, 2`: where the parenthesis belongs, if in one place only."""
        told = self.problems.found[mark]
        sign = {"`(`": ")", "`[`": "]"}.get(told.headline[:3])
        if sign is None:
            return
        ends = _GOES_ON if sign == ")" else _BEHIND
        good: list[int] = []
        for at in (*(found.start() for found in ends.finditer(line.text)), len(line.text.rstrip())):
            if self.repair.at_once(f"{line.text[:at]}{sign}{line.text[at:]}") is not None:
                good.append(at)
        if len(good) == 1:
            at = line.at + good[0]
            self.problems.found[mark] = replace(told, fix=self.problems.replace(at, at, sign))

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
            return self.idioms.explain(line, mark) or self.signs.explain(line, mark)
        if found.sign in ("%", "!") or (divides and found.before):
            text = found.before.endswith('"')  # `TYPE "%d" % n`
            advised = self.idioms.explain(line, mark) if text else None
            return advised or self.signs.explain(line, mark)
        return self.comments.behind(line, mark)

    def _semicolons(self, line: Line, mark: int) -> Advised | None:
        """`TRANS(1, 2, 3; 4, 5, 6)`: where a `;` breaks the step off, and a comma does not."""
        told = self.problems.found[mark:]
        if len(told) != 1 or told[0].rule not in _NEVER_CLOSED or ";" not in line.raw:
            return None
        tried = self.repair.at_once(line.raw.replace(";", ","))
        if tried is None:
            return None
        self.problems.forget(mark)
        start, end, instead = smallest_change(line.raw, tried.text)
        self.problems.error(
            OTHER_LANGUAGE,
            "`;` begins a comment, a comma parts operands",
            line.at + start,
            line.at + end,
            help=(f"write `,` instead of `;`: `{tried.text}`",),
            fix=self.problems.replace(line.at + start, line.at + end, instead),
        )
        return Advised(self._word_of(tried.text))

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

    def _at_the_monitor(self, line: Line, mark: int) -> Advised | None:
        """`DO MOVE a`, as an operator types it: no UNTIL follows in the program."""
        if line.text[:3].upper() != "DO ":
            return None
        text = self.problems.source.text
        rest = text[line.at + len(line.text) :].upper().partition("\n.END")[0]
        step = line.text.split(None, 1)[-1]
        tried = self.repair.at_once(step)
        if tried is None or _CLOSES_DO.search(rest):
            return None
        if self._word_of(step) in STRUCTURE:
            return None  # `DO UNTIL n > 3`, as in BASIC
        self.problems.forget(mark)
        self.problems.error(
            MONITOR_COMMAND,
            "DO before a step is a command for the monitor",
            line.at,
            line.at + len("DO"),
            notes=("in a program DO begins a loop that ends with UNTIL",),
            help=(f"leave DO out: write `{step}`",),
            fix=self.problems.replace(line.at, line.at + len(line.text) - len(step), ""),
        )
        self.habits.note(self.problems, "do before a step")
        return Advised(self._word_of(tried.text))

    def _case_label(self, line: Line, mark: int) -> Advised | None:
        """`1:` inside a CASE, where C has `case 1:`."""
        text = self.problems.source.text
        begin = text.rfind("\n", 0, line.at) + 1
        found = _CASE_LABEL.fullmatch(text[begin : line.at] + line.text)
        if found is None or not in_case(text[:begin]):
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

    def _of_monitor(self, line: Line, mark: int) -> bool:
        """Whether V+ or AS was told that a line is a command for the monitor, or gives one."""
        told = self.problems.found[mark:]
        if self.problems.dialect.has("2") or not told:
            return False
        return told[0].rule == MONITOR_COMMAND or line.text[:3].upper() == "MC "

    def _misread(self, line: Line, mark: int) -> Advised | None:
        if self._of_monitor(line, mark):
            return self._meant(line, mark, slip(line.text, self.repair, self.problems.dialect))
        return self._meant(line, mark, meant_by_line(line.text, self.repair, self.problems.dialect))

    def _after_all(self, line: Line, mark: int) -> Advised | None:
        if self._of_monitor(line, mark):
            return None
        return self._meant(
            line, mark, meant_after_all(line.text, self.repair, self.problems.dialect)
        )

    def _meant(self, line: Line, mark: int, found: Meant | None) -> Advised | None:
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
        kept = line.kept
        whole = (found.start, found.end) == (0, len(line.text))
        if (kept is None or whole) and found.instead and found.instead[0] != ";":
            meant = f"{line.text[: found.start]}{found.instead}{line.text[found.end :]}"
            word = self._word_of(meant)
            kept = word if word in STRUCTURE else kept
        return Advised(kept)
