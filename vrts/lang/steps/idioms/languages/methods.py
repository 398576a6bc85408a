"""Methods of objects and lists, as Python, Java and C++ have them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_SAYS = "VAL-II has no objects, and no methods"
_LISTS = "VAL-II has no lists with methods: an array has elements, each with its index"
_ONE = "there is one arm and one hand, and their instructions stand alone"
_PLACE = "<move|movej|move_j|moveto|move_to|goto|go_to|move_joint|movejoint|move_ptp|ptp|go|move_to_pose|movetopoint|move_position|setposition|set_pose>"
_STRAIGHT = "<movel|move_l|move_linear|movelinear|move_line|move_straight|lin|moveline|linear|movetcp|move_lin>"
_SHOWN = "<print|println|printf|log|writeline|write|display|show|say|info|debug|msg|popup>"

METHODS = (
    Idiom("{n}.append ( {e} )", "", help="give an element a value by its index: `{n}[i] = {e}`", note=_LISTS),
    Idiom("{n}.<add|push|push_back|insert_last|addlast|enqueue> ( {e} )", "", help="give an element a value by its index: `{n}[i] = {e}`", note=_LISTS),
    Idiom("{n}.insert ( {e} , {e2} )", "", help="give an element a value by its index: `{n}[{e}] = {e2}`", note=_LISTS),
    Idiom("{n}.<pop|remove|delete|erase|dequeue> ( {r} )", "", help="count how many elements there are in a variable, and make it one less: `count = count-1`", note=_LISTS),
    Idiom("{n}.<sort|reverse|clear|extend|shuffle> ( {r} )", "", help="write a loop over the elements: `FOR i = 1 TO count`, with `{n}[i]` in it", note=_LISTS),
    Idiom("{n}.<open|open_gripper|opengripper|gripper_open|open_hand> ( {r} )", "OPENI", note=_ONE),
    Idiom("{n}.<close|close_gripper|closegripper|gripper_close|close_hand> ( {r} )", "CLOSEI", note=_ONE),
    Idiom("{n}." + _PLACE + " ( {v} )", "MOVE {v}", note=_ONE),
    Idiom("{n}." + _STRAIGHT + " ( {v} )", "MOVES {v}", note=_ONE),
    Idiom("{n}." + _PLACE + " ( {v} , {r} )", "", help="write `MOVE {v}`, and the speed in the line before: `SPEED 50`", note=_ONE),
    Idiom("{n}." + _STRAIGHT + " ( {v} , {r} )", "", help="write `MOVES {v}`, and the speed in the line before: `SPEED 50`", note=_ONE),
    Idiom("{n}.<approach|appro> ( {v} , {e} )", "APPRO {v}, {e}", note=_ONE),
    Idiom("{n}.<depart|retract> ( {e} )", "DEPART {e}", note=_ONE),
    Idiom("{n}.<set_speed|setspeed|speed|set_velocity|setvelocity|set_vel> ( {d} )", "SPEED {d}", note=_ONE),
    Idiom("{n}.<home|go_home|gohome|movehome|move_home|ready|init_pose> ( )", "READY", note=_ONE),
    Idiom("{n}.<stop|halt|stopj|stopl> ( {r} )", "", help="write BRAKE to stop the motion, HALT to end the execution"),
    Idiom("thread.sleep ( {d} )", "", "Java", help="DELAY takes seconds: 500 ms is `DELAY 0.5`"),
    Idiom("{n}.<sleep|wait|delay|pause|sleep_s> ( {e} )", "DELAY {e}", note=_SAYS),
    Idiom("{n}.<set_do|setdo|set_digital_out|setdigitalout|set_standard_digital_out|set_output|digital_write|setstandarddigitalout|write_digital> ( {d} , <true|1|on|high> )", "SIGNAL {d}", note=_SAYS),
    Idiom("{n}.<set_do|setdo|set_digital_out|setdigitalout|set_standard_digital_out|set_output|digital_write|setstandarddigitalout|write_digital> ( {d} , <false|0|off|low> )", "SIGNAL -{d}", note=_SAYS),
    Idiom("<sys|os|system|process|environment>.<exit|_exit|quit> ( {r} )", "HALT", note=_SAYS),
    Idiom("<system.out|system.err|console|serial|logger|log|std>.<print|println|printf|write|writeline|log> ( {s} + {e} )", "TYPE {s}, {e}", note=_SAYS),
    Idiom("<system.out|system.err|console|serial|logger|log|std>.<print|println|printf|write|writeline|log> ( {s} , {e} )", "TYPE {s}, {e}", note=_SAYS),
    Idiom("<system.out|system.err|console|serial|logger|log|std>.<print|println|printf|write|writeline|log> ( )", "TYPE", note=_SAYS),
    Idiom("{n}." + _SHOWN + " ( {s} )", "TYPE {s}", note=_SAYS),
    Idiom("{n}." + _SHOWN + " ( {s} <+|,> {e} )", "TYPE {s}, {e}", note=_SAYS),
    Idiom("{n}." + _SHOWN + " ( {v} )", "TYPE {v}", note=_SAYS),
    Idiom("debug.print_{s}", "TYPE {s}", "BASIC"),
    Idiom("debug.print_{e}", "TYPE {e}", "BASIC"),
    Idiom("serial.begin ( {r} )", "", "Arduino", help="leave it out: TYPE writes to the terminal at once", drop=True),
    Idiom("<console.readline|console.read|console.readkey|scanner.nextint|scanner.nextline> ( {r} )", "", help='write `PAUSE "text"` to wait for the operator, `PROMPT "text", n` to ask for a number'),
    Idiom("{n}.<nextint|nextline|nextdouble|readline|read|close_file> ( )", "", help='write `PROMPT "text", n`'),
)
