"""`$OUT[1] = TRUE` of KRL, `DO[1] = ON` of FANUC: an output as an element of an array."""

from vrts.base.diagnostic import Rule, Severity
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Element, Number
from vrts.lang.syntax.statements import Assignment

_OUTPUTS = frozenset({"$OUT", "$OUTPUT", "$DOUT", "$DO"})
_LEGAL = frozenset({"DO", "RO", "DOUT", "SDO"})  # as VAL-II has it, an array of numbers
_WORDS = frozenset({"ON", "OFF"})  # what hardly any number is given
_LIKELY = frozenset({"OUT", "OUTPUT", "Y"})  # outputs where they are given such a word
_ON, _OFF = frozenset({"TRUE", "ON", "1", "HIGH"}), frozenset({"FALSE", "OFF", "0", "LOW"})


def switched_output(problems: Problems, rule: Rule, node: Assignment) -> bool:
    """Report an output that is switched as in KRL; return whether this is one."""
    target = node.target
    if not isinstance(target, Element):
        return False
    name = target.name.text.upper()
    text = problems.source.text
    value = text[node.value.start : node.value.end].upper()
    legal = name in _LEGAL or (name in _LIKELY and value in _WORDS)
    if (name not in _OUTPUTS and not legal) or (legal and problems.dialect.tolerant):
        return False
    index = target.subscripts[0] if len(target.subscripts) == 1 else None
    if index is None or value not in _ON | _OFF:
        return False
    number = text[index.start : index.end]
    if not isinstance(index, Number):
        number = f"({number})"
    instead = f"SIGNAL {'' if value in _ON else '-'}{number}"
    problems.error(
        rule,
        f"`{text[target.start : target.end]} = {value}` is {'FANUC' if legal else 'KRL'}, not "
        f"{problems.dialect.title}",
        node.start,
        node.end,
        notes=(
            "SIGNAL switches an output on, and off with a minus before its number",
            *(("as it stands, this gives a number to an array",) if legal else ()),
        ),
        help=(f"write `{instead}`",),
        fix=problems.replace(node.start, node.end, instead, sure=not legal),
        severity=Severity.WARNING if legal else Severity.ERROR,
    )
    return True
