"""The words of RAPID, as ABB's controllers have them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_OF = "RAPID"
_NO_SETTING = "leave it out: VAL-II has no such setting"
_NO_TYPES = "variables of VAL-II need no declaration: the first value makes them"
_NUMBERED = "signals of VAL-II have numbers: outputs from 1, inputs from 1001"
_ZONES = "motions run into each other while CP is on; a motion stops at its end where FINE and BREAK stand"
_DATA = "<num|bool|string|dnum|robtarget|jointtarget|tooldata|wobjdata|speeddata|zonedata|loaddata|pos|orient|pose|intnum|clock|signaldi|signaldo|confdata|extjoint|byte|errnum|triggdata>"
_KEPT = "<const|pers|var|local_const|local_pers|local_var|task_pers|global_var|local>"
_SIX = "{d} , {d2} , {d3} , {d4} , {d5} , {d6}"
_ZONE = "<fine|z0|z1|z5|z10|z15|z20|z30|z40|z50|z60|z80|z100|z150|z200>"
_REACTS = "write `REACTI 1001, program`: that program is called when input 1 comes on"
_JOINT = "<movej|move_j>"
_LINE = "<movel|move_l>"

RAPID = (
    # the terminal
    Idiom("tpreadnum_{v} , {s}", "PROMPT {s}, {v}", _OF),
    Idiom("<tpreadfk|tpreaddnum>_{v} , {s} {r}", "PROMPT {s}, {v}", _OF, help="VAL-II has no keys to choose from, it asks for a number: write `PROMPT {s}, {v}`", sure=False),
    Idiom("<tpreadnum|tpreadfk|tpreaddnum|uinumentry|uialphaentry> {r}", "", _OF, help='write `PROMPT "text", n`'),
    Idiom("<tperase|tpshow {r}>", "", _OF, help="leave it out: VAL-II does not clear the terminal", drop=True),
    Idiom("tpwrite {s} <\\|,> <num|dnum|bool|pos|orient> := {e}", "TYPE {s}, {e}", _OF),
    Idiom("<uimsgbox|uimessagebox> <(|> {s} {r}", "", _OF, help="write `TYPE {s}`, or `PAUSE {s}` to wait for the operator, too"),
    Idiom("<errwrite|errlog> {s} , {s2} {r}", "", _OF, help="write `TYPE {s}, {s2}`"),
    # waiting and signals
    Idiom("<waittime|wait_time> \\ inpos , {e}", "BREAK\nDELAY {e}", _OF, sure=False),
    Idiom("waitrob {r}", "BREAK", _OF, note="BREAK waits for the end of the motion"),
    Idiom("<setdo|set_do>_<do_|do> {d} , <on|true|1|high>", "SIGNAL {d}", _OF),
    Idiom("<setdo|set_do>_<do_|do> {d} , <off|false|0|low>", "SIGNAL -{d}", _OF),
    Idiom("<setgo|setao|set_ao|set_go>_{n} , {e}", "", _OF, help="for several signals at once write `BITS 1, 4 = {e}`, for an analog output `DAC 1 = {e}`, with its number", note=_NUMBERED),
    Idiom("invertdo_{r}", "", _OF, help="ask for the output, and set it: `IF SIG(1) THEN`, `SIGNAL -1`, `ELSE`, `SIGNAL 1`, `END`, with its number", note=_NUMBERED),
    Idiom("pulsedo \\ plength := {e} , <do_|do> {d}", "SIGNAL {d}\nDELAY {e}\nBREAK\nSIGNAL -{d}", _OF, sure=False),
    Idiom("pulsedo \\ plength := {e} , {n}", "", _OF, help="write `SIGNAL 3`, `DELAY {e}`, `BREAK` and `SIGNAL -3`, each on a line of its own, with the number of that output", note=_NUMBERED),
    # clocks
    Idiom("<clkreset|clkstart>_<clock_|clock|clk|timer|t> {d}", "TIMER {d} = 0", _OF, note="a timer counts on from what it is given"),
    Idiom("<clkreset|clkstart>_{n}", "TIMER 1 = 0", _OF, note="a timer counts on from what it is given"),
    Idiom("clkstop_{n}", "", _OF, help="leave it out: a timer counts on, and `TIMER(1)` reads it", drop=True),
    # motions
    Idiom(_JOINT + "_offs ( {v} , {e} , {e2} , {e3} ) , v{d} , {r}", "", _OF, help="write `MOVE SHIFT({v} BY {e}, {e2}, {e3})`, and the speed in the line before: `SPEED {d} MMPS`"),
    Idiom(_LINE + "_offs ( {v} , {e} , {e2} , {e3} ) , v{d} , {r}", "", _OF, help="write `MOVES SHIFT({v} BY {e}, {e2}, {e3})`, and the speed in the line before: `SPEED {d} MMPS`"),
    Idiom(_JOINT + "_offs ( {v} , {e} , {e2} , {e3} )", "MOVE SHIFT({v} BY {e}, {e2}, {e3})", _OF),
    Idiom(_LINE + "_offs ( {v} , {e} , {e2} , {e3} )", "MOVES SHIFT({v} BY {e}, {e2}, {e3})", _OF),
    Idiom("<move|movej>_offs ( {v} , {e} , {e2} , {e3} ) {r}", "MOVE SHIFT({v} BY {e}, {e2}, {e3})", _OF, sure=False),
    Idiom("<moves|movel>_offs ( {v} , {e} , {e2} , {e3} ) {r}", "MOVES SHIFT({v} BY {e}, {e2}, {e3})", _OF, sure=False),
    Idiom(_JOINT + "_reltool ( {v} , {e} , {e2} , {e3} <)|\\ {r} )> {r2}", "", _OF, help="write `MOVE {v}:TRANS({e}, {e2}, {e3}, 90, -90, 0)`; to stop before a location write `APPRO {v}, 50`"),
    Idiom(_LINE + "_reltool ( {v} , {e} , {e2} , {e3} <)|\\ {r} )> {r2}", "", _OF, help="write `MOVES {v}:TRANS({e}, {e2}, {e3}, 90, -90, 0)`; to stop before a location write `APPROS {v}, 50`"),
    Idiom(_JOINT + "_{v} , v{d} , {r}", "", _OF, help="write `MOVE {v}`, and the speed in the line before: `SPEED {d} MMPS`", note=_ZONES),
    Idiom(_LINE + "_{v} , v{d} , {r}", "", _OF, help="write `MOVES {v}`, and the speed in the line before: `SPEED {d} MMPS`", note=_ZONES),
    Idiom(_LINE + "_{v} , {n} , " + _ZONE + " {r}", "", _OF, help="write `MOVES {v}`, and the speed in the line before: `SPEED 100 MMPS`", note=_ZONES),
    Idiom("<moveabsj|move_absj> [ [ " + _SIX + " ] {r}", "MOVE #PPOINT({d}, {d2}, {d3}, {d4}, {d5}, {d6})", _OF, sure=False),
    Idiom("<moveabsj|move_absj> \\ {r} {v} , v{d} , {r2}", "", _OF, help="write `MOVE {v}`, and the speed in the line before: `SPEED {d} MMPS`"),
    Idiom("<moveabsj|move_absj> {r}", "", _OF, help="write `MOVE #part` for a precision point, or `MOVE #PPOINT(j1, j2, j3, j4, j5, j6)` for the angles of the joints"),
    Idiom("<searchl|searchj|searchc> {r}", "", _OF, help="begin the motion, and watch the signal: `REACTI 1001, found` before `MOVES part`, with the steps for where it comes in a program `found`"),
    Idiom("<triggl|triggj|triggio|triggequip> {r}", "", _OF, help="write `SIGNAL 3` between two motions: it is set when the first has ended, with `BREAK` before it"),
    Idiom("move_{v} , v{d} , {r}", "", says="MOVE takes the location alone", help="write `MOVE {v}`, and the speed in the line before: `SPEED {d} MMPS`", note=_ZONES),
    Idiom("moves_{v} , v{d} , {r}", "", says="MOVES takes the location alone", help="write `MOVES {v}`, and the speed in the line before: `SPEED {d} MMPS`", note=_ZONES),
    Idiom("move_{v} <,|> v{d}", "SPEED {d} MMPS\nMOVE {v}", says="MOVE takes the location alone", sure=False),
    Idiom("moves_{v} <,|> v{d}", "SPEED {d} MMPS\nMOVES {v}", says="MOVES takes the location alone", sure=False),
    Idiom("move_{v} , fine", "FINE\nMOVE {v}", says="MOVE takes the location alone"),
    Idiom("moves_{v} , fine", "FINE\nMOVES {v}", says="MOVES takes the location alone"),
    Idiom("move_{v} <,|> z{d}", "MOVE {v}", says="MOVE takes the location alone, and no zone", note=_ZONES),
    Idiom("moves_{v} <,|> z{d}", "MOVES {v}", says="MOVES takes the location alone, and no zone", note=_ZONES),
    # places and declarations
    Idiom("{n} := <crobt|curpos|cpos> ( {r} )", "SET {n} = HERE", _OF),
    Idiom("{n} := cjointt ( {r} )", "SET #{n} = #HERE", _OF, note="the name of a precision point begins with `#`"),
    Idiom("{n} := offs ( {v} , {e} , {e2} , {e3} )", "SET {n} = SHIFT({v} BY {e}, {e2}, {e3})", _OF),
    Idiom(_KEPT + "_robtarget_{v} := [ [ {d} , {d2} , {d3} ] {r}", "", says="VAL-II has no declarations", help="write `SET {v} = TRANS({d}, {d2}, {d3}, o, a, t)`, with the angles of the hand in degrees"),
    Idiom(_KEPT + "_jointtarget_{v} := [ [ " + _SIX + " ] {r}", "SET #{v} = #PPOINT({d}, {d2}, {d3}, {d4}, {d5}, {d6})", says="VAL-II has no declarations", sure=False),
    Idiom(_KEPT + "_string_{n} := {s}", "${n} = {s}", says="VAL-II has no declarations", note="the name of a string begins with `$`"),
    Idiom(_KEPT + "_<num|bool|dnum|byte|intnum>_{v} := {e}", "{v} = {e}", says="VAL-II has no declarations", note=_NO_TYPES),
    Idiom(_KEPT + "_" + _DATA + "_{v} := {r}", "", says="VAL-II has no declarations", help="leave it out: a location gets its values by `SET {v} = TRANS(x, y, z, o, a, t)` or in `.LOCATIONS`", note=_NO_TYPES),
    Idiom(_KEPT + "_" + _DATA + "_{v}", "", says="VAL-II has no declarations", help="leave it out", note=_NO_TYPES, drop=True),
    Idiom("<robtarget|jointtarget|tooldata|wobjdata|speeddata|zonedata>_{v}", "", says="VAL-II has no declarations", help="leave it out", note=_NO_TYPES, drop=True),
    # numbers
    Idiom("add_{v} , {e}", "{v} = {v}+{e}", _OF),
    Idiom("clear_<all|vars|variables>", "", "MATLAB", help="leave it out: variables of VAL-II stay", drop=True),
    Idiom("clear_{v}", "{v} = 0", _OF),
    # settings, interrupts and the rest
    Idiom("velset_{d} , {r}", "SPEED {d} ALWAYS", _OF),
    Idiom("<gripload|mechunitload|pathacclim|cornerpathwarning|softact|softdeact|worldacclim|stoppointdata> {r}", "", _OF, help=_NO_SETTING, drop=True),
    Idiom("connect_{n}_with_{n2}", "", _OF, help="write `REACTI 1001, {n2}`, with the signal: the program `{n2}` is called when it comes on"),
    Idiom("isignaldi <\\ single ,|> <di_|di> {d} , <1|high> , {n}", "", _OF, help="write `REACTI {d+1000}, program`: that program is called when the input comes on", note=_NUMBERED),
    Idiom("<isignaldi|isignaldo|itimer|iwatch|ienable> {r}", "", _OF, help=_REACTS, note=_NUMBERED),
    Idiom("<idelete|isleep|idisable> {r}", "", _OF, help="write `IGNORE 1001`: that input is watched no longer", note=_NUMBERED),
    Idiom("trap_{n}", "", _OF, help="write the steps as a program of their own, `.PROGRAM {n}`, and `REACTI 1001, {n}` for the signal that calls it"),
    Idiom("exitcycle", "", _OF, help="to begin again jump to a label at the first step: `GOTO 10`; HALT ends the execution"),
    Idiom("<module|sysmodule>_{n} {r}", "", _OF, help="leave it out: a file has its programs one behind the other", drop=True),
    Idiom("<endmodule|endtrap|endrecord>", "", _OF, help="leave it out: a program ends with `.END`", drop=True),
    Idiom("<trynext|retry|stopmove|startmove|storepath|restopath> {r}", "", _OF, help="VAL-II has none: `REACTE program` calls a program when a step fails, BRAKE stops the motion"),
)
