"""Words that are nearly right, told with what they are like."""

import re
from dataclasses import replace

from vrts.lang.problems import short
from vrts.lang.steps.advising.adviser import Advised, Adviser, Line
from vrts.lang.steps.idioms.wording import (
    first_word,
)
from vrts.lang.steps.near_words import acting_at_once, meant_by, short_for, slips
from vrts.lang.steps.unknown_words import (
    AMBIGUOUS_KEYWORD,
    UNKNOWN_INSTRUCTION,
)
from vrts.lang.vocabulary.lookup import look_up

_LETTERS = re.compile(r"[A-Za-z][A-Za-z0]*")


class WordAdvice(Adviser):
    """Explains lines by a slip in one of their words."""

    def first(self, line: Line, mark: int) -> Advised | None:
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

    def qualifier(self, line: Line, mark: int) -> Advised | None:
        """`IF x THNE`: a slip in a word that the instruction wants."""
        told = self.problems.found[mark]
        word = look_up(first_word(line.text), self.problems.dialect).word
        if word is None or not word.qualifiers:
            return None
        for found in _LETTERS.finditer(line.text, len(first_word(line.text))):
            for meant in slips(found.group().upper(), word.qualifiers):
                text = f"{line.text[: found.start()]}{meant}{line.text[found.end() :]}"
                tried = self.repair.at_once(text)
                if tried is None:
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
