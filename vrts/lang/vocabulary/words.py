"""Qualifiers inside a step, and operators that are words."""

from vrts.lang.vocabulary.word import Place, Word


def _q(text: str, dialects: str, terminal: str, about: str) -> Word:
    return Word(text, Place.QUALIFIER, dialects, terminal, text, about)


def _o(text: str, terminal: str, about: str) -> Word:
    usage = f"{text} a" if terminal == "PREFIX" else f"a {text} b"
    return Word(text, Place.OPERATOR, "2+a", terminal, usage, about)


_QUALIFIERS = (
    _q("ALWAYS", "12+a", "ALWAYS", "the setting holds for all motions from now on"),
    _q("BY", "12+a", "BY", "before the offsets of SHIFT and SCALE"),
    _q("IPS", "2+", "UNIT", "inches a second"),
    _q("MMPS", "2+", "UNIT", "millimetres a second"),
    _q("MONITOR", "+", "UNIT", "the operator's speed"),
    _q("OF", "2+a", "OF", "ends the line of CASE"),
    _q("STEP", "2+a", "STEP", "before the increment of FOR"),
    _q("THEN", "12+a", "THEN", "ends the line of IF"),
    _q("TO", "2+a", "TO", "before the last value of FOR"),
)

_OF_ONE = (  # keywords at one place of one instruction, told apart there
    _q("DOUBLE", "+", "KIND", "before variables of double precision that are declared"),
    _q("LOC", "+", "KIND", "before locations that are declared"),
    _q("REAL", "+", "KIND", "before numbers that are declared"),
    _q("EQ", "1", "RELATION", "== in IF of VAL"),
    _q("NE", "1", "RELATION", "<> in IF of VAL"),
    _q("LT", "1", "RELATION", "< in IF of VAL"),
    _q("GT", "1", "RELATION", "> in IF of VAL"),
    _q("LE", "1", "RELATION", "<= in IF of VAL"),
    _q("GE", "1", "RELATION", ">= in IF of VAL"),
)

_OPERATORS = (
    _o("AND", "INFIX", "both are true"),
    _o("BAND", "INFIX", "bits that are set in both"),
    _o("BOR", "INFIX", "bits that are set in one or both"),
    _o("BXOR", "INFIX", "bits that are set in one of them"),
    _o("COM", "PREFIX", "all bits turned over"),
    _o("MOD", "INFIX", "remainder of a division"),
    _o("NOT", "PREFIX", "true when the operand is false"),
    _o("OR", "INFIX", "one or both are true"),
    _o("XOR", "INFIX", "one of them is true"),
)

QUALIFIERS_OF_ONE = {word.text: word for word in _OF_ONE}
QUALIFIERS = {word.text: word for word in _QUALIFIERS}
OPERATORS = {word.text: word for word in _OPERATORS}
