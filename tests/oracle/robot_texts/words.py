"""Instructions as the manuals list them: how many operands each takes, of which kind.

AS: Kawasaki, AS Language Reference Manual, 90209-1022DEC, chapters 6 and 10. V+: Adept, V+ Language
User's Guide 12.1 and V+ Language Reference Guide. `r` is a number, `l` a location, `n` the name of
a location or a compound of names; a small `?` makes it optional, `*` takes one or more.
"""

BOTH = {
    **dict.fromkeys(("OPEN", "OPENI", "CLOSE", "CLOSEI", "RELAX", "RELAXI"), "r?"),
    **dict.fromkeys(("BREAK", "BRAKE", "RESET", "ALIGN", "LEFTY", "RIGHTY", "ABOVE", "BELOW"), ""),
    **dict.fromkeys(("RETURNE", "HALT", "STOP", "PAUSE"), ""),
    "DELAY": "r",
    "DRIVE": "rrr?",
    "SIGNAL": "r*",
    "IGNORE": "r",
    "LOCK": "r",
}
AS = BOTH | {
    **dict.fromkeys(("JMOVE", "LMOVE"), "lr?"),
    **dict.fromkeys(("JAPPRO", "LAPPRO"), "lr"),
    **dict.fromkeys(("JDEPART", "LDEPART"), "r"),
    **dict.fromkeys(("DRAW", "TDRAW"), "r?r?r?r?r?r?r?"),
    **dict.fromkeys(("UWRIST", "DWRIST", "RETURN"), ""),
    "TOOL": "n",
    "BASE": "n",
    "WAIT": "r",
    "TWAIT": "r",
    "SWAIT": "r*",
    "PULSE": "rr",
    "DLYSIG": "rr",
    "STABLE": "r",
    "PCEND": "r?",
    "PCABORT": "r?",
}
VPLUS = BOTH | {
    **dict.fromkeys(("MOVE", "MOVES"), "l"),
    **dict.fromkeys(("APPRO", "APPROS", "MOVET", "MOVEST"), "lr"),
    **dict.fromkeys(("DEPART", "DEPARTS"), "r"),
    **dict.fromkeys(("FLIP", "NOFLIP", "READY", "NEST"), ""),
    "TOOL": "l?",
    "BASE": "r?r?r?r?",
    "WAIT": "r?",
    "RETURN": "r?",
    "EXIT": "r?",
    "NEXT": "r?",
    "WAIT.EVENT": "r?r?",
    "ATTACH": "r",
    "DETACH": "r",
}
WORDS = {"as": AS, "vplus": VPLUS}
SETTINGS = {"as": {}, "vplus": dict.fromkeys(("COARSE", "FINE", "NULL", "NONULL"))}
SINGLES = {"SINGLE", "MULTIPLE"}
# tightest last; AS: 3.8.2 of its manual; V+: User's Guide, "Order of Evaluation"
ORDER = {
    "as": (
        *(("XOR",), ("OR",), ("AND",), ("BXOR",), ("BOR",), ("BAND",)),
        *(("<", ">", "<=", ">=", "=<", "=>", "==", "<>"), ("+", "-"), ("MOD",), ("*", "/")),
    ),
    "vplus": (
        ("<", ">", "<=", ">=", "=<", "=>", "==", "<>"),
        ("+", "-", "OR", "BOR", "XOR", "BXOR"),
        ("*", "/", "MOD", "AND", "BAND"),
        ("**",),  # not in the guide; programs that controllers ran have it
    ),
}
BEFORE = ("-", "NOT", "COM", "+")
REALS = {  # functions that give a number, and with how many arguments at least and at most
    **dict.fromkeys(("ABS", "SIN", "COS", "SQRT", "INT", "ASC", "LEN", "VAL"), (1, 2)),
    **dict.fromkeys(("DX", "DY", "DZ", "TIMER"), (1, 1)),
    "ATAN2": (2, 2),
    "DISTANCE": (2, 2),
    "SIG": (1, 9),
    "BITS": (1, 2),
    "INRANGE": (1, 2),
    "SPEED": (1, 1),
    "SWITCH": (1, 2),
    "PRIORITY": (0, 0),
    "RANDOM": (0, 0),
    "FREE": (1, 1),
    "TIME": (0, 1),
    "ERROR": (1, 2),
    "TASK": (1, 1),
}
OF = {
    "as": REALS | {"MAXVAL": (1, 9), "MINVAL": (1, 9), "INSTR": (2, 3), "ROUND": (1, 1)},
    "vplus": REALS
    | dict.fromkeys(("MAX", "MIN"), (1, 9))
    | dict.fromkeys(("SQR", "TAN", "FRACT", "SIGN", "BCD", "DCB"), (1, 1))
    | {"POS": (2, 3), "OUTSIDE": (3, 3), "DEFINED": (1, 1), "STATE": (1, 1), "LAST": (1, 1)}
    | {"PARAMETER": (1, 1), "STATUS": (1, 1), "PENDANT": (1, 1), "TAS": (2, 2), "HAND": (0, 0)}
    | {"IDENTICAL": (2, 2), "STRDIF": (2, 2)},
}
LOCATIONS = {
    "TRANS": (1, 6),
    "SHIFT": (2, 4),
    "FRAME": (4, 4),
    "NULL": (0, 0),
    "HERE": (0, 0),
    "DEST": (0, 0),
    "BASE": (0, 0),
    "TOOL": (0, 0),
    "#PPOINT": (1, 6),
    "#DEST": (0, 0),
    "#HERE": (0, 0),
    "RX": (1, 1),
    "RY": (1, 1),
    "RZ": (1, 1),
    "INVERSE": (1, 1),
    "SCALE": (2, 2),
    "NORMAL": (1, 1),
}
NOT_IN = {"as": {"INVERSE", "SCALE", "NORMAL", "#HERE"}, "vplus": set[str]()}
STRINGS: frozenset[str] = frozenset(
    {
        "$CHR",
        "$MID",
        "$ENCODE",
        "$ERROR",
        "$DECODE",
        "$TIME",
        "$SPACE",
        "$RIGHT",
        "$LEFT",
        "$TRUNCATE",
        "$UNPACK",
        "$DATE",
        "$STR",
    }
)
CONSTANTS = {"TRUE": -1.0, "FALSE": 0.0, "ON": -1.0, "OFF": 0.0, "PI": 3.14159265358979}
