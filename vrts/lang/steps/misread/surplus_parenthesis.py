"""`TRANS(20*(i+1)),0,0)`: one `)` too many, which need not be the last."""

import re

from vrts.lang.reading.nesting import MISSING_PARENTHESIS
from vrts.lang.steps.misread.meant import VARIABLE, Meant
from vrts.lang.steps.repair import Repair

_GIVEN = re.compile(rf"(?:SET[ \t]+)?{VARIABLE}[ \t]*=(?!=)", re.ASCII | re.IGNORECASE)
_MOST = 12  # parentheses of a line that are tried


def surplus_parenthesis(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a line in which one `)` closes nothing."""
    closing, surplus = _closing(text)
    if surplus is None or len(closing) > _MOST:
        return None
    found = {text[:at] + text[at + 1 :]: at for at in closing}
    own = text[:surplus] + text[surplus + 1 :]
    behind = text[surplus + 1 :].strip()
    steps = [own] if _is_step(own, repair) else [t for t in found if _is_step(t, repair)]
    if len(steps) != 1:
        return None
    (meant,) = steps
    if meant == own and behind and text[surplus - 1] != ")":
        return None  # `a+b)*2` lacks a `(` more likely
    at = found[meant]
    return Meant(
        MISSING_PARENTHESIS,
        "one `)` is too many",
        at,
        at + 1,
        (f"take this `)` out: write `{meant.strip()}`",),
        "",
        sure=True,
        notes=("VAL-II says *Missing parenthesis*",),
    )


def _is_step(text: str, repair: Repair) -> bool:
    tried = repair.at_once(text)
    if tried is None:
        return False
    return _GIVEN.match(text) is None or not _has_comma(text)


def _has_comma(text: str) -> bool:
    """Whether a comma stands outside of quotes and parentheses: one value has none."""
    depth, quoted = 0, False
    for sign in text:
        quoted ^= sign == '"'
        if not quoted:
            depth += (sign in "([") - (sign in ")]")
            if sign == "," and depth == 0:
                return True
    return False


def _closing(text: str) -> tuple[list[int], int | None]:
    """Return where every `)` stands, and the one that closes nothing, if it is the only one."""
    closing: list[int] = []
    surplus: int | None = None
    depth, quoted = 0, False
    for at, sign in enumerate(text):
        quoted ^= sign == '"'
        if quoted or sign not in "()":
            continue
        if sign == "(":
            depth += 1
            continue
        closing.append(at)
        if depth:
            depth -= 1
        elif surplus is None:
            surplus = at
        else:
            return closing, None
    return closing, surplus if depth == 0 else None
