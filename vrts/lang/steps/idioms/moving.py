"""Motions as other robot languages and beginners write them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_JOINT = "<movej|move_j|ptp|jmove|jmov|move_ptp|move_joint|moveptp|moveto|move_to|movetcp|goto_point|move_absj|moveabsj|jump|movep>"
_LINE = "<movel|move_l|lin|lmove|lmov|movelin|move_lin|move_line|move_linear|moveline|linear|mvs|straight|move_straight|moves_to|movs>"

_PARTS = "<elbow|arm|shoulder|wrist|hand|robot|config|configuration|set_config|set|pose>"
_ON = "<on|always_on|true|1|elbow|arm|shoulder|wrist|config|mode>"
_BRANCHES = {  # what else the words of the arm's branch are called
    "ABOVE": (f"{_PARTS} <=|:|> <above|up>", f"above {_ON}", "<elbow_up|elbowup|up_elbow>"),
    "BELOW": (f"{_PARTS} <=|:|> <below|down>", f"below {_ON}", "<elbow_down|elbowdown>"),
    "LEFTY": (f"{_PARTS} <=|:|> <lefty|left>", f"lefty {_ON}", "<left_arm|lefthand|left_hand>"),
    "RIGHTY": (f"{_PARTS} <=|:|> <righty|right>", f"righty {_ON}", "<right_arm|righthand>"),
    "FLIP": (f"{_PARTS} <=|:|> flip", f"flip {_ON}"),
    "NOFLIP": (f"{_PARTS} <=|:|> <noflip|no_flip>", f"noflip {_ON}", "flip <off|false|0>"),
}

MOVING = (
    Idiom("move_<from|> {v}_to_{v2}", "MOVE {v}\nMOVE {v2}", says="MOVE takes one location, and no TO"),
    Idiom("moves_<from|> {v}_to_{v2}", "MOVES {v}\nMOVES {v2}", says="MOVES takes one location, and no TO"),
    Idiom("move_{v} , {d} , {d2} , {d3}", "MOVE SHIFT({v} BY {d}, {d2}, {d3})", says="MOVE takes the location alone"),
    Idiom("moves_{v} , {d} , {d2} , {d3}", "MOVES SHIFT({v} BY {d}, {d2}, {d3})", says="MOVES takes the location alone"),
    Idiom("move_{v}_by_{e} , {e2} , {e3}", "MOVE SHIFT({v} BY {e}, {e2}, {e3})", says="MOVE takes the location alone: SHIFT moves it"),
    Idiom("moves_{v}_by_{e} , {e2} , {e3}", "MOVES SHIFT({v} BY {e}, {e2}, {e3})", says="MOVES takes the location alone: SHIFT moves it"),
    Idiom("move_{v} <straight|linear|in_a_line|lin|straight_line>", "MOVES {v}", says="MOVES moves along a straight line"),
    Idiom("move_to_{e} , {e2}", "APPRO {e}, {e2}", says="MOVE takes the location alone", sure=False),
    Idiom("<move|moves>_<to|the|at> ( {v} )", "MOVE {v}", says="MOVE takes the location alone"),
    Idiom("move_<to|at>_{e}", "MOVE {e}", says="MOVE takes the location alone"),
    Idiom("moves_<to|at>_{e}", "MOVES {e}", says="MOVES takes the location alone"),
    Idiom("move_<straight|linear|line|lin|s|l>_<to|> {e}", "MOVES {e}", says="MOVES moves along a straight line"),
    Idiom("move_<joint|ptp|j>_<to|> {e}", "MOVE {e}", says="MOVE takes the location alone"),
    Idiom("move = {e}", "MOVE {e}", says="MOVE takes no `=`"),
    Idiom("moves = {e}", "MOVES {e}", says="MOVES takes no `=`"),
    Idiom("move : {e}", "MOVE {e}", says="MOVE takes no colon"),
    Idiom("move_{s}", "", says="a location is named without quotes", help="leave the quotes out"),
    Idiom("move , {e}", "MOVE {e}", says="MOVE takes no comma first"),
    Idiom("<moves|move> {v} , {d} %", "", says="MOVE takes the location alone", help="write `SPEED {d}` before it"),
    *(
        Idiom(f"{word.lower()}_{{v}} , {{v2}} , {{v3}}{more}", f"{word} {{v}}\n{word} {{v2}}\n{word} {{v3}}{then}", says=f"{word} takes one location", help=f"write each on a line of its own: `{word} {{v}}`, `{word} {{v2}}`, `{word} {{v3}}`{also}; for one location by its numbers `{word} TRANS(x, y, z, o, a, t)`", sure=False)
        for word in ("MOVE", "MOVES")
        for more, then, also in (("", "", ""), (" , {v4}", f"\n{word} {{v4}}", f", `{word} {{v4}}`"))
    ),
    Idiom("move_{v} , {d}", "APPRO {v}, {d}", says="MOVE takes the location alone, and no distance", help="to stop short of a location use `APPRO {v}, {d}`; SPEED sets the speed", sure=False),
    Idiom("moves_{v} , {d}", "APPROS {v}, {d}", says="MOVES takes the location alone", help="to stop short of a location use `APPROS {v}, {d}`; SPEED sets the speed", sure=False),
    Idiom("move_{v} <at|with|speed|at_speed|with_speed> {r}", "", says="MOVE takes the location alone", help="set the speed in the line before: `SPEED 50`"),
    Idiom("moves_{v} <at|with|speed|at_speed|with_speed> {r}", "", says="MOVES takes the location alone", help="set the speed in the line before: `SPEED 50`"),
    Idiom(_JOINT + " ( {v} )", "MOVE {v}", "other robot languages"),
    Idiom(_LINE + " ( {v} )", "MOVES {v}", "other robot languages"),
    Idiom(_JOINT + "_{v}", "MOVE {v}", "other robot languages"),
    Idiom(_LINE + "_{v}", "MOVES {v}", "other robot languages"),
    Idiom(_JOINT + "_{v} , {r}", "", "other robot languages", help="write `MOVE {v}`, and the speed in the line before: `SPEED 50`"),
    Idiom(_JOINT + " ( {v} , {r} )", "", "other robot languages", help="write `MOVE {v}`, and the speed in the line before: `SPEED 50`"),
    Idiom(_LINE + "_{v} , {r}", "", "other robot languages", help="write `MOVES {v}`, and the speed in the line before: `SPEED 50`"),
    Idiom(_LINE + " ( {v} , {r} )", "", "other robot languages", help="write `MOVES {v}`, and the speed in the line before: `SPEED 50`"),
    Idiom("<circ|movec|arc|circle|move_c>_{r}", "", "other robot languages", help="VAL-II has no arcs: compute points on the arc and MOVES to them"),
    Idiom("<circ|movec|arc|circle> ( {r} )", "", "other robot languages", help="VAL-II has no arcs: compute points on the arc and MOVES to them"),
    Idiom("<g0|g00>_{r}", "", "G-code", help="write `MOVE TRANS(x, y, z, o, a, t)`"),
    Idiom("<g1|g01>_{r}", "", "G-code", help="write `MOVES TRANS(x, y, z, o, a, t)`"),
    Idiom("<g28|g30>", "READY", "G-code", sure=False),
    Idiom("<m2|m02|m30>", "", "G-code", help="leave it out: the program ends at `.END`", drop=True),
    Idiom("<g20|g21|g90|g91|m3|m03|m4|m5|m05|m6>_{r}", "", "G-code", help="VAL-II has no such word: leave it out"),
    Idiom("<g20|g21|g90|g91|m3|m03|m4|m5|m05|m6>", "", "G-code", help="VAL-II has no such word: leave it out"),
    Idiom("goto_{n}", "", habit="names of labels", help="labels are whole numbers; to move to a location write `MOVE {n}`"),
    Idiom("<go|goto>_<to|>_{n}", "MOVE {n}", "other languages", sure=False),
    Idiom("<home|go_home|gohome|move_home|movehome|move_to_home|movetohome|park|rest|origin|homing|zero|go_ready|move_ready|init> <(|> <)|>", "READY", "other robot languages"),
    Idiom("move_{v} , {n}", "MOVE {v}\nMOVE {n}", says="MOVE takes one location", sure=False),
    Idiom("moves_{v} , {n}", "MOVES {v}\nMOVES {n}", says="MOVES takes one location", sure=False),
    *(
        Idiom(pattern, word, says=f"{word} stands alone")
        for word, patterns in _BRANCHES.items()
        for pattern in patterns
    ),
    *(
        Idiom(f"move_{{v}}_{word.lower()}", f"{word}\nMOVE {{v}}", says="MOVE takes one location", help=f"a setting stands on the line before the motion it is for: `{word}`, `MOVE {{v}}`")
        for word in ("LEFTY", "RIGHTY", "ABOVE", "BELOW", "FLIP", "NOFLIP", "FINE", "COARSE")
    ),
    Idiom("move_{v}_{n}", "", says="MOVE takes one location", help="if `{v}_{n}` is meant as one name, write it as one word; else give each a line of its own: `MOVE {v}`, `MOVE {n}`"),
)
