"""`WAIT $IN[3] == TRUE` of KRL: an input as an element of an array of strings."""

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.steps.misread.foreign.inputs import NAMES, input_at
from vrts.lang.syntax.expressions import Element, Item

_SIGN = "$"


def asked_as_string(problems: Problems, rule: Rule, node: Item) -> bool:
    """Report an input that is asked for as in KRL; return whether this is one."""
    if not isinstance(node, Element) or node.name.text[0] != _SIGN:
        return False
    if node.name.text.lower() not in NAMES:
        return False
    found = input_at(problems.source.text, node.start)
    if found is None:
        return False
    problems.error(
        rule,
        f"`{problems.source.text[node.start : node.end]}` is KRL, not {problems.dialect.title}",
        found.start,
        found.end,
        notes=("input 1 is signal 1001",),
        help=(f"an input is asked for by SIG: write `{found.instead}`",),
        fix=problems.replace(found.start, found.end, found.instead),
    )
    return True
