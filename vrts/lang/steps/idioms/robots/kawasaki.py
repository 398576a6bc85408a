"""Instructions of AS that VAL-II lacks, with their operands."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_OF = "AS"
_REACTS = "REACT waits for the end of the step, REACTI stops the motion"

KAWASAKI = (
    Idiom("uwrist", "NOFLIP", _OF),
    Idiom("dwrist", "FLIP", _OF),
    Idiom("<jmove|hmove>_{v}", "MOVE {v}", _OF),
    Idiom("lmove_{v}", "MOVES {v}", _OF),
    Idiom("jmove_{v} , {d}", "MOVE {v}", _OF, sure=False),
    Idiom("lmove_{v} , {d}", "MOVES {v}", _OF, sure=False),
    Idiom("jmove_{e}", "MOVE {e}", _OF),
    Idiom("lmove_{e}", "MOVES {e}", _OF),
    Idiom("jappro_{e} , {e2}", "APPRO {e}, {e2}", _OF),
    Idiom("lappro_{e} , {e2}", "APPROS {e}, {e2}", _OF),
    Idiom("jdepart_{e}", "DEPART {e}", _OF),
    Idiom("ldepart_{e}", "DEPARTS {e}", _OF),
    Idiom("home <1|>", "READY", _OF),
    Idiom("home_{d}", "READY", _OF, sure=False),
    Idiom("twait_{e}", "DELAY {e}", _OF),
    Idiom("mon_twait_{e}", "DELAY {e}", _OF),
    Idiom("stable_{e}", "BREAK\nDELAY {e}", _OF),
    Idiom("swait_{e} , {e2} , {e3}", "WAIT SIG({e}, {e2}, {e3})", _OF),
    Idiom("swait_{e} , {e2}", "WAIT SIG({e}, {e2})", _OF),
    Idiom("swait_{e}", "WAIT SIG({e})", _OF),
    Idiom("pulse_{d} , {e}", "SIGNAL {d}\nDELAY {e}\nBREAK\nSIGNAL -{d}", _OF, sure=False),
    Idiom("pulse_{d}", "SIGNAL {d}\nDELAY 0.2\nBREAK\nSIGNAL -{d}", _OF, sure=False),
    Idiom("dlysig_{d} , {e}", "", _OF, help="write `TIMER 1 = 0`, `WAIT TIMER(1) >= {e}` and `SIGNAL {d}`, each on a line of its own; `DELAY {e}` instead holds the arm"),
    Idiom("dlysig {r}", "", _OF, help="write `TIMER 1 = 0`, `WAIT TIMER(1) >= 2` and `SIGNAL 5`, each on a line of its own"),
    Idiom("on_{e}_call_{n}", "REACT {e}, {n}", _OF, note=_REACTS),
    Idiom("on_{e}_call_{n} , {d}", "REACT {e}, {n}, {d}", _OF, note=_REACTS),
    Idiom("oni_{e}_call_{n}", "REACTI {e}, {n}", _OF, note=_REACTS),
    Idiom("oni_{e}_call_{n} , {d}", "REACTI {e}, {n}, {d}", _OF, note=_REACTS),
    Idiom("<on|oni>_{d}_goto_{r}", "", _OF, help="REACT calls a program: write `REACT {d}, program`, and the steps in `.PROGRAM program`"),
    Idiom("one_{n}", "REACTE {n}", _OF),
    Idiom("point_{n} = {e}", "SET {n} = {e}", _OF),
    Idiom("point_#{n} = {e}", "SET #{n} = {e}", _OF),
    Idiom("<point/x|point/y|point/z|point/oat|point/o|point/a|point/t>_{n} = {r}", "", _OF, help="write `SET {n} = SHIFT({n} BY dx, dy, dz)`, or `SET {n} = TRANS(x, y, z, o, a, t)`"),
    Idiom("xmove_{v} till {e}", "", _OF, help="write `REACTI {e}, program` before `MOVES {v}`: when the signal comes the motion stops, and the program is called"),
    Idiom("tdraw_{e} , {e2} , {e3}", "MOVES HERE:TRANS({e}, {e2}, {e3}, 90, -90, 0)", _OF, sure=False),
    Idiom("<c1move|c2move> {r}", "", _OF, help="VAL-II has no arcs: compute points on the arc and MOVES to them"),
    Idiom("<opens|clamp -> {d}", "OPENI", _OF, sure=False),
    Idiom("<closes|clamp> {d}", "CLOSEI", _OF, sure=False),
    Idiom("relaxs {d}", "RELAXI", _OF, sure=False),
    Idiom("accuracy_{d} <fine|> <always|>", "", _OF, help="use COARSE for less accuracy, FINE for more"),
    Idiom("scall_{r}", "", _OF, help="CALL takes the name of a program: write a CASE or an IF for each, as in `CALL part`"),
    Idiom("scase_{e}_of", "CASE {e} OF", _OF, help="a CASE of VAL-II takes a number: write `IF {e} == \"A\" THEN` for a string", sure=False),
    Idiom("utimer_@{n} = {e}", "TIMER 1 = {e}", _OF, sure=False),
    Idiom("outda_{e} , {e2}", "DAC {e2} = {e}", _OF, sure=False),
    Idiom("bits32_{e} , {e2} = {e3}", "BITS {e}, {e2} = {e3}", _OF),
    Idiom("<ifpwprint|ifpwoverwrite> {r} = {e}", "TYPE {e}", _OF, sure=False),
    Idiom("<weight|decel|toolshape|ena_toolshape|bspeed|curlim|ffset|refflset> {r}", "", _OF, help="leave it out: VAL-II has no such setting", drop=True),
    Idiom("speed_{d} deg/s {r}", "", says="a speed is in percent or in MMPS", help="write `SPEED 50` for half of the full speed"),
    Idiom("jump_{n}", "CALL {n}", _OF, sure=False),
    Idiom("sout_{d} = {e}", "IF {e} THEN\n    SIGNAL {d}\nELSE\n    SIGNAL -{d}\nEND", _OF, sure=False),
    Idiom("mvwait {r}", "BREAK", _OF, sure=False),
)
