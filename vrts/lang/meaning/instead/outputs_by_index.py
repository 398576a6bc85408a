"""`$OUT[1] = TRUE` of KRL: an output written as an element of an array of strings."""

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Element, Number
from vrts.lang.syntax.statements import Assignment

_OUTPUTS = frozenset({"$OUT", "$OUTPUT", "$DOUT", "$DO"})
_ON, _OFF = frozenset({"TRUE", "ON", "1", "HIGH"}), frozenset({"FALSE", "OFF", "0", "LOW"})


def switched_output(problems: Problems, rule: Rule, node: Assignment) -> bool:
    """Report an output that is switched as in KRL; return whether this is one."""
    target = node.target
    if not isinstance(target, Element) or target.name.text.upper() not in _OUTPUTS:
        return False
    text = problems.source.text
    value = text[node.value.start : node.value.end].upper()
    index = target.subscripts[0] if len(target.subscripts) == 1 else None
    if index is None or value not in _ON | _OFF:
        return False
    number = text[index.start : index.end]
    if not isinstance(index, Number):
        number = f"({number})"
    instead = f"SIGNAL {'' if value in _ON else '-'}{number}"
    problems.error(
        rule,
        f"`{text[target.start : target.end]} = {value}` is KRL, not {problems.dialect.title}",
        node.start,
        node.end,
        notes=("SIGNAL switches an output on, and off with a minus before its number",),
        help=(f"write `{instead}`",),
        fix=problems.replace(node.start, node.end, instead),
    )
    return True
