"""Words of VAL-II that AS has by another name, for code that messages show."""

import re

NAMES_IN_AS = {
    "MOVE": "JMOVE",
    "MOVES": "LMOVE",
    "APPRO": "JAPPRO",
    "APPROS": "LAPPRO",
    "DEPART": "JDEPART",
    "DEPARTS": "LDEPART",
    "FLIP": "DWRIST",
    "NOFLIP": "UWRIST",
    "READY": "HOME",
    "SET": "POINT",
    "TYPE": "PRINT",
    "DELAY": "TWAIT",
    "REACTE": "ONE",
    "CALLS": "SCALL",
    "MMPS": "MM/S",
}
_CODE = re.compile(r"`[^`]*`")
_WORD = re.compile(r"[A-Za-z][\w.]*")


def step_in_as(text: str) -> str:
    """Return a step, or several lines of them, with the words of AS."""
    return _WORD.sub(lambda found: NAMES_IN_AS.get(found.group(), found.group()), text)


def help_in_as(text: str, written: str) -> str:
    """Return a sentence with the words of AS in its code, but those that the user wrote."""
    own = {word.upper() for word in _WORD.findall(written)}

    def renamed(found: re.Match[str]) -> str:
        return found.group() if found.group() in own else step_in_as(found.group())

    return _CODE.sub(lambda code: _WORD.sub(renamed, code.group()), text)
