"""What was found out about the variants of a task, as findings and as lines for the terminal."""

from collections.abc import Iterator

from vrts.assignments.fair.copied import ENOUGH
from vrts.assignments.fair.fairness import Fairness, FallsOut
from vrts.assignments.fair.remedy import as_toml
from vrts.assignments.fair.uneven import Measure, shown
from vrts.base.diagnostic import Diagnostic, Label, Rule, error, warning
from vrts.check.variants.drawn import variant
from vrts.check.variants.model import Combination, Variants

FALLS_OUT = Rule("V818", "variant-falls-out")
COPIES_PAY = Rule("V819", "copies-pay")
NOT_TRIED = Rule("V828", "variants-not-tried")

SHOWN = 20  # variants that fall out, each with its values
FEW = 3  # where every variant does
NAMED = 3  # students of one of them


def fair_findings(variants: Variants, found: Fairness) -> tuple[Diagnostic, ...]:
    """Return an error for each variant that falls out, and a warning where copies pay."""
    none = len(found.out) == len(found.trials)
    shown, remedy = (FEW, _FOLLOW) if none else (SHOWN, _PASTE)
    told = [_falls_out(variants, one, remedy) for one in found.out[:shown]]
    more = len(found.out) - shown
    if more > 0:
        headline = f"{more} more variants fall out in the same check"
        if none:
            headline = f"all {more} other variants that were tried fall out, too"
        told.append(error(FALLS_OUT, headline, Label(variants.span), help=(_AGAIN,)))
    if found.covering.given_up:
        told.append(_not_tried(variants, found))
    if found.copied is not None and not found.copied.shown:
        told.append(_pays(variants, found))
    return tuple(told)


_AGAIN = "mend or exclude those that are named, and check again"
_FOLLOW = "let the scene's `[locations]` follow what varies, and the reference use them"
_PASTE = "exclude it: tables to paste into `task.toml` stand in the report below"


def _falls_out(variants: Variants, one: FallsOut, remedy: str) -> Diagnostic:
    tag = variant(variants, one.combination).tag
    names = ", ".join(f"`{name}`" for name in one.students[:NAMED])
    more = len(one.students) - NAMED
    whose = f", which {names}{f' and {more} more' if more > 0 else ''} would get," if names else ""
    values = ", ".join(f"{k} = {v}" for k, v in variants.values(one.combination).items())
    return error(
        FALLS_OUT,
        f"the variant `{tag}`{whose} falls out: {one.why[0]}",
        Label(variants.span),
        notes=(*one.why[1:], f"its values: {values}"),
        help=(remedy,),
    )


def _not_tried(variants: Variants, found: Fairness) -> Diagnostic:
    count = found.covering.given_up
    what = "value or pair of values is" if count == 1 else "values and pairs of values are"
    headline = f"{count:,} {what} in no variant that was tried"
    note = "students may get them: looking for such a variant took too long"
    remedy = "let less vary, or make `[[variants.without]]` fewer and simpler"
    return error(NOT_TRIED, headline, Label(variants.span), notes=(note,), help=(remedy,))


def _pays(variants: Variants, found: Fairness) -> Diagnostic:
    assert found.copied is not None
    pairs, paid, of = found.copied
    headline = f"copied values earn more than half in {paid} of {pairs} pairs of students"
    share = f"{float(100 * (1 - ENOUGH)):g} %"
    most = f"at most {share} should: variants are too much alike"
    if not found.copied.pays:
        most = f"that at most {share} of all {of:,} pairs do is not shown by so few"
    remedies = (
        "let more places vary, and by more than the goals and the hand forgive",
        "put into `staff_names` what students are to find by themselves",
    )
    return warning(COPIES_PAY, headline, Label(variants.span), notes=(most,), help=remedies)


def fair_lines(variants: Variants, found: Fairness) -> Iterator[str]:
    """Yield what was tried and found, line by line."""
    cover = found.covering
    yield f"variants: {len(found.trials)} of {variants.total:,} combinations were tried"
    ends = " (of wide ranges: the ends and some between)" if cover.thinned else ""
    yield (
        f"  {len(cover.combinations)} cover all {cover.values} values and {cover.pairs:,} pairs of "
        f"values{ends}"
    )
    if cover.never:
        excluded = "value or pair is" if cover.never == 1 else "values and pairs are"
        yield f"  {cover.never} {excluded} excluded by `[[variants.without]]`"
    if cover.given_up:
        yield f"  {cover.given_up} values and pairs could not be tried"
    if found.students:
        have = "1 student of the list has" if found.students == 1 else "students of the list have"
        many = have if found.students == 1 else f"{found.students} {have}"
        ones = "one of them" if found.of_students == 1 else f"{found.of_students} different ones"
        yield f"  {many} {ones}"
    fit = len(found.trials) - len(found.out)
    fall = "1 falls out" if len(found.out) == 1 else f"{len(found.out)} fall out"
    yield f"  {fit} can be done and are equally hard; {fall}"
    yield ""
    yield "difficulty    median   least    most   allowed"
    for measure in shown(found.measures):
        yield _measure(measure)
        for what, (value, combination) in (("least", measure.least), ("most", measure.most)):
            if measure.outside:
                yield f"    {what} {value:.1f} {measure.unit}: {_named(variants, combination)}"
    if found.copied is not None:
        pairs, paid, of = found.copied
        yield ""
        yield f"copied: {paid} of {pairs} pairs earn more than half with the values of another"
        if pairs < of:
            whose = "of the list" if found.students else "of made-up students"
            yield f"  {pairs} of the {of:,} pairs {whose} were tried"
    if found.excluded:
        yield ""
        yield "to exclude what falls out, paste this at the end of task.toml:"
        for table in as_toml(variants, found.excluded):
            yield ""
            yield from table.split("\n")
    if found.unexplained and found.excluded:
        yield ""
        yield f"these leave {found.unexplained} that fall out, too: check again afterwards"


def _measure(measure: Measure) -> str:
    low, high = measure.allowed
    name = f"{measure.title} [{measure.unit}]"
    of = f", {measure.of}" if measure.outside and measure.of else ""
    return (
        f"  {name:<14}{measure.median:6.1f}  {measure.least[0]:6.1f}  {measure.most[0]:6.1f}"
        f"   {low:.1f} to {high:.1f} ({measure.bound}{of})"
    )


def _named(variants: Variants, combination: Combination) -> str:
    values = ", ".join(f"{k} = {v}" for k, v in variants.values(combination).items())
    return f"`{variant(variants, combination).tag}`: {values}"
