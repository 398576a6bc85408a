"""Motions, signals and jumps of ABB, FANUC and KUKA that are more than another word."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_BEFORE = "speed, zone and FINE stand on lines of their own, before the motion"
_LINE = "<lin|movel|move_l|slin|lmove>"
_JOINT = "<ptp|movej|move_j|sptp|movep>"
_NUMBERED = "signals of VAL-II have numbers: outputs from 1, inputs from 1001"
_FINE = "a motion stops where FINE and BREAK stand, and else goes on to the next"

FACTORY = (
    # FANUC
    Idiom("j_<p|pr> [ {r} ]_{d} % fine", "", "FANUC", help="write `SPEED {d}`, `FINE` and `MOVE p[{r}]`, each on a line of its own", note=_BEFORE),
    Idiom("j_<p|pr> [ {r} ]_{d} % {r2}", "", "FANUC", help="write `SPEED {d}` and `MOVE p[{r}]`, each on a line of its own", note=_BEFORE),
    Idiom("j_<p|pr> [ {r} ] {r2}", "", "FANUC", help="write `MOVE p[{r}]`", note=_BEFORE),
    Idiom("l_<p|pr> [ {r} ]_{d} <mm / sec|mm / s|mm> fine", "", "FANUC", help="write `SPEED {d} MMPS`, `FINE` and `MOVES p[{r}]`, each on a line of its own", note=_BEFORE),
    Idiom("l_<p|pr> [ {r} ]_{d} <mm / sec|mm / s|mm> {r2}", "", "FANUC", help="write `SPEED {d} MMPS` and `MOVES p[{r}]`, each on a line of its own", note=_BEFORE),
    Idiom("l_<p|pr> [ {r} ] {r2}", "", "FANUC", help="write `MOVES p[{r}]`", note=_BEFORE),
    Idiom("c_<p|pr> [ {r} ] {r2}", "", "FANUC", help="VAL-II has no arcs: compute points on the arc and MOVES to them"),
    Idiom("<do|ro|dout|sdo> [ {d} ] = pulse {r}", "", "FANUC", help="write `SIGNAL {d}`, `DELAY 0.5`, `BREAK` and `SIGNAL -{d}`, each on a line of its own"),
    Idiom("lbl [ {d} ]", "", "FANUC", help="a label is a whole number before its step: write `{d}` at the start of the line of the next step"),
    Idiom("lbl [ {d} : {r} ]", "", "FANUC", help="a label is a whole number before its step: write `{d}` at the start of the line of the next step"),
    Idiom("<jmp|jump|goto>_lbl [ {d} ]", "GOTO {d}", "FANUC"),
    Idiom("if {e} , <jmp|jump|goto>_lbl [ {d} ]", "IF {e} GOTO {d}", "FANUC"),
    Idiom("if {e} , call_{r}", "IF {e} THEN\n    CALL {r}\nEND", "FANUC"),
    Idiom("wait {d} ( sec )", "DELAY {d}", "FANUC", note="WAIT takes a condition, DELAY a time in seconds"),
    # ABB
    Idiom("<waitdi|wait_di> <di_|di|in|input|> {d} , <on|true|1|high>", "WAIT SIG({d+1000})", "RAPID"),
    Idiom("<waitdi|wait_di> <di_|di|in|input|> {d} , <off|false|0|low>", "WAIT SIG(-{d+1000})", "RAPID"),
    Idiom("<waitdi|wait_di>_{n} , <off|false|0|low>", "", "RAPID", help="write `WAIT SIG(-1001)`, with the number of that input", note=_NUMBERED),
    Idiom("<waitdi|wait_di>_{n} {r}", "", "RAPID", help="write `WAIT SIG(1001)`, with the number of that input", note=_NUMBERED),
    Idiom("<waitdo|wait_do> <do_|do|out|output|> {d} , <on|true|1|high>", "WAIT SIG({d})", "RAPID"),
    Idiom("<waitdo|wait_do> <do_|do|out|output|> {d} , <off|false|0|low>", "WAIT SIG(-{d})", "RAPID"),
    Idiom("<waitdo|wait_do>_{n} {r}", "", "RAPID", help="write `WAIT SIG(1)`, with the number of that output", note=_NUMBERED),
    Idiom("pulsedo <\\high ,|> <\\plength := |> {d} , {n}", "", "RAPID", help="write `SIGNAL 3`, `DELAY {d}`, `BREAK` and `SIGNAL -3`, each on a line of its own, with the number of that output", note=_NUMBERED),
    Idiom("pulsedo_<do_|do|> {d}", "", "RAPID", help="write `SIGNAL {d}`, `DELAY 0.2`, `BREAK` and `SIGNAL -{d}`, each on a line of its own"),
    Idiom("pulsedo {r}", "", "RAPID", help="write `SIGNAL 3`, `DELAY 0.2`, `BREAK` and `SIGNAL -3`, each on a line of its own, with the number of that output", note=_NUMBERED),
    Idiom("<setdo|set_do>_{n} , <on|true|1|high>", "", "RAPID", help="write `SIGNAL 3`, with the number of that output", note=_NUMBERED),
    Idiom("<setdo|set_do>_{n} , <off|false|0|low>", "", "RAPID", help="write `SIGNAL -3`, with the number of that output", note=_NUMBERED),
    Idiom("set_<do_|do|out|output>{d}", "SIGNAL {d}", "RAPID"),
    Idiom("reset_<do_|do|out|output>{d}", "SIGNAL -{d}", says="RESET takes nothing behind it: it switches all outputs off"),
    Idiom("set_<do_|do|out_>{n}", "", "RAPID", help="to switch an output on write `SIGNAL 3`, with its number", note=_NUMBERED),
    Idiom("reset_<do_|do|out_>{n}", "", says="RESET takes nothing behind it: it switches all outputs off", help="to switch an output off write `SIGNAL -3`, with its number", note=_NUMBERED),
    Idiom("accset {r}", "", "RAPID", help="leave it out: VAL-II has no such setting", drop=True),
    Idiom("<confl|confj|singarea> {r}", "", "RAPID", help="leave it out: VAL-II has no such setting", drop=True),
    # KUKA
    Idiom(_LINE + "_{v}_<c_vel|c_dis|c_ori|cont|c_spl>", "MOVES {v}", "KRL", note=_FINE),
    Idiom(_JOINT + "_{v}_<c_ptp|c_vel|c_dis|cont>", "MOVE {v}", "KRL", note=_FINE),
    Idiom(_LINE + "_{v}_<cont|> <vel|v> = {d} {r}", "", "KRL", help="write `MOVES {v}`, and the speed in the line before: `SPEED 200 MMPS`"),
    Idiom(_JOINT + "_{v}_<cont|> <vel|v> = {d} {r}", "", "KRL", help="write `MOVE {v}`, and the speed in the line before: `SPEED {d}`"),
    Idiom(_LINE + " { {r} }", "", "KRL", help="write `MOVES TRANS(x, y, z, o, a, t)`, with the numbers alone"),
    Idiom(_JOINT + " { {r} }", "", "KRL", help="write `MOVE TRANS(x, y, z, o, a, t)`, with the numbers alone; for joints `MOVE #PPOINT(j1, j2, j3, j4, j5, j6)`"),
    Idiom("<lin_rel|ptp_rel|linrel|slin_rel> {r}", "", "KRL", help="write `DRAW dx, dy, dz`: how far to go along X, Y and Z"),
    Idiom("pulse ( {r} )", "", "KRL", help="write `SIGNAL 3`, `DELAY 0.5`, `BREAK` and `SIGNAL -3`, each on a line of its own"),
    Idiom("bas ( {r} )", "", "KRL", help="leave it out, and set the speed by `SPEED 50 ALWAYS`"),
    # switches by their names
    Idiom("<cp|autostop|dry.run|wait.text|switch_cp> = <on|true|1>", "ENABLE CP", says="a switch of the system is turned on by ENABLE"),
    Idiom("<switch|> cp_<on|true>", "ENABLE CP", says="a switch of the system is turned on by ENABLE"),
    Idiom("<switch|> cp_<off|false>", "DISABLE CP", says="a switch of the system is turned off by DISABLE"),
)
