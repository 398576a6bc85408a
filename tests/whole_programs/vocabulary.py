"""What programs are drawn from: statements and expressions with holes.

A hole is a letter in braces: r a real expression, n a real variable, c a condition, l a location,
L a location variable, j a precision point, J its variable, w where a motion may go, s a string, S a
string variable, k a label, o an output with its sign, i a signal to watch, p a program without
arguments, d a small distance, t a short time. Dialects stand in brackets before what only they
have.
"""

import re
from functools import cache

from vrts.lang.dialect import DIALECTS
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

# a bar between two of them; what takes several lines has semicolons
STATEMENTS = """
MOVE {w} | MOVES {w} | MOVET {w}, {d} | MOVEST {l}, 0 | APPRO {w}, {d} | APPROS {l}, {d} |
DEPART {d} |
DEPARTS {d} | DRIVE {r6}, {d}, 50 | DRIVE 1, {d} | DRAW {d}, {d} | DRAW ,,{d} | ALIGN | READY |
NEST |
REST | DELAY {t} | BREAK | BRAKE | SPEED 30 | SPEED {r} | SPEED 70 ALWAYS | SPEED 200 MMPS ALWAYS |
SPEED 5 IPS | [+] SPEED 100, 40 | [+] SPEED 60 MONITOR | COARSE | COARSE ALWAYS | FINE |
NONULL ALWAYS | NULL |
INTON | INTOFF ALWAYS | SINGLE ALWAYS | MULTIPLE ALWAYS | RIGHTY | LEFTY | ABOVE | BELOW | FLIP |
NOFLIP | UWRIST | DWRIST | ACCEL 50, 70 | ACCEL 150 ALWAYS | DECEL 60 | DURATION 0.6 |
DURATION 0 ALWAYS | ACCURACY 2 ALWAYS | STABLE 0.2 | TOOL {l} | TOOL | [12] BASE 10, 0, {d}, 5 |
BASE |
[only a] BASE p1 | OPEN | CLOSE | RELAX | OPENI | CLOSEI | RELAXI | OPENI 30 | GRASP 1, {k} |
GRASP {d} |
SET {L} = {l} | SET {J} = {j} | SET {L} = HERE | POINT {L} = {l} | HERE {L} | HERE {J} |
SHIFT {L} BY {d}, 0, {d} | DECOMPOSE m[0] = {l} | DECOMPOSE m[1] = {j} | PACK {S}, 2, 3 = {s} |
PACK $a[0], 120, 12 = {s} | TIMER 1 = {r} | TIMER {r} = 0 | PARAMETER HAND.TIME = 0.2 |
PARAMETER SPEED.MAX = 80 | PARAMETER NEST.POS[2] = -80 | PARAMETER VEL.LIN = {r} | ENABLE CP |
DISABLE CP | ENABLE DRY.RUN | DISABLE DRY.RUN | DISABLE MESSAGES | ENABLE MESSAGES | ENABLE TRACE |
DISABLE TRACE | DISABLE POWER | ENABLE POWER | ENABLE UPPER | DISABLE FORCE, ROBOT | {n} = {r} |
{n} = {r} | {n} = {c} | m[{n}] = {r} | m[1,2] = {r} | {S} = {s} | {S} = {s} | $a[{n}] = {s} |
SIGNAL {o} | SIGNAL {o}, {o} | SIGNAL {r} | RESET | BITS 3, 4 = {r} | BITS 2010, 3 = {n} |
DAC 1 = {r} |
PULSE {o}, {t} | PULSE 7 | DLYSIG {o}, {t} | WAIT | WAIT {c} | WAIT SIG({i}) | WAIT TIMER(1) > {t} |
SWAIT {i} | TWAIT {t} | WAIT.EVENT , {t} | REACT {i}, {p} | REACT {i}, {p}, 3 |
REACT {i}, {p} ALWAYS |
REACTI {i}, {p}, 9 | REACTI {i} | ON {i} CALL {p}, 2 | ONI {i} CALL {p} | IGNORE {i} | LOCK 3 |
LOCK 0 |
LOCK {r} | REACTE err | REACTE | ONE err | PCEXECUTE b | PCEXECUTE b, {r6} | PCEXECUTE b, -1 |
PCEXECUTE b, 2, 2 | PCEXECUTE | PCABORT | PCEND | PCEND -1 | TYPE {r} |
TYPE "x", {s}, /F8.2, {r}, /C1 |
TYPE /I4, {n}, /X3, /H0, 12, /S | TYPEI {n} | PRINT {s} | WRITE (0) {s} | PROMPT {n} |
PROMPT "how many ", {n}, x | PROMPT {s}, {S} | CALL sub(n, {r}) | CALL sub({r}) | CALL sub |
CALL list(m[], {s}) | CALL list(m[]) | GOSUB r1 | CALLS "sub"({n}) | CALLS {s} | SCALL "r2" |
RETURN |
[1] RETURN 1 | RETURNE | STOP | STOP "over" | HALT | HALT {s} | PAUSE | PAUSE "wait" | GOTO {k} |
IF {c} GOTO {k} | IFSIG {i} THEN {k} | IFSIG {i}, {o} THEN {k} | SETI n = 3 |
INVERSE {L} = {L} | FRAME {L} = {L}, {L}, {L}, {L} | JMOVE {w} | LMOVE {w} | JAPPRO {w}, {d} |
LAPPRO {l}, {d} | JDEPART {d} | LDEPART {d} | TDRAW ,,{d} | TDRAW {d}, 0, 0, 5 |
[a] DRAW 5,5,5,3,3,3,50 |
HOME | HOME 1 | g = g+1 ; IF g < 9 GOTO {k} | x = 1/0 | MOVE nowhere | n = n+m[77] | REMARK a word |
ATTACH (0) | DETACH (0) | {n} = TAS({n}, 1) | $t = $DECODE({S}, ",", 0) | {n} = {n}+1
"""
BLOCKS = """
IF {c} THEN ; {B} ; END | IF {c} THEN ; {B} ; ELSE ; {B} ; END |
FOR {n} = 1 TO 3 ; {B} ; END | FOR v = 3 TO 1 STEP -1 ; {B} ; END |
FOR u = {r} TO {r} STEP {r} ; {B} ; END |
h = 0 ; WHILE h < 3 DO ; {B} ; h = h+1 ; END | f = 0 ; DO ; {B} ; f = f+1 ; UNTIL f > 2 |
WHILE {c} DO ; {B} ; END | DO ; {B} ; WAIT ; UNTIL {c} |
CASE {n} OF ; VALUE 1, 2: ; {B} ; VALUE {r}: ; {B} ; ANY ; {B} ; END |
SCASE {S} OF ; SVALUE "ab", {s}: ; {B} ; END |
FOR e = 1 TO 4 ; IF {c} THEN ; EXIT ; END ; {B} ; IF {c} THEN ; NEXT ; END ; END
"""
# statements of programs that may not move the arm
BESIDE = """
WAIT | WAIT | WAIT {c} | WAIT SIG({i}) | SIGNAL {o} | SIGNAL {o} | {n} = {r} | z = z+1 | TYPE {n} |
BRAKE | [+] SPEED 40 MONITOR | REACT {i}, {p} | REACTI {i}, {p}, 4 | IGNORE {i} | LOCK 2 |
PCEND | PCABORT |
PROMPT {n} | x = 1/{n} | CALL r1 | CALL sub(n, {r}) | WAIT TIMER(2) > {t} | TIMER 2 = 0 |
TWAIT {t} |
MOVE {w} | BITS 2001, 3 = {n} | PULSE {o}, {t} | STOP | HALT | REACTE err | ENABLE TRACE |
DISABLE TRACE |
IF {c} GOTO {k} | GOTO {k} | PARAMETER HAND.TIME = 0.1 | SET {L} = HERE | PCEXECUTE b | DELAY {t}
"""
SUBROUTINES = """
{B} | RETURN | [1] RETURN 1 | a1 = {r} | a2 = a1+1 | TYPE a1 | SPEED 20 | BREAK | CALL r1 |
REACT {i}, r2 |
PAUSE | x = 1/a1 | CALL sub(a1, n)
"""
EXPRESSIONS = {
    "r": """
    0 | 1 | 2 | 3 | -1 | 0.5 | 1E3 | {n} | {n} | {n} | ({r}+{r}) | ({r}-{r}) | ({r}*{r}) |
    ({r}/{r}) | ({r} MOD 3) |
    -({r}) | ABS({r}) | ATAN2({r}, {r}) | COS({r}) | SIN({r}) | TAN({r}) | FRACT({r}) | INT({r}) |
    MAX({r}, {r}) | MIN({r}, 2) | OUTSIDE(1, {r}, 3) | RANDOM | SIGN({r}) | SQR({r}) | SQRT({r}) |
    BCD({n}) | DCB({n}) | DISTANCE({l}, {l}) | DX({l}) | DY({l}) | DZ({l}) | IDENTICAL({l}, {l}) |
    INRANGE({l}) | INRANGE({j}) | HAND | BITS(1, 4) | BITS(1001, {r}) | TIMER(1) | TIMER({r}) |
    SPEED({r}) |
    DEFINED({n}) | DEFINED(nowhere) | SWITCH(CP) | PARAMETER(HAND.TIME) |
    PARAMETER(NEST.POS[1]) | ADC(1) |
    PENDANT(1) | PRIORITY | STATE(2) | STATUS("b") | ERROR(0) | FREE(0) | LAST(m[]) | TAS(n, 2) |
    TIME |
    ASC({s}) | LEN({s}) | POS({s}, "b") | VAL({s}) | m[1] | m[{r}] | ({r} BAND 6) | ({r} BOR 1) |
    ({r} BXOR 3) |
    (COM 5) | MAXVAL({r}, 1) | MINVAL({r}, 1) | [+a] ({r})**2 | INSTR(1, {s}, "b")
    """,
    "c": """
    ({r} > {r}) | ({r} == {r}) | ({n} < 3) | ({n} <> 1) | ({r} <= {r}) | ({r} >= 2) | SIG({i}) |
    SIG(1001) | SIG(-{i}) |
    SIG({o}) | TRUE | FALSE | (NOT {c}) | ({c} AND {c}) | ({c} OR {c}) | ({c} XOR {c}) |
    ({s} == {s}) | ({s} < "b") |
    (TIMER(0) > {t}) | (DISTANCE(HERE, {l}) < 5) | (STATUS("b") == 0) | SIG(1001, -2001)
    """,
    "l": """
    {L} | {L} | {L} | {L}:TRANS(0,0,{d},90,-90,0) | {L}:RX({d}) | {L}:RY({d}) | {L}:RZ({d}) |
    SHIFT({L} BY {d}, 0, {d}) |
    HERE | DEST | INVERSE({L}):{L}:{L} | FRAME({L}, {L}, {L}, {L}) | NULL | BASE | TOOL |
    SCALE({L} BY 0.9) |
    TRANS({d},{d},{d},90,-90,0)
    """,
    "j": """
    {J} | {J} | #HERE | #DEST | #PPOINT(0,-60,120,0,40,0) | #PPOINT({d},-45,135,0,60,0) |
    #PPOINT(900)
    """,
    "w": "{L} | {L} | {J} | {l} | {j}",
    "s": """
    "ab" | "a,b,c" | "" | "7 x" | {S} | {S} | {S}+{s} | $CHR({r}) | $MID({s}, 1, 2) |
    $ENCODE({r}, /F6.1, {r}) |
    $DECODE({S}, ",", 0) | $TRUNCATE({s}) | $UNPACK($a[0], 1, 5) | $ERROR(-300) | $TIME() |
    $DATE(1) | $a[1] | "r1" | "sub"
    """,
    "n": "n | n | i | x | y | m[2] | z",
    "L": "p1 | p2 | p3 | p4 | q[1]",
    "J": "#j1 | #j2 | #j3",
    "S": "$s | $t | $a[2]",
    "o": "1 | -1 | 2 | -2 | 2001 | -2001 | 2002 | -2002 | 31",
    "i": "1001 | 1002 | -1001 | 2001 | 2002 | -2002 | 1003",
    "p": "r1 | r2",
    "d": "5 | -10 | 20 | 40",
    "t": "0.1 | 0.3 | 1 | 0",
    "r6": "1 | 2 | 3 | 4 | 6 | {r}",
}
TAG = re.compile(r"^\[(only )?([12+a]+)\] ")  # columns of dialects that a part is for
HOLE = re.compile(r"\{(\w+)\}")
WORD = re.compile(r"[#$]?[A-Za-z][\w.]*")


@cache
def parts(text: str) -> list[str]:
    """Return what stands between bars."""
    return [part.strip() for part in text.replace("\n", " ").split("|")]


def bare(part: str) -> str:
    """Return a part without the dialects that it names."""
    return TAG.sub("", part)


@cache
def known(part: str, dialect: str) -> bool:
    """Return whether a dialect has the words of a part."""
    chosen = DIALECTS[dialect]
    tag = TAG.match(part)
    if tag is not None:
        only = set(chosen.letters) <= set(tag[2]) if tag[1] else chosen.has(tag[2])
        return only and known(bare(part), dialect)
    for line in part.split(";"):
        first = WORD.match(line.strip())
        row = INSTRUCTIONS.get(first[0].upper()) if first is not None else None
        assigns = "=" in line.partition("(")[0] and row is None
        if row is not None and not assigns and not chosen.has(row.dialects):
            return False
    for name in re.findall(r"([#$]?[A-Z][\w.]*)(?=\()", part):
        function = FUNCTIONS.get(name.lower())
        if function is not None and not chosen.has(function.dialects):
            return False
    return True
