"""Signs of other languages within a step, told and mended."""

import re
from collections.abc import Iterable

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.lang.grammar.shapes import TOO_MANY_OPERANDS
from vrts.lang.steps.advising.adviser import OTHER_LANGUAGE, PRECISE, Advised, Adviser, Line
from vrts.lang.steps.idioms import signs
from vrts.lang.steps.idioms.tables import MOST_CHARACTERS
from vrts.lang.steps.idioms.wording import (
    smallest_change,
)

_USUAL = re.compile(r"(?:^|\.)(?:5|25|75)$")  # fractions that people choose


class SignAdvice(Adviser):
    """Explains lines by signs of other languages."""

    def decimal(self, line: Line, mark: int) -> Advised | None:
        """`IF x > 2,5 THEN`, where the parser would break the step at the comma."""
        return self.explain(line, mark, signs.decimals(line.text), at_once=True)

    def explain(
        self,
        line: Line,
        mark: int,
        ways: Iterable[tuple[signs.Signs, str]] | None = None,
        *,
        at_once: bool = False,
    ) -> Advised | None:
        """Signs of other languages; `at_once`: with nothing else to mend."""
        if len(line.text) > MOST_CHARACTERS:
            return None
        for found, text in signs.replaced(line.text) if ways is None else ways:
            tried = self.repair.steps(text)
            if tried is None or (at_once and tried.fixes):
                continue
            told = self.problems.found[mark]
            self.problems.forget(mark)
            start, end, instead = smallest_change(line.text, tried.text)
            many = told.rule == TOO_MANY_OPERANDS and len(told.help) == 1
            doubtful = many and not found.sure and _USUAL.search(instead) is None
            primary = self.problems.label(line.at + start, line.at + max(end, start))
            precise = (told.rule in PRECISE and not at_once) or not found.says or doubtful
            self.problems.add(
                Diagnostic(
                    told.rule if precise else OTHER_LANGUAGE,
                    Severity.ERROR,
                    told.headline if doubtful else found.says or told.headline,
                    (told.primary or primary) if precise else primary,
                    notes=told.notes,
                    help=(*told.help, f"or else {found.help}") if doubtful else (found.help,),
                    fix=self.problems.replace(
                        line.at + start, line.at + end, instead, sure=found.sure
                    ),
                )
            )
            return Advised(self._word_of(tried.text))
        return None
