"""The words of TP programs and of Karel, as FANUC's controllers have them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_OF = "FANUC"
_RUNS_ON = "motions run into each other while CP is on"
_NUMBERED = "signals of VAL-II have numbers: outputs from 1, inputs from 1001"
_MM = "<mm / sec|mm / s|mm>"

KAREL = (
    # what stands behind a motion
    Idiom("move_{v} <,|> cnt {d}", "MOVE {v}", says="MOVE takes the location alone", note=_RUNS_ON),
    Idiom("moves_{v} <,|> cnt {d}", "MOVES {v}", says="MOVES takes the location alone", note=_RUNS_ON),
    Idiom("move_{v} {d} % {r}", "", says="MOVE takes the location alone", help="write `MOVE {v}`, and the speed in the line before: `SPEED {d}`"),
    Idiom("move_{v} {d} " + _MM + " {r}", "", says="MOVE takes the location alone", help="write `MOVE {v}`, and the speed in the line before: `SPEED {d} MMPS`"),
    Idiom("moves_{v} {d} " + _MM + " {r}", "", says="MOVES takes the location alone", help="write `MOVES {v}`, and the speed in the line before: `SPEED {d} MMPS`"),
    Idiom("cnt {d}", "", _OF, help="leave it out: motions run into each other while CP is on", drop=True),
    Idiom("move_to_{v}_nowait", "MOVE {v}", "Karel"),
    Idiom("move_along_{v}", "", "Karel", help="VAL-II has no paths: write a loop over an array, `FOR i = 1 TO n`, `MOVE {v}[i]`, `END`"),
    Idiom("move_<near|away|about|relative|axis> {r}", "", "Karel", help="write `APPRO part, 50` to stop before a location, `DEPART 50` to go away, `DRIVE joint, change, speed` for one joint"),
    Idiom("with_$speed = {d}_move_to_{v}", "SPEED {d} MMPS\nMOVE {v}", "Karel", sure=False),
    Idiom("with_{r}_move_to_{v}", "MOVE {v}", "Karel", sure=False),
    Idiom("open_hand_{d}", "OPENI", "Karel"),
    Idiom("close_hand_{d}", "CLOSEI", "Karel"),
    Idiom("relax_hand_{d}", "RELAXI", "Karel"),
    # the terminal
    Idiom("message [ \"{t}\" ]", "TYPE \"{t}\"", _OF),
    Idiom("message [ {r} ]", "TYPE \"{r}\"", _OF),
    Idiom("<write|writeln> ( {s} , cr )", "TYPE {s}", "Karel"),
    Idiom("<write|writeln> ( {s} , {e} , cr )", "TYPE {s}, {e}", "Karel"),
    Idiom("<write|writeln> ( cr )", "TYPE", "Karel"),
    Idiom("ualm [ {r} ]", "", _OF, help='write `HALT "text"`, which ends the execution with that text'),
    # pulses, conditions and the rest
    Idiom("pulse_dout [ {d} ]_for_{d2} {r}", "", "Karel", help="write `SIGNAL {d}`, `DELAY 0.5`, `BREAK` and `SIGNAL -{d}`, each on a line of its own, with the time in seconds"),
    Idiom("skip_condition {r}", "", _OF, help="write `REACTI 1001, program` before the motion, with the signal: it stops the motion, and calls the program"),
    Idiom("<condition [ {r} ]|global_condition [ {r} ]> {r2}", "", "Karel", help="write `REACTI 1001, program`, with the signal: that program is called when it comes on"),
    Idiom("<enable|disable|purge>_condition [ {r} ]", "", "Karel", help="`REACTI 1001, program` watches a signal, `IGNORE 1001` ends that"),
    Idiom("routine_{n} {r}", "", "Karel", help="write each program between `.PROGRAM name` and `.END`"),
    Idiom("select {v} = {d} , <call|jmp> {r}", "", _OF, help="write `CASE {v} OF`, `VALUE {d}:`, the step in a line of its own, and `END`"),
    Idiom("r [ {r} : {r2} ] = {e}", "r[{r}] = {e}", _OF, sure=False),
    Idiom("<uframe|utool> [ {r} ] = {e}", "", _OF, help="write `TOOL {e}` for the tool, `BASE dx, dy, dz, rotation` for where the robot stands"),
)
