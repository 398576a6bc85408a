"""Says what is wrong with a step that does not parse, in the terms of who wrote it.

The tables know which tokens could have come next; what a writer most likely meant depends on the
instruction. The first explanation that fits wins.
"""

from vrts.lang.grammar.lalr import Failure, expected
from vrts.lang.problems import Problems, short
from vrts.lang.steps import missing_parts, other_forms, surplus
from vrts.lang.steps.broken_step import BrokenStep
from vrts.lang.steps.misread import bare_functions
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.word import Word


def explain(problems: Problems, tokens: list[Token], failure: Failure, word: Word | None) -> None:
    """Report one diagnostic for a step that does not parse."""
    step = BrokenStep(problems, tokens, failure, expected(failure.states), word)
    for explanation in (
        other_forms.beginning,
        other_forms.compound_set,
        surplus.empty_parentheses,
        bare_functions.function_without_parentheses,
        other_forms.equals_for_compare,
        missing_parts.label,
        missing_parts.keyword,
        surplus.text_after_structure,
        other_forms.list_in_parentheses,
        missing_parts.comma,
        other_forms.format_misplaced,
        missing_parts.operand,
        surplus.too_many,
    ):
        if explanation(step):
            return
    _anything_else(step)


def _anything_else(step: BrokenStep) -> None:
    here, before = step.here, step.before
    fix = None
    assigned = any(token.kind == "EQUAL" for token in step.tokens[step.failure.at :])
    if here is not None and before is not None and assigned and here.kind in ("NAME", "NUMBER"):
        one = f"{before.text}{here.text}" if here.kind == "NUMBER" else f"{before.text}.{here.text}"
        step.problems.error(
            INVALID_EXPRESSION,
            "a name is one word",
            before.start,
            here.end,
            notes=("VAL-II says *Illegal expression syntax*",),
            help=(f"write `{one}`, here and wherever it stands",),
            fix=step.problems.replace(before.start, here.end, one, sure=False),
        )
        return
    if here is not None and "EQUAL" in step.wanted:
        headline = f"`=` is missing before `{short(here.text)}`"
        where = (here.start, here.end)
        fix = step.problems.replace(here.start, here.start, "= ")
        if here.kind == "COMMA":
            headline = "`=` belongs here, and no comma"
            fix = step.problems.replace(here.start, here.end, " =")
    elif here is not None:
        headline = f"`{short(here.text)}` does not belong here"
        where = (here.start, here.end)
    else:
        last = before or step.tokens[0]
        headline = f"the step breaks off after `{short(last.text)}`"
        where = (last.end, last.end)
    step.problems.error(
        INVALID_EXPRESSION,
        headline,
        *where,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f"write `{step.word.usage}`",) if step.word else (),
        fix=fix,
    )
