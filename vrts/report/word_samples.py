"""Steps of a program that use one word of the language, to find out what becomes of it."""

from vrts.base.source import SourceFile
from vrts.ir.module import Module
from vrts.ir.values import Type
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import AS, VAL, VAL2, VPLUS, Dialect
from vrts.lang.vocabulary.functions import Signature
from vrts.lang.vocabulary.word import Word

NATIVE = {"2": VAL2, "+": VPLUS, "a": AS, "1": VAL}  # by column of the vocabulary
_CASE = "CASE n OF\nVALUE 1:\nEND"
_STRING_CASE = 'SCASE $s OF\nSVALUE "a":\nEND'
_LOOP = "FOR i = 1 TO n STEP 2\nEND"
COMPANY = {  # words whose usage needs other steps around it
    "IF": "IF n THEN\nEND",
    "ELSE": "IF n THEN\nELSE\nEND",
    "END": "IF n THEN\nEND",
    "WHILE": "WHILE n DO\nEND",
    "DO": "DO\nUNTIL n",
    "UNTIL": "DO\nUNTIL n",
    "FOR": _LOOP,
    "CASE": _CASE,
    "VALUE": _CASE,
    "ANY": "CASE n OF\nANY\nEND",
    "SCASE": _STRING_CASE,
    "SVALUE": _STRING_CASE,
    "GOTO": "GOTO 10\n10 READY",
    "GRASP": "GRASP 10, 10\n10 READY",
    "IFSIG": "IFSIG 1 THEN 10\n10 READY",
    "EXIT": "DO\nEXIT 1\nUNTIL n",
    "NEXT": "DO\nNEXT 1\nUNTIL n",
}
_EASIER = {
    "JMOVE": "JMOVE 1, 2, 3, 4, 5, 6",
    "ATTACH": "ATTACH (0)",
    "DETACH": "DETACH (0)",
    "WRITE": 'WRITE (4) "text"',
    "ON": "ON 1001 CALL program, 5",  # in the form, `priority` is read as a function
    "ONI": "ONI 1001 CALL program, 5",
}
_QUALIFIERS = {
    "ALWAYS": "SPEED 50 ALWAYS",
    "BY": "SET q = SHIFT(NULL BY 1,2,3)",
    "IPS": "SPEED 10 IPS",
    "MMPS": "SPEED 100 MMPS",
    "MONITOR": "SPEED 50 MONITOR",
    "OF": _CASE,
    "STEP": _LOOP,
    "THEN": "IF n THEN\nEND",
    "TO": _LOOP,
    **{kind: f"AUTO {kind} b" for kind in ("DOUBLE", "LOC", "REAL")},
    **{word: f"IF n {word} 1 THEN 10\n10 READY" for word in ("EQ", "NE", "LT", "GT", "LE", "GE")},
}
_ARGUMENTS = {"r": "1", "s": '"a"', "p": "p", "l": "p", "v": "v[1]", "$": "$s", "f": "1"}
_TARGETS = {
    Type.REAL: "x = ",
    Type.STRING: "$x = ",
    Type.POSE: "q = ",
    Type.JOINTS: "#q = ",
}


def native(dialects: str) -> Dialect:
    """Return the dialect in which a word is at home."""
    return next(dialect for letter, dialect in NATIVE.items() if letter in dialects)


def home(steps: str, dialects: str) -> Dialect:
    """Return the first dialect with a word that takes some steps: VAL-II has MC, and refuses it."""
    homes = [dialect for letter, dialect in NATIVE.items() if letter in dialects]
    return next((dialect for dialect in homes if compiled(steps, dialect) is not None), homes[0])


def instruction_sample(word: Word) -> str:
    """Return steps that use an instruction."""
    easier = _EASIER.get(word.text, word.usage.replace(", ...", ""))
    return COMPANY.get(word.text) or easier


def qualifier_sample(word: Word) -> str:
    """Return steps that use a qualifier."""
    return _QUALIFIERS[word.text]


def operator_sample(word: Word) -> str:
    """Return a step that uses an operator."""
    return "x = " + word.usage.replace("a ", "1 ", 1).replace(" a", " 1").replace(" b", " 2")


def function_sample(signature: Signature) -> str:
    """Return a step that uses a function."""
    arguments = [_ARGUMENTS.get(code[0], "CP") for code in signature.parameters]
    if signature.name == "parameter":
        arguments[0] = "HAND.TIME"
    if signature.name == "$unpack":
        arguments[0] = "$v[1]"
    if signature.name == "instr":
        arguments = ["1", '"abc"', '"b"']
    inner = ",".join(arguments)
    if signature.by is not None:
        inner = f"{arguments[0]} BY {','.join(arguments[1:])}"
    call = f"({inner})" if signature.parameters else ""
    target = _TARGETS[signature.result]
    if signature.result in (Type.POSE, Type.JOINTS):
        target = f"{'POINT' if signature.dialects == 'a' else 'SET'} {target}"
    return f"{target}{signature.name.upper()}{call}"


def switch_sample(name: str, dialects: str = "2") -> str:
    """Return a step that uses a system switch; AS has no ENABLE."""
    return f"x = SWITCH({name})" if dialects == "a" else f"ENABLE {name}"


def parameter_sample(name: str) -> str:
    """Return a step that uses a parameter of the controller."""
    return f"PARAMETER {name}{'[1]' if name == 'NEST.POS' else ''} = 1"


def compiled(steps: str, dialect: Dialect) -> Module | None:
    """Return the module of a program with some steps."""
    text = f".PROGRAM main(v[], $v[])\n{steps}\n.END\n"
    return compile_source(SourceFile("sample", text), Options(dialect)).module
