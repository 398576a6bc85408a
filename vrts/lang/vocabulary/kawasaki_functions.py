"""Functions of AS that are told apart and never carried out [AS2015] appendix 5.

Each row: name, parameters as `functions.py` writes them, result (`r` number, `s` string, `p` pose,
`j` joints), what it yields, and the columns of the dialects that take it without parentheses.
"""

_Row = tuple[str, str, str, str, str]

_EXISTS: tuple[_Row, ...] = tuple(
    (f"exist{kind}", "s x?" if kind == "data" else "s", "r", f"whether {what} has a value", "")
    for kind, what in (
        ("char", "a string"),
        ("data", "a variable"),
        ("integer", "a whole number"),
        ("joint", "a precision point"),
        ("localchar", "a local string"),
        ("localinteger", "a local whole number"),
        ("localjoint", "a local precision point"),
        ("localreal", "a local number"),
        ("localtrans", "a local location"),
        ("real", "a number"),
        ("trans", "a location"),
    )
)

OF_KAWASAKI: tuple[_Row, ...] = (
    *_EXISTS,
    ("existpgm", "s", "r", "whether there is a program", ""),
    ("ave_trans", "p p", "p", "location halfway between two", ""),
    ("bits32", "r r", "r", "number of 32 bits on consecutive signals", ""),
    ("ccenter", "p p p p", "p", "centre of an arc", ""),
    ("cshift", "p p p p r", "p", "location shifted along an arc", ""),
    ("curlimm", "r", "r", "negative limit of the current of an axis", ""),
    ("curlimp", "r", "r", "positive limit of the current of an axis", ""),
    ("envchkrate", "r", "r", "limit of the deviation of an axis", ""),
    ("$errlog", "r", "s", "words of an error of the past", ""),
    ("$errors", "s", "s", "words of an error by its code", ""),
    ("getenctemp", "r", "r", "temperature of an encoder", ""),
    ("#home", "r?", "j", "joints of a home", ""),
    ("iqarm", "r", "r", "current of a motor", ""),
    ("maxindex", "s r?", "r", "highest index of an array", ""),
    ("minindex", "s r?", "r", "lowest index of an array", ""),
    ("mspeed", "", "r", "the operator's speed", "a"),
    ("mspeed2", "", "r", "the operator's speed of the second robot", "a"),
    ("replace", "s s s", "s", "string with a part replaced", ""),
    ("$replace", "s s s r?", "s", "string with a part replaced", ""),
    ("s_here", "r?", "p", "present place of a robot", "a"),
    ("#s_here", "r?", "j", "present joints of a robot", "a"),
    ("coopstatus", "r", "r", "how a robot works with another", ""),
    ("zoption", "r r", "r", "an option of the controller", ""),
    ("zl3get", "n r?", "r", "a length of a robot", ""),
    ("sig2", "r r*", "r", "whether all signals are as given", ""),
    ("$str_id", "r", "s", "what robot this is", ""),
    ("$str_id2", "r", "s", "what the second robot is", ""),
    ("strtopos", "s", "p", "location that a string names", ""),
    ("strtoval", "s", "r", "number that a string names", ""),
    ("sysdata", "n r? r?", "r", "a number of the controller", ""),
    ("$sysdata", "n r? r?", "s", "a text of the controller", ""),
    ("time_ms", "", "r", "milliseconds of the clock", "a"),
    ("tradd", "p", "p", "location with its seventh axis added", ""),
    ("trqnm", "r", "r", "torque of an axis", ""),
    ("trsub", "p", "p", "location with its seventh axis taken away", ""),
    ("utimer", "r", "r", "seconds of a timer of the user", ""),
    ("whichtask", "s", "r", "task of a program", ""),
    ("zifpeek", "r r r?", "r", "memory of the controller", ""),
    ("zifpeek2", "r r r?", "r", "memory of the controller", ""),
)
