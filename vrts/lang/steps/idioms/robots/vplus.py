"""Instructions of V+ that VAL-II lacks, with their operands."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_OF = "V+"

VPLUS = (
    Idiom("wait.event_, {e}", "DELAY {e}", _OF, note="DELAY waits for seconds, WAIT for a condition"),
    Idiom("wait.event , {e}", "DELAY {e}", _OF, note="DELAY waits for seconds, WAIT for a condition"),
    Idiom("wait.event {e} , {e2}", "", _OF, help="to wait for a time write `DELAY {e2}`; for a condition or a time `TIMER 1 = 0`, then `WAIT SIG(1001) OR (TIMER(1) > {e2})`"),
    Idiom("wait.event {r}", "", _OF, help="to wait for a time write `DELAY 1`, for a signal `WAIT SIG(1001)`, for another program `WAIT ready == 1`"),
    Idiom("cpon <always|>", "ENABLE CP", _OF),
    Idiom("cpoff <always|>", "DISABLE CP", _OF),
    Idiom("<attach|detach> {r}", "", _OF, help="leave it out: the robot is attached", drop=True),
    Idiom("switch_<cp|dry.run|messages|power|trace|upper> = <on|true>", "", _OF, help="a switch of the system is turned on by ENABLE, as in `ENABLE CP`"),
    Idiom("write ( {d} ) {e}", "TYPE {e}", _OF),
    Idiom("write ( {r} ) {s} , {e}", "TYPE {s}, {e}", _OF),
    Idiom("read ( {r} ) {v}", 'PROMPT "? ", {v}', _OF, help='VAL-II reads from the terminal alone: write `PROMPT "text", {v}`', sure=False),
    Idiom("pdnt.write {e}", "TYPE {e}", _OF),
    Idiom("pdnt.notify {e}", "TYPE {e}", _OF),
    Idiom("pdnt.clear", "", _OF, help="leave it out: VAL-II does not clear the terminal", drop=True),
    Idiom("aio.out_{e} = {e2}", "DAC {e} = {e2}", _OF, sure=False),
    Idiom("movef_{v} {r}", "MOVE {v}", _OF, sure=False),
    Idiom("movesf_{v} {r}", "MOVES {v}", _OF, sure=False),
    Idiom("movec_{v} , {v2}", "", _OF, help="VAL-II has no arcs: compute points on the arc and MOVES to them"),
    Idiom("jmove_{e} , {e2} , {e3} , {e4} , {e5} , {e6}", "MOVE #PPOINT({e}, {e2}, {e3}, {e4}, {e5}, {e6})", _OF),
    Idiom("jhere {r}", "", _OF, help="write `SET #p = #HERE`: a precision point holds all joints"),
    Idiom("decompose_{n} [ {r} ] = {v}", "{n}[0] = DX({v})\n{n}[1] = DY({v})\n{n}[2] = DZ({v})", _OF, sure=False),
    Idiom("solve.trans_{v} {r} = {r2}", "", _OF, help="write `SET {v} = #PPOINT(j1, j2, j3, j4, j5, j6)`"),
    Idiom("solve.angles {r} = {v} {r2}", "", _OF, help="write `SET #p = {v}`: a precision point holds all joints"),
    Idiom("runsig_{d}", "", _OF, help="write `SIGNAL {d}` in the first line of the program and `SIGNAL -{d}` in its last"),
    Idiom("exit_{d}", "", _OF, help="leave the loops by `GOTO label`, to a label below their END"),
    Idiom("calls_{v}", "", _OF, help="CALL takes the name of a program: write a CASE or an IF for each, as in `CALL part`"),
    Idiom("<set.event|clear.event> {r}", "", _OF, help="give a variable a value, as in `ready = 1`, and wait for it by `WAIT ready == 1`"),
    Idiom("cycle.end {r}", "", _OF, help="give a variable a value at the end of the other program, and wait for it by `WAIT done == 1`"),
    Idiom("<duration|accel> {r}", "", _OF, help="VAL-II has no such setting: use SPEED"),
)
