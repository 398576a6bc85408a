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

_HANDS = "<OPEN|OPENI|CLOSE|CLOSEI|RELAX|RELAXI>"
_ONE_HAND = "{w} takes nothing behind it: there is one hand"
_NAMED_BY_STRING = "CALL takes the name of a program, CALLS a string"
_EVENT = "WAIT.EVENT waits for seconds behind its comma"
_COMPARED = "V+ jumps by one condition at a time"

_OF_HANDS = (
    Idiom(_HANDS + "_{d}", "{w}", says=_ONE_HAND),
    Idiom(_HANDS + " ( {d} )", "{w}", says=_ONE_HAND),
    Idiom(_HANDS + "_<GRIPPER|HAND|JAWS|JAW|FINGERS|GRIP|CLAMP|TOOL>", "{w}", says=_ONE_HAND),
    Idiom(_HANDS + " ( )", "{w}", says="{w} has no parentheses"),
    Idiom("GRASP_{r}", "CLOSEI", of="VAL-II", says="V+ has no GRASP", help="write `CLOSEI`, and ask a sensor: `IF SIG(1001) THEN`", sure=False),
)
_OF_WAYS = (
    Idiom("<COARSE|FINE|ACCEL|DURATION|SPEED|NULL|NONULL>_{e} ,_ALWAYS", "{w} {e} ALWAYS", says="ALWAYS follows without a comma"),
    Idiom("<COARSE|FINE|ACCEL|DURATION|SPEED|NULL|NONULL> ,_ALWAYS", "{w} ALWAYS", says="ALWAYS follows without a comma"),
    Idiom("<CLKRESET|CLKSTART|RESETCLOCK|STARTCLOCK|RESET_TIMER|START_TIMER|STARTTIMER|RESETTIMER|TIC>_{n}", "TIMER 1 = 0", says="timers of V+ have numbers, and begin with the value that they are given"),
    Idiom("<CLKRESET|CLKSTART|RESETCLOCK|STARTCLOCK|RESET_TIMER|START_TIMER|STARTTIMER|RESETTIMER|TIC> <( )|>", "TIMER 1 = 0", says="timers of V+ have numbers, and begin with the value that they are given"),
    Idiom("CLKSTOP_{n}", says="a timer of V+ cannot be stopped", help="leave it out, and keep the time: `t = TIMER(1)`", drop=True),
    Idiom("EXIT_<FOR|DO|WHILE|LOOP|REPEAT|CASE>", "EXIT", says="EXIT leaves the innermost loop, and takes no name of it"),
    Idiom("NEXT_<FOR|DO|WHILE|LOOP|REPEAT>", "NEXT", says="NEXT begins the next pass of the innermost loop, and takes no name of it"),
    Idiom("EXIT_<SUB|FUNCTION|FUNC|PROC|PROCEDURE|PROGRAM|PROG|PGM|DEF|SUBROUTINE>", "RETURN", says="a program ends early by RETURN"),
    Idiom("<EXIT|RETURN|LEAVE|QUIT> ( )", "RETURN", says="a program ends early by RETURN", sure=False),
    Idiom("ON_<ERROR|ERR>_<CALL|GOSUB|GOTO|>_{n}", "REACTE {n}", says="REACTE calls a program on an error in V+"),
    Idiom("ON_<ERROR|ERR>_{r}", says="REACTE calls a program on an error in V+", help="write `REACTE program`"),
    Idiom("ON_{e}_<GOTO|GOSUB>_{d} , {d2}", "IF {e} == 1 GOTO {d}\nIF {e} == 2 GOTO {d2}", of="BASIC", says=_COMPARED),
    Idiom("ON_{e}_<GOTO|GOSUB>_{d} , {d2} , {d3}", "IF {e} == 1 GOTO {d}\nIF {e} == 2 GOTO {d2}\nIF {e} == 3 GOTO {d3}", of="BASIC", says=_COMPARED),
    Idiom("ON_{e}_<GOTO|GOSUB|CALL>_{n} , {r}", of="BASIC", says=_COMPARED, help="write `CASE {e} OF`, and a VALUE for each number with its CALL"),
    Idiom("ON_{e}_<GOTO|GOSUB>_{d}", "IF {e} GOTO {d}", of="BASIC", says=_COMPARED, sure=False),
    Idiom("CALL_${n}", "CALLS ${n}", says=_NAMED_BY_STRING),
    Idiom("CALL_${n} ( {r} )", "CALLS ${n}({r})", says=_NAMED_BY_STRING),
    Idiom("CALL_{s} + {e}", "CALLS {s}+{e}", says=_NAMED_BY_STRING),
    Idiom("REACTE_CALL_{n}", "REACTE {n}", says="REACTE takes the name of the program, without CALL"),
    Idiom("IGNORE_<REACT|REACTI|ON|ONI>_{d}", "IGNORE {d}", says="IGNORE takes the number of the signal alone"),
    Idiom("<ON|ONI>_{d} , {n}", "REACTI {d}, {n}", of="AS", says="REACTI watches a signal in V+"),
    Idiom("<ON|ONI>_{d}_{n}", "REACTI {d}, {n}", of="AS", says="REACTI watches a signal in V+"),
    Idiom("<ON|ONI>_SIG ( {d} )_CALL_{n}", "REACTI {d}, {n}", of="AS", says="REACTI watches a signal in V+"),
    Idiom("<INTERRUPT|ON_SIGNAL|ONSIGNAL|ISIGNALDI>_{d} <,|CALL|> {n}", "REACTI {d}, {n}", says="REACTI watches a signal in V+"),
    Idiom("LOOP_{d}_<TIMES|TIME>", "FOR i = 1 TO {d}", says="FOR repeats steps so many times", sure=False),
)
_OF_TIMES = (
    *(Idiom(f"{begin}_{{e}} ,_{end}", f"{begin} {{e}} {end}", says=f"no comma stands before {end}") for begin, end in (("WHILE", "DO"), ("IF", "THEN"), ("CASE", "OF"))),
    Idiom("WAIT.EVENT_{d}_<S|SEC|SECS|SECONDS|SECOND>", "WAIT.EVENT , {d}", says=_EVENT),
    Idiom("WAIT.EVENT , {d} <S|SEC|SECS|SECONDS|SECOND>", "WAIT.EVENT , {d}", says="WAIT.EVENT takes seconds, without a unit"),
    Idiom("WAIT.EVENT , {d} <MS|MSEC|MILLISECONDS>", "WAIT.EVENT , {d/1000}", says="WAIT.EVENT takes seconds, without a unit"),
    Idiom("WAIT.EVENT ( {d} )", "WAIT.EVENT , {d}", says=_EVENT, sure=False),
    Idiom("WAIT.EVENT ( , {d} )", "WAIT.EVENT , {d}", says="WAIT.EVENT takes no parentheses"),
    Idiom("<WAIT_EVENT|WAITEVENT|WAIT.EVNT|WAIT_TIME|WAIT.TIME|WAITTIME> <,|> {d}", "WAIT.EVENT , {d}", says=_EVENT),
    Idiom("<MON_TWAIT|STABLE_TIME>_{e}", "WAIT.EVENT , {e}", of="AS", says=_EVENT),
    Idiom("TIMER_{d} = {d2} <S|SEC|SECS|SECONDS|SECOND>", "TIMER {d} = {d2}", says="a timer counts seconds, without a unit"),
    Idiom("DURATION_{e} <S|SEC|SECS|SECONDS|SECOND>", "DURATION {e}", says="DURATION takes seconds, without a unit"),
    Idiom("DURATION_{e} <S|SEC|SECS|SECONDS|SECOND>_ALWAYS", "DURATION {e} ALWAYS", says="DURATION takes seconds, without a unit"),
    Idiom("<ACCEL|SPEED|DECEL>_{d} <%|PERCENT> , {d2} <%|PERCENT|>", "{w} {d}, {d2}", says="{w} takes percent, without a sign"),
    Idiom("ACCEL_{d} <%|PERCENT>", "ACCEL {d}", says="ACCEL takes percent, without a sign"),
    Idiom("ACCEL_{d} <%|PERCENT>_ALWAYS", "ACCEL {d} ALWAYS", says="ACCEL takes percent, without a sign"),
    Idiom("ACCEL_{d}_{d2}", "ACCEL {d}, {d2}", says="a comma parts the two values of ACCEL"),
    Idiom("ACCEL_{d}_{d2}_ALWAYS", "ACCEL {d}, {d2} ALWAYS", says="a comma parts the two values of ACCEL"),
    Idiom("<DECEL|DECELERATION>_{d}", "ACCEL 100, {d}", of="AS", says="ACCEL takes the deceleration as its second value in V+"),
    Idiom("<DECEL|DECELERATION>_{d}_ALWAYS", "ACCEL 100, {d} ALWAYS", of="AS", says="ACCEL takes the deceleration as its second value in V+"),
    Idiom("<ACCELERATION|ACC|ACCSET|SETACC>_{d}", "ACCEL {d}", says="ACCEL sets the acceleration"),
    Idiom("SPEED_{e}_S", "DURATION {e}", of="AS", says="DURATION gives a motion a time in V+"),
    Idiom("SPEED_{e}_S_ALWAYS", "DURATION {e} ALWAYS", of="AS", says="DURATION gives a motion a time in V+"),
)
_OF_VALUES = (
    Idiom("<SETI|LET|ASSIGN|ASSIGNVAR>_{v} = {e}", "{v} = {e}", says="a value is given by `=` alone"),
    Idiom("BITS_{d} - {d2} = {e}", says="BITS takes the first signal and how many there are", help="write `BITS {d}, 4 = {e}`, with how many signals behind the comma"),
    Idiom("BITS_{d} = {e}", says="BITS takes how many signals there are, too", help="write `BITS {d}, 4 = {e}`, with how many signals behind the comma"),
    Idiom("<POINT|HERE>_{l}_{l2}", "SET {l} = {l2}", of="AS", says="a location is given a value by SET in V+", sure=False),
    Idiom("SET_{l}_{l2}", "SET {l} = {l2}", says="`=` is missing before `{l2}`"),
    Idiom("SET_{l} , {l2}", "SET {l} = {l2}", says="`=` belongs there, and no comma"),
    Idiom("SET_{l} = {l2}_BY_{e} , {e2} , {e3}", "SET {l} = SHIFT({l2} BY {e}, {e2}, {e3})", says="SHIFT moves a location along X, Y and Z"),
    Idiom("SET_{l} = {l2} + {d} , {d2} , {d3}", "SET {l} = SHIFT({l2} BY {d}, {d2}, {d3})", says="SHIFT moves a location along X, Y and Z"),
    Idiom("SET_#{n} = ( {d} , {d2} , {d3} , {d4} , {d5} , {d6} )", "SET #{n} = #PPOINT({d}, {d2}, {d3}, {d4}, {d5}, {d6})", says="#PPOINT makes a precision point of six joints"),
    Idiom("SHIFT_{l}_BY_{e} , {e2} , {e3}", "SET {l} = SHIFT({l} BY {e}, {e2}, {e3})", of="VAL", says="SHIFT yields a location in V+, and SET stores it"),
    Idiom("<TEACH|RECORD|GETPOS|SAVEPOS>_{l}", "HERE {l}", says="HERE stores the place of the arm"),
    Idiom("PROMPT_{s}_{l}", "PROMPT {s}, {l}", says="a comma parts the text of PROMPT from its variable"),
    Idiom("<AUTO|LOCAL|GLOBAL>_<REAL|LOC|DOUBLE>_{v}_{v2}", "{w} {v}, {v2}", says="a comma parts the names of a declaration"),
    Idiom("<AUTO|LOCAL|GLOBAL>_{v}_{v2}_{v3}", "{w} {v}, {v2}, {v3}", says="commas part the names of a declaration"),
    Idiom("SIGNAL_{n}_<ON|TRUE>", "SIGNAL {n}", says="SIGNAL takes numbers only, and neither ON nor OFF"),
    Idiom("SIGNAL_{n}_<OFF|FALSE>", "SIGNAL -{n}", says="SIGNAL takes numbers only, and neither ON nor OFF", note="a minus switches a signal off"),
    Idiom("XMOVE_{l}_TILL_{d}", "MOVES {l}", of="AS", says="V+ stops a motion by REACTI", help="write `REACTI {d}` before `MOVES {l}`, and `IGNORE {d}` behind it", sure=False),
    Idiom("<C1MOVE|C2MOVE>_{l}", "MOVES {l}", of="AS", says="V+ goes along an arc by points on it", help="compute points on the arc, and write `MOVES {l}` for each", sure=False),
    Idiom("WEIGHT_{d} {r}", "PAYLOAD {d}", of="AS", says="PAYLOAD says in V+ how heavy the part is", sure=False),
    Idiom("DLYSIG_{d} , {e}", "DELAY {e}\nBREAK\nSIGNAL {d}", of="AS", says="V+ has no DLYSIG", sure=False),
    Idiom("UTIMER_@{n} = {e}", "TIMER 1 = {e}", of="AS", says="timers of V+ have numbers", sure=False),
    Idiom("<SETHOME|SET2HOME>_{r}", of="AS", says="V+ has no SETHOME", help="keep a location for it, as in `HERE rest`, and go there by `MOVE rest`"),
    Idiom("SVALUE_{r}", "VALUE {r}", of="AS", says="a group of a CASE begins with VALUE in V+", sure=False),
)

VPLUS_SLIPS = (
    *_OF_HANDS,
    *_OF_WAYS,
    *_OF_TIMES,
    *_OF_VALUES,
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
    Idiom("SWITCH_<CP|DRY.RUN|POWER|ROBOT|FORCE|BELT|MESSAGES|AUTO.POWER.OFF|DECEL.100|UPPER|TRACE>", "SWITCH {w} = ON", says="SWITCH gives a switch its value behind `=`", sure=False),
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
    Idiom("PULSE_{d} , {e}", "SIGNAL {d}\nDELAY {e}\nBREAK\nSIGNAL -{d}", of="AS", says="V+ has no PULSE", sure=False),
)
