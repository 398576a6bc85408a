"""`count =+ 1`: a sign of its number, where `count = count+1` is meant."""

import re

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name, Number, Prefix
from vrts.lang.syntax.statements import Assignment

SIGN_BEHIND_EQUALS = Rule("V273", "sign-behind-equals")

_GLUED = re.compile(r"=(?P<sign>[-+])[ \t]+")


def check_sign(problems: Problems, node: Assignment) -> None:
    """Warn of `=+` and `=-` with a blank behind them."""
    value, target = node.value, node.target
    if not isinstance(value, Prefix) or not isinstance(target, Name):
        return
    text = problems.source.text
    found = _GLUED.match(text, value.start - 1)
    if found is None or not isinstance(value.operand, Number | Name):
        return
    by = text[value.operand.start : value.operand.end]
    meant = f"{target.text} = {target.text}{found['sign']}{by}"
    problems.warning(
        SIGN_BEHIND_EQUALS,
        f"`={found['sign']}` changes nothing by {by}: this gives `{target.text}` the value "
        f"{found['sign'].lstrip('+')}{by}",
        node.start,
        node.end,
        f"`{found['sign']}` is the sign of the number",
        help=(f"write `{meant}`",),
        fix=problems.replace(node.start, node.end, meant),
    )
