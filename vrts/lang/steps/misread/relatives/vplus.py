"""What students of V+ write, and how V+ has it."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_UNIT = "the number of a device stands in parentheses"
_TYPES = "V+ declares AUTO REAL, AUTO DOUBLE and AUTO LOC; whole numbers are REAL too"
_ONLY_NAMES = "{w} only names variables"
_RENAMES = (  # words of AS, VAL and VAL-II that V+ has by another name
    ("DWRIST", "FLIP"),
    ("UWRIST", "NOFLIP"),
    ("ONE", "REACTE"),
    ("SCALL", "CALLS"),
    ("TYPEI", "TYPE"),
    ("REST", "READY"),
    ("NEST", "READY"),
    ("GOSUB", "CALL"),
)
_SEPARATE = "give the value on a separate line, below all declarations: `{v} = {e}`"

_OF_DEVICES = tuple(
    row
    for word in ("ATTACH", "DETACH", "FCLOSE", "FEMPTY")
    for row in (
        Idiom(f"{word}_{{d}}", f"{word} ({{d}})", says=_UNIT),
        Idiom(f"{word}_{{v}}", f"{word} ({{v}})", says=_UNIT),
        Idiom(f"{word}_{{d}} , {{d2}}", f"{word} ({{d}}, {{d2}})", says=_UNIT),
        Idiom(f"{word}_{{v}} , {{d2}}", f"{word} ({{v}}, {{d2}})", says=_UNIT),
        Idiom(f"{word}_{{d}} , {{d2}}_{{s}}", f"{word} ({{d}}, {{d2}}) {{s}}", says=_UNIT),
        Idiom(f"{word}_{{v}} , {{d2}}_{{s}}", f"{word} ({{v}}, {{d2}}) {{s}}", says=_UNIT),
        Idiom(f"{word}_{{d}}_{{s}}", f"{word} ({{d}}) {{s}}", says=_UNIT),
        Idiom(f"{word}_{{v}}_{{s}}", f"{word} ({{v}}) {{s}}", says=_UNIT),
    )
)
_OF_DATA = tuple(
    row
    for word in ("WRITE", "READ", "FOPENR", "FOPENW", "FOPENA", "FOPEN", "FDELETE", "GETEVENT")
    for row in (
        Idiom(f"{word}_{{d}} , {{r}}", f"{word} ({{d}}) {{r}}", says=_UNIT),
        Idiom(f"{word}_{{n}} , {{r}}", f"{word} ({{n}}) {{r}}", says=_UNIT),
        Idiom(f"{word}_{{n}}_{{s}}", f"{word} ({{n}}) {{s}}", says=_UNIT),
        Idiom(f"{word}_{{n}}_{{s}} , {{r}}", f"{word} ({{n}}) {{s}}, {{r}}", says=_UNIT),
        Idiom(f"{word}_{{d}}_{{s}}", f"{word} ({{d}}) {{s}}", says=_UNIT),
        Idiom(f"{word}_{{d}}_{{s}} , {{r}}", f"{word} ({{d}}) {{s}}, {{r}}", says=_UNIT),
        Idiom(f"{word} ( {{e}} ) , {{r}}", f"{word} ({{e}}) {{r}}", says="no comma stands behind the number of a device"),
    )
)
_DECLARING = tuple(
    row
    for word in ("AUTO", "LOCAL", "GLOBAL")
    for row in (
        Idiom(f"{word}_<REAL|DOUBLE|INTEGER|INT>_{{v}} = {{e}}", f"{word} REAL {{v}}\n{{v}} = {{e}}", says=_ONLY_NAMES.format(w=word), help=_SEPARATE, sure=False),
        Idiom(f"{word}_{{v}} = {{e}}", f"{word} {{v}}\n{{v}} = {{e}}", says=_ONLY_NAMES.format(w=word), help=_SEPARATE, sure=False),
        Idiom(f"{word}_<INTEGER|INT|LONG|SHORT|BYTE|BOOLEAN|BOOL|FLOAT|NUM|NUMBER>_{{r}}", f"{word} REAL {{r}}", says="{w} is no type of V+", note=_TYPES),
        Idiom(f"{word}_<LOCATION|TRANSFORMATION|TRANS|TRANSFORM|POSE|POS|POSITION|POINT|ROBTARGET|FRAME>_{{r}}", f"{word} LOC {{r}}", says="{w} is no type of V+", note=_TYPES),
        Idiom(f"{word}_<STRING|STR|TEXT|CHAR>_${{r}}", f"{word} ${{r}}", says="{w} is no type of V+", note="`$` already says that a variable is a string"),
        Idiom(f"{word}_<STRING|STR|TEXT|CHAR>_{{n}}", f"{word} ${{n}}", says="{w} is no type of V+", note="the name of a string begins with `$`, here and wherever it is used", sure=False),
        Idiom(f"{word}_{{v}}_AS_{{r}}", f"{word} {{v}}", says="a type stands before the names, as in `AUTO REAL n`", note=_TYPES, sure=False),
        Idiom(f"{word}_{{v}} : {{r}}", f"{word} {{v}}", says="a type stands before the names, as in `AUTO REAL n`", note=_TYPES, sure=False),
    )
)

VPLUS_SLIPS = (
    *_OF_DEVICES,
    *_OF_DATA,
    *_DECLARING,
    Idiom("<REAL|INTEGER|INT|FLOAT|NUM|DOUBLE>_{v}", "AUTO REAL {v}", says="a declaration begins with AUTO", note=_TYPES),
    Idiom("<REAL|INTEGER|INT|FLOAT|NUM|DOUBLE>_{v} , {r}", "AUTO REAL {v}, {r}", says="a declaration begins with AUTO", note=_TYPES),
    Idiom("<REAL|INTEGER|INT|FLOAT|NUM|DOUBLE>_{v} = {e}", "AUTO REAL {v}\n{v} = {e}", says="a declaration begins with AUTO, and gives no value", note=_TYPES, help="write `AUTO REAL {v}` at the top, and `{v} = {e}` on a separate line", sure=False),
    Idiom("<LOC|TRANS|LOCATION|POSE|ROBTARGET>_{v}", "AUTO LOC {v}", says="a declaration begins with AUTO", note=_TYPES),
    Idiom("<STRING|STR|CHAR>_${n}", "AUTO ${n}", says="a declaration begins with AUTO", note="`$` says that a variable is a string"),
    Idiom("EXECUTE_{d} , {n}", "EXECUTE {d} {n}()", says="a blank stands between the task and its program, and no comma"),
    Idiom("EXECUTE_{d} , {n} ( {r} )", "EXECUTE {d} {n}({r})", says="a blank stands between the task and its program, and no comma"),
    Idiom("PARAMETER_{n}_{d}", "PARAMETER {n} = {d}", says="PARAMETER gives its value behind `=`"),
    Idiom("SELECT_<ROBOT|VISION|FORCE>_{d}", "SELECT {w} = {d}", says="SELECT gives its number behind `=`"),
    Idiom("ENABLE_{n} = <ON|TRUE|1>", "ENABLE {n}", says="ENABLE turns a switch on, and takes no `=`"),
    Idiom("DISABLE_{n} = <OFF|FALSE|0>", "DISABLE {n}", says="DISABLE turns a switch off, and takes no `=`"),
    Idiom("SWITCH_{n}", "SWITCH {n} = ON", says="SWITCH gives a switch its value behind `=`", sure=False),
    Idiom("SWITCH_{n}_<ON|OFF>", "SWITCH {n} = {w}", says="SWITCH gives a switch its value behind `=`"),
    Idiom("<SET.SPEED|SETSPEED|SET_SPEED>_{d}", "SPEED {d}", says="SPEED sets the speed"),
    Idiom("<CP|DRY.RUN|POWER|ROBOT|FORCE|BELT|MESSAGES>_ON", "ENABLE {w}", says="a switch is turned on by ENABLE"),
    Idiom("<CP|DRY.RUN|POWER|ROBOT|FORCE|BELT|MESSAGES>_OFF", "DISABLE {w}", says="a switch is turned off by DISABLE"),
    Idiom("<JMOVE|HMOVE>_{r}", "MOVE {r}", of="AS", says="MOVE moves by the joints in V+"),
    Idiom("LMOVE_{r}", "MOVES {r}", of="AS", says="MOVES moves straight in V+"),
    Idiom("JAPPRO_{r}", "APPRO {r}", of="AS", says="APPRO approaches in V+"),
    Idiom("LAPPRO_{r}", "APPROS {r}", of="AS", says="APPROS approaches straight in V+"),
    Idiom("JDEPART_{r}", "DEPART {r}", of="AS", says="DEPART departs in V+"),
    Idiom("LDEPART_{r}", "DEPARTS {r}", of="AS", says="DEPARTS departs straight in V+"),
    Idiom("HOME", "READY", of="AS", says="the rest position of V+ is READY"),
    Idiom("TWAIT_{e}", "DELAY {e}", of="AS", says="DELAY waits for a time in V+"),
    Idiom("SWAIT_{d}", "WAIT SIG({d})", of="AS", says="WAIT waits for a condition in V+"),
    Idiom("POINT_{v} = {e}", "SET {v} = {e}", of="AS", says="a location is given a value by SET in V+"),
    Idiom("PRINT_{r}", "TYPE {r}", of="AS", says="TYPE writes to the terminal in V+"),
    Idiom("WAIT_SIG_{d}", "WAIT SIG({d})", says="SIG has its signal in parentheses"),
    Idiom("WAIT_UNTIL_{e}", "WAIT {e}", says="WAIT already waits until a condition holds"),
    Idiom("SWAIT_SIG ( {r} )", "WAIT SIG({r})", of="AS", says="WAIT waits for a condition in V+"),
    *(Idiom(f"{old}_{{r}}", f"{new} {{r}}", of="AS", says=f"{new} stands for {old} in V+") for old, new in _RENAMES),
    *(Idiom(old, new, of="AS", says=f"{new} stands for {old} in V+") for old, new in _RENAMES),
    Idiom("ONI_{d}_CALL_{n}", "REACTI {d}, {n}", of="AS", says="REACTI watches a signal in V+"),
    Idiom("ON_{d}_CALL_{n}", "REACT {d}, {n}", of="AS", says="REACT watches a signal in V+"),
    Idiom("ONI_{d}_CALL_{n} , {d2}", "REACTI {d}, {n}, {d2}", of="AS", says="REACTI watches a signal in V+"),
    Idiom("ON_{d}_CALL_{n} , {d2}", "REACT {d}, {n}, {d2}", of="AS", says="REACT watches a signal in V+"),
    Idiom("SCASE_{e}_OF", "CASE {e} OF", of="AS", says="V+ has no SCASE", help="compare by IF: `IF {e} == \"text\" THEN`", sure=False),
    Idiom("ACCURACY_{r}", "COARSE ALWAYS", of="AS", says="COARSE and FINE say in V+ how near a motion must come", help="write `COARSE ALWAYS` or `FINE ALWAYS`", sure=False),
    Idiom("STABLE_{e}", "BREAK\nDELAY {e}", of="AS", says="BREAK waits in V+ until the arm stands still", sure=False),
    Idiom("PCEXECUTE_{d} : {n}", "EXECUTE {d} {n}()", of="AS", says="EXECUTE runs a program beside this one in V+"),
    Idiom("PCEXECUTE_{n}", "EXECUTE 1 {n}()", of="VAL-II", says="EXECUTE runs a program beside this one in V+", note="a task is told by its number"),
    Idiom("PCABORT", "ABORT 1", of="VAL-II", says="ABORT ends a task by its number in V+", sure=False),
    Idiom("TDRAW_{r}", says="V+ has no TDRAW", of="AS", help="write `MOVES HERE:TRANS(x, y, z, 0, 0, 0)`: along the axes of the tool"),
    Idiom("DRAW_{e} , {e2} , {e3}", "MOVES SHIFT(HERE BY {e}, {e2}, {e3})", of="VAL", says="V+ has no DRAW", note="SHIFT moves a location along X, Y and Z of the world"),
    Idiom("<START|RUN|SPAWN|THREAD|TASK>_{n}", says="EXECUTE runs a program beside this one in V+", help="write `EXECUTE 1 {n}()` to run it beside this one, or `CALL {n}()` to wait for it"),
    Idiom("<START|RUN|SPAWN|THREAD|TASK>_{n} ( )", says="EXECUTE runs a program beside this one in V+", help="write `EXECUTE 1 {n}()` to run it beside this one, or `CALL {n}()` to wait for it"),
    Idiom("PULSE_{d} , {e}", "SIGNAL {d}\nDELAY {e}\nSIGNAL -{d}", of="AS", says="V+ has no PULSE", sure=False),
)
