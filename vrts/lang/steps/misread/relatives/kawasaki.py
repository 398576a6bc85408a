"""What students of AS write, and how AS has it."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_LOCAL = "a variable is local by the dot before its name"
_WORDS = (  # of VAL-II and V+, of AS, what it does
    ("MOVES", "LMOVE", "LMOVE moves straight in AS"),
    ("MOVE", "JMOVE", "JMOVE moves by the joints in AS"),
    ("APPROS", "LAPPRO", "LAPPRO approaches straight in AS"),
    ("APPRO", "JAPPRO", "JAPPRO approaches by the joints in AS"),
    ("DEPARTS", "LDEPART", "LDEPART departs straight in AS"),
    ("DEPART", "JDEPART", "JDEPART departs by the joints in AS"),
)
_SECONDS = "TWAIT waits for seconds, and takes no `{w}`"
_STRINGS = "CASE takes a number, SCASE a string in AS"
_RENAMES = (  # words of VAL, VAL-II and V+ that AS has by another name
    ("FLIP", "DWRIST"),
    ("NOFLIP", "UWRIST"),
    ("REACTE", "ONE"),
    ("CALLS", "SCALL"),
    ("TYPEI", "PRINT"),
    ("WRITE", "PRINT"),
    ("REST", "HOME"),
    ("NEST", "HOME"),
    ("GOSUB", "CALL"),
    ("PCPROCEED", "PCCONTINUE"),
)
_ONE_DOT = "the dot of `{w}.{n}` stands before `{w}`"
_SIGNALS = "SWAIT waits for signals by their numbers"
_CALLED = "the program of {w} stands behind CALL"

_RENAMED = tuple(Idiom(f"{old}_{{r}}", f"{new} {{r}}", says=says) for old, new, says in _WORDS)
_TIMES = tuple(
    row
    for word, says in (("TWAIT", _SECONDS), ("STABLE", "STABLE waits for seconds, and takes no `{w}`"))
    for row in (
        Idiom(f"{word}_{{d}} <SECONDS|SECOND|SECS|SEC|S>", f"{word} {{d}}", says=says),
        Idiom(f"{word}_{{d}} <MSECS|MSEC|MS|MILLISECONDS>", f"{word} {{d/1000}}", says=says),
    )
)
_BY_NUMBER = tuple(
    row
    for word, old in (("ONI", "ONI"), ("ON", "ON"), ("ONI", "REACTI"), ("ON", "REACT"))
    for row in (
        Idiom(f"{old}_{{d}} , <CALL>_{{n}}", f"{word} {{d}} CALL {{n}}", says=_CALLED.format(w=word)),
        Idiom(f"{old}_{{d}} , {{n}}", f"{word} {{d}} CALL {{n}}", says=_CALLED.format(w=word)),
        Idiom(f"{old}_{{d}} , {{n}} , {{d2}}", f"{word} {{d}} CALL {{n}}, {{d2}}", says=_CALLED.format(w=word)),
        Idiom(f"{old}_{{d}} , {{n}} ( )", f"{word} {{d}} CALL {{n}}", says=_CALLED.format(w=word)),
        Idiom(f"{old}_{{d}}_<EXECUTE|DO|RUN>_{{n}}", f"{word} {{d}} CALL {{n}}", says=_CALLED.format(w=word)),
        Idiom(f"{old}_SIG ( {{d}} )_CALL_{{r}}", f"{word} {{d}} CALL {{r}}", says=f"{word} watches a signal by its number"),
        Idiom(f"{old}_SIG ( {{d}} ) , {{n}}", f"{word} {{d}} CALL {{n}}", says=f"{word} watches a signal by its number"),
    )
)
_WATCHING = (
    *_BY_NUMBER,
    Idiom("REACTI_{d}_CALL_{r}", "ONI {d} CALL {r}", says="ONI watches a signal in AS"),
    Idiom("REACT_{d}_CALL_{r}", "ON {d} CALL {r}", says="ON watches a signal in AS"),
)

AS_SLIPS = (
    *_RENAMED,
    *_TIMES,
    *_WATCHING,
    Idiom("READY", "HOME", says="the rest position of AS is HOME"),
    Idiom("SET_{r} = {e}", "POINT {r} = {e}", says="a location is given a value by POINT in AS"),
    Idiom("AUTO_<REAL|DOUBLE|LOC|INTEGER|INT>_{v}", says="AS declares nothing", note=_LOCAL, help="take it out, and write `.{v}` wherever it is used"),
    Idiom("<AUTO|LOCAL|DIM|VAR|REAL|INT|INTEGER|FLOAT>_{v} = {e}", ".{v} = {e}", says="AS declares nothing", note=_LOCAL, help="write `.{v} = {e}`, and `.{v}` wherever it is used", sure=False),
    Idiom("<AUTO|LOCAL|DIM|VAR|REAL|INT|INTEGER|FLOAT>_{v}", says="AS declares nothing", note=_LOCAL, help="take it out, and write `.{v}` wherever it is used"),
    Idiom("<AUTO|LOCAL|DIM|VAR|REAL|INT|INTEGER|FLOAT>_{v} , {r}", says="AS declares nothing", note=_LOCAL, help="take it out, and write `.{v}` wherever it is used"),
    Idiom("GLOBAL_{v}", says="AS declares nothing", note="a variable without a dot is known to all programs", drop=True, help="take it out"),
    Idiom("WAIT.EVENT , {e}", "TWAIT {e}", says="TWAIT waits for a time in AS"),
    Idiom("WAIT_UNTIL_{e}", "WAIT {e}", says="WAIT already waits until a condition holds"),
    Idiom("WAIT_SIG_{d}", "WAIT SIG({d})", says="SIG has its signal in parentheses"),
    Idiom("SWAIT_SIG ( {e} )", "SWAIT {e}", says=_SIGNALS),
    Idiom("SWAIT_NOT_SIG ( {d} )", "SWAIT -{d}", says=_SIGNALS, note="a minus stands for a signal that is off"),
    Idiom("SWAIT_NOT_{d}", "SWAIT -{d}", says=_SIGNALS, note="a minus stands for a signal that is off"),
    Idiom("SWAIT_{d}_AND_{d2}", "SWAIT {d}, {d2}", says=_SIGNALS, note="SWAIT waits for all signals of a list"),
    Idiom("SWAIT_{d} <=|==> <ON|TRUE|1>", "SWAIT {d}", says=_SIGNALS),
    Idiom("SWAIT_{d} <=|==> <OFF|FALSE|0>", "SWAIT -{d}", says=_SIGNALS, note="a minus stands for a signal that is off"),
    Idiom("SWAIT_{d}_<ON|TRUE>", "SWAIT {d}", says=_SIGNALS),
    Idiom("SWAIT_{d}_<OFF|FALSE>", "SWAIT -{d}", says=_SIGNALS, note="a minus stands for a signal that is off"),
    Idiom("ACCURACY_{d} MM", "ACCURACY {d}", says="ACCURACY has no unit: it is in mm"),
    Idiom("ACCURACY_{d} MM_ALWAYS", "ACCURACY {d} ALWAYS", says="ACCURACY has no unit: it is in mm"),
    Idiom("SPEED_{d} <MMS|MM_S|MMSEC>", "SPEED {d} MM/S", says="`{w}` is no unit of AS: millimetres a second are MM/S"),
    Idiom("SPEED_{d} <MMS|MM_S|MMSEC>_ALWAYS", "SPEED {d} MM/S ALWAYS", says="`{w}` is no unit of AS: millimetres a second are MM/S"),
    Idiom("PULSE_{d}_{d2}", "PULSE {d}, {d2}", says="a comma is missing before `{d2}`"),
    Idiom("PULSE_{d}_FOR_{d2}", "PULSE {d}, {d2}", says="PULSE takes a signal and its seconds, parted by a comma"),
    Idiom("POINT_{r}[ {r2} ] = {d} , {d2} , {d3}", "POINT {r}[{r2}] = TRANS({d}, {d2}, {d3})", says="coordinates are made a location by TRANS"),
    Idiom("POINT_{l} = {d} , {d2} , {d3}", "POINT {l} = TRANS({d}, {d2}, {d3})", says="coordinates are made a location by TRANS"),
    Idiom("POINT_{l} = ( {d} , {d2} , {d3} )", "POINT {l} = TRANS({d}, {d2}, {d3})", says="coordinates are made a location by TRANS"),
    Idiom("POINT_{l} = {d} , {d2} , {d3} , {d4} , {d5} , {d6}", "POINT {l} = TRANS({d}, {d2}, {d3}, {d4}, {d5}, {d6})", says="coordinates are made a location by TRANS"),
    Idiom("POINT_{l}_{l2}", "POINT {l} = {l2}", says="`=` is missing before `{l2}`"),
    Idiom("HERE = {l}", "POINT {l} = HERE", says="HERE takes no value: it names the place of the arm", sure=False),
    Idiom("$.{n} = {e}", ".${n} = {e}", says=_ONE_DOT.replace("{w}", "$")),
    Idiom("#.{n} = {e}", "POINT .#{n} = {e}", says=_ONE_DOT.replace("{w}", "#")),
    Idiom("POINT_#.{n} = {e}", "POINT .#{n} = {e}", says=_ONE_DOT.replace("{w}", "#")),
    Idiom("EXECUTE_{n}", "CALL {n}", says="EXECUTE is a command for the monitor", note="CALL runs a program and comes back; PCEXECUTE runs one beside this", sure=False),
    Idiom("ONI_{d} , CALL_{n}", "ONI {d} CALL {n}", says="no comma stands before CALL"),
    Idiom("ON_{d} , CALL_{n}", "ON {d} CALL {n}", says="no comma stands before CALL"),
    Idiom("ONI_{d}_{n}", "ONI {d} CALL {n}", says=_CALLED.format(w="ONI")),
    Idiom("ON_{d}_{n}", "ON {d} CALL {n}", says=_CALLED.format(w="ON")),
    Idiom("LDEPART_{l} , {d}", "LDEPART {d}", says="LDEPART takes the distance alone", note="it moves away from where the tool is"),
    Idiom("JDEPART_{l} , {d}", "JDEPART {d}", says="JDEPART takes the distance alone", note="it moves away from where the tool is"),
    Idiom("FOR_{l} = {e} .. {e2}", "FOR {l} = {e} TO {e2}", says="the ends of a FOR are parted by TO"),
    Idiom("FOR_{l} = {e}_TO_{e2}_DO", "FOR {l} = {e} TO {e2}", says="FOR ends with its last number, and takes no DO"),
    Idiom("PROMPT_{l} , {s}", "PROMPT {s}, {l}", says="the text of PROMPT comes first, then its variable"),
    Idiom("PCEXECUTE_{d} , {n}", "PCEXECUTE {d}: {n}", says="a colon stands behind the number of PCEXECUTE"),
    Idiom("PCEXECUTE_{d}_{n}", "PCEXECUTE {d}: {n}", says="a colon stands behind the number of PCEXECUTE"),
    Idiom("<PCABORT|PCEND|PCKILL>_{d}", "{w} {d}:", says="a colon stands behind the number of a program beside this one"),
    Idiom("DECOMPOSE_{l} = {e}[ 0 ]", "DECOMPOSE {e}[0] = {l}", says="DECOMPOSE has the array before `=` and the location behind it", sure=False),
    Idiom("SPEED_{e} MMPS", "SPEED {e} MM/S", says="MMPS is no unit of AS: millimetres a second are MM/S"),
    Idiom("SPEED_{e} MMPS_ALWAYS", "SPEED {e} MM/S ALWAYS", says="MMPS is no unit of AS: millimetres a second are MM/S"),
    Idiom("<ACCURACY|ACCEL|DECEL|TWAIT|STABLE> = {e}", "{w} {e}", says="{w} takes its value without `=`"),
    Idiom("SPEED_{r} IPS {r2}", says="IPS is no unit of AS", help="write millimetres a second: `SPEED 100 MM/S`; an inch is 25.4 mm"),
    Idiom("CASE_${n}_OF", "SCASE ${n} OF", says=_STRINGS, help="write `SCASE ${n} OF`, and SVALUE for each VALUE", sure=False),
    Idiom("CASE_.${n}_OF", "SCASE .${n} OF", says=_STRINGS, help="write `SCASE .${n} OF`, and SVALUE for each VALUE", sure=False),
    Idiom("ENABLE_{r}", "{r} ON", says="a switch of AS is turned on by ON behind its name"),
    Idiom("DISABLE_{r}", "{r} OFF", says="a switch of AS is turned off by OFF behind its name"),
    Idiom("ENABLE_POWER", says="AS turns no power on in a program", help="leave it out: power is turned on at the panel", drop=True),
    *(Idiom(f"{old}_{{r}}", f"{new} {{r}}", says=f"{new} stands for {old} in AS") for old, new in _RENAMES),
    *(Idiom(old, new, says=f"{new} stands for {old} in AS") for old, new in _RENAMES),
    *(
        Idiom(f"{word}{always}", f"ACCURACY {mm}{kept}", says="ACCURACY says in AS how near a motion comes, in mm", sure=False)
        for word, mm in (("COARSE", "50"), ("FINE", "1"))
        for always, kept in (("_ALWAYS", " ALWAYS"), ("", ""))
    ),
    *(Idiom(f"{word}{always}", says=f"AS has no {word}", help="leave it out", drop=True) for always in ("_ALWAYS", "") for word in ("NULL", "NONULL", "INTON", "INTOFF", "SINGLE", "MULTIPLE")),
    *(Idiom(f"{word} ( {{r}} ) {{r2}}", says=f"AS has no {word}", help="leave it out: the robot is attached", drop=True) for word in ("ATTACH", "DETACH")),
    *(Idiom(word, says=f"AS has no {word}", help="leave it out: the robot is attached", drop=True) for word in ("ATTACH", "DETACH")),
    Idiom("DURATION_{e}", "SPEED {e} S", says="a motion is given a time by SPEED in AS"),
    Idiom("DURATION_{e}_ALWAYS", "SPEED {e} S ALWAYS", says="a motion is given a time by SPEED in AS"),
    Idiom("GRASP_{r}", says="AS has no GRASP", help="write `CLOSEI`, and ask a sensor: `IF SIG(1001) THEN`"),
    Idiom("MOVET_{e} , {e2}", "JMOVE {e}", says="AS has no MOVET", help="write `OPEN` or `CLOSE`, and `JMOVE {e}` in the line below", sure=False),
    Idiom("MOVEST_{e} , {e2}", "LMOVE {e}", says="AS has no MOVEST", help="write `OPEN` or `CLOSE`, and `LMOVE {e}` in the line below", sure=False),
    Idiom("PARAMETER_{r}", says="AS has no PARAMETER", help="leave it out: parameters are set at the panel"),
    Idiom("<START|RUN|SPAWN|THREAD|TASK>_{n}", says="PCEXECUTE runs a program beside this one", help="write `PCEXECUTE 1: {n}` to run it beside this one, or `CALL {n}` to wait for it"),
    Idiom("<START|RUN|SPAWN|THREAD|TASK>_{n} ( )", says="PCEXECUTE runs a program beside this one", help="write `PCEXECUTE 1: {n}` to run it beside this one, or `CALL {n}` to wait for it"),
    Idiom("<CP|QTOOL|MESSAGES|OX.PREOUT|REP_ONCE|RPS|TEACH_LOCK> = ON", "{w} ON", says="a switch takes ON without `=`"),
    Idiom("<CP|QTOOL|MESSAGES|OX.PREOUT|REP_ONCE|RPS|TEACH_LOCK> = OFF", "{w} OFF", says="a switch takes OFF without `=`"),
)
