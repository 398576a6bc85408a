"""The words of URScript, as Universal Robots' controllers have them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_OF = "URScript"
_OUT = "<set_digital_out|set_standard_digital_out|set_configurable_digital_out|set_tool_digital_out|write_output_boolean_register|digital_out|setdigitalout|set_do>"
_SIX = "{d} , {d2} , {d3} , {d4} , {d5} , {d6}"
_PC = "a program beside the motions is begun by PCEXECUTE"

URSCRIPT = (
    Idiom(_OUT + " ( 0 , {r} )", "", _OF, help="outputs of VAL-II count from 1: write `SIGNAL 1` to switch one on, `SIGNAL -1` to switch it off"),
    Idiom(_OUT + " ( {v} , <true|1|on|high> )", "SIGNAL {v}", _OF),
    Idiom(_OUT + " ( {v} , <false|0|off|low> )", "SIGNAL -{v}", _OF),
    Idiom(_OUT + " ( {d} , <true|1|on|high> )", "SIGNAL {d}", _OF),
    Idiom(_OUT + " ( {d} , <false|0|off|low> )", "SIGNAL -{d}", _OF),
    Idiom(_OUT + " ( {e} , {e2} )", "", _OF, help="write `SIGNAL {e}` to switch it on, `SIGNAL -{e}` to switch it off"),
    Idiom("<set_analog_out|set_standard_analog_out|set_tool_analog_out|write_output_float_register> ( {e} , {e2} )", "DAC {e} = {e2}", _OF, sure=False),
    Idiom("popup ( {s} , {r} )", "TYPE {s}", _OF, help="write `TYPE {s}`, or `PAUSE {s}` to wait for the operator, too", sure=False),
    Idiom("popup ( {s} )", "TYPE {s}", _OF, help="write `TYPE {s}`, or `PAUSE {s}` to wait for the operator, too"),
    Idiom("textmsg ( {s} , {e} )", "TYPE {s}, {e}", _OF),
    Idiom("sync ( )", "", _OF, help="leave it out: VAL-II needs no such step", drop=True),
    Idiom("thread_{n} ( {r} ) <:|>", "", _OF, help="write a program of its own, `.PROGRAM {n}`, and begin it by `PCEXECUTE {n}`"),
    Idiom("thread_{n} :", "", _OF, help="write a program of its own, `.PROGRAM {n}`, and begin it by `PCEXECUTE {n}`"),
    Idiom("<run|start>_{n} ( )", "PCEXECUTE {n}", _OF, help="write `PCEXECUTE {n}`, which runs beside the motions; `CALL {n}` waits for its end", sure=False),
    Idiom("{v} = run_{n} <( )|>", "PCEXECUTE {n}", says=_PC),
    Idiom("kill_{n}", "PCABORT", says="a program beside the motions is ended by PCABORT"),
    Idiom("join_{n}", "", _OF, help="give a variable a value at the end of `{n}`, and wait for it: `WAIT done == 1`"),
    Idiom("<enter_critical|exit_critical> {r}", "", _OF, help="leave it out: VAL-II has none"),
    Idiom("<set_payload|set_payload_mass|set_payload_cog|set_gravity|set_target_payload|set_conveyor_tick_count> ( {r} )", "", _OF, help="leave it out: VAL-II has no such setting", drop=True),
    Idiom("set_tcp ( p [ {r} ] )", "", _OF, help="write `TOOL TRANS(x, y, z, o, a, t)`, in mm and degrees"),
    Idiom("<stopj|stopl|stop_j|stop_l> <( {r} )|>", "", _OF, help="write BREAK to wait for the end of the motion, BRAKE to stop it where it is"),
    Idiom("<speedj|speedl|servoj|servoc|servol|speed_j|speed_l> ( {r} )", "", _OF, help="VAL-II moves to places, not with a speed: write `MOVES part`, or `DRAW dx, dy, dz` for how far to go"),
    Idiom("<movej|move_j> ( [ " + _SIX + " ] <)|, {r} )>", "", _OF, help="write `MOVE #PPOINT(j1, j2, j3, j4, j5, j6)`, with the angles of the joints in degrees"),
    Idiom("<movej|move_j> ( [ {r}", "", _OF, help="write `MOVE #PPOINT(j1, j2, j3, j4, j5, j6)`, with the angles of the joints in degrees"),
    Idiom("<movel|move_l> ( p [ {r}", "", _OF, help="write `MOVES TRANS(x, y, z, o, a, t)`, in mm and degrees"),
    Idiom("<movej|movep|move_j|move_p> ( p [ {r}", "", _OF, help="write `MOVE TRANS(x, y, z, o, a, t)`, in mm and degrees"),
    Idiom("<movel|move_l> ( pose_trans ( {v} , p [ {r}", "", _OF, help="write `MOVES {v}:TRANS(x, y, z, 90, -90, 0)`, in mm"),
    Idiom("<movel|move_l> ( pose_trans ( {v} , {v2} ) {r}", "MOVES {v}:{v2}", _OF, sure=False),
    Idiom("<rq_open|rq_open_and_wait|open_gripper|gripper_open|opengripper|rg_open|hand_open|open_hand|openhand|gripperopen> <( {r} )|( )|>", "OPENI", "other robot languages"),
    Idiom("<rq_close|rq_close_and_wait|close_gripper|gripper_close|closegripper|rg_close|rg_grip|hand_close|close_hand|closehand|gripperclose> <( {r} )|( )|>", "CLOSEI", "other robot languages"),
    Idiom("<freedrive_mode|end_freedrive_mode|teach_mode|end_teach_mode|zero_ftsensor|end_force_mode|reset_revolution_counter> ( {r} )", "", _OF, help="leave it out: VAL-II has no such setting", drop=True),
    Idiom("force_mode ( {r} )", "", _OF, help="leave it out: VAL-II has no such setting"),
)
