"""`NO FLIP`, `DE PART 50`, `n > = 3`: a word or a sign of the language with a blank in it."""

import re

from vrts.lang.dialect import Dialect
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.unknown_words import UNKNOWN_INSTRUCTION
from vrts.lang.vocabulary.lookup import spellings

_PARTED = re.compile(r"(?P<first>[A-Za-z]+)[ \t_-]+(?P<second>[A-Za-z]+)(?P<rest>(?![\w.\[(]).*)")
_PARTED_SIGN = re.compile(r"(?P<first>[<>=])[ \t]+(?P<second>[=>])")
_STRING = re.compile(r'"[^"]*"?')
_OTHERWISE = frozenset({"GOTO"})  # told by itself


def parted_word(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a step whose first two words are one."""
    found = _PARTED.fullmatch(text)
    if found is None:
        return None
    word = (found["first"] + found["second"]).upper()
    if word not in spellings(dialect) or word in _OTHERWISE:
        return None
    meant = f"{word}{found['rest']}"
    if repair.at_once(meant) is None:
        return None
    return Meant(
        UNKNOWN_INSTRUCTION,
        f"{word} is one word",
        0,
        found.end("second"),
        (f"write `{meant}`",),
        word,
        sure=True,
        notes=("VAL-II says *Unknown instruction*",),
    )


def parted_sign(text: str, repair: Repair) -> Meant | None:
    """Return what is meant by a step that is right without the blank in a comparison's sign."""
    bare = _STRING.sub(lambda string: '"' * len(string.group()), text)
    found = _PARTED_SIGN.search(bare)
    if found is None:
        return None
    sign = found["first"] + found["second"]
    sign = ">=" if sign == "=>" else sign
    meant = f"{text[: found.start()]}{sign}{text[found.end() :]}"
    if repair.at_once(meant) is None:
        return None
    return Meant(
        INVALID_EXPRESSION,
        f"`{sign}` is one sign, without a blank in it",
        found.start(),
        found.end(),
        (f"write `{sign}`: `{meant}`",),
        sign,
        sure=True,
        notes=("VAL-II says *Illegal expression syntax*",),
    )
