"""`part count = 0`, `n! = 5`, `_n = 1`: a variable whose name is none."""

import re

from vrts.lang.reading.odd_signs import INVALID_NAME
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.repair import Repair
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

_GIVEN = re.compile(
    r"(?P<name>[$#]?[^\s=()\[\]\",;:+*/<>#$][^=()\[\]\",;:+*/<>#$]*?)(?P<rest>[ \t]*=(?!=).+)"
)
_NAME = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_WORDS = re.compile(r"[A-Za-z][\w.]*(?:(?:[ \t]+|-)[A-Za-z][\w.]*){1,2}", re.ASCII)
_FOREIGN = re.compile(r"[^\w.$#]+|^_+")
_NOTES = ("VAL-II says *Illegal expression syntax*",)


def odd_name(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by an assignment to a name with a sign or a blank in it."""
    found = _GIVEN.fullmatch(text)
    if found is None or _NAME.fullmatch(found["name"]):
        return None
    name, rest = found["name"], found["rest"]
    if _WORDS.fullmatch(name):
        if not {word.upper() for word in re.split(r"[ \t-]+", name)}.isdisjoint(INSTRUCTIONS):
            return None
        one, says = re.sub(r"[ \t]+|-", "_", name), "a name is one word"
    elif re.search(r"\s", name):
        return None
    else:
        one, says = _FOREIGN.sub("", name), "a name is made of letters, digits and points"
    if not _NAME.fullmatch(one) or one.upper() in INSTRUCTIONS:
        return None
    other = re.sub(rf"(?<![\w.$#]){re.escape(name)}(?![\w.])", one, rest)
    meant = one + other
    if repair.at_once(meant) is None:
        return None
    return Meant(
        INVALID_NAME,
        says,
        0,
        len(text),
        (f"write `{one}`, here and wherever it stands",),
        meant,
        notes=_NOTES,
    )
