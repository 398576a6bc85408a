"""The words of KRL, as KUKA's controllers have them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_OF = "KRL"
_NO_TYPES = "variables of VAL-II need no declaration: the first value makes them"
_STANDS = "a program named behind REACTI is called when its signal changes"
_KUKA = "<e6pos|e6axis|pos|axis|frame|int|real|bool|char|signal|struc|enum|ext|channel>"
_IN = "<$in|in|di>"

KRL = (
    # interrupts
    *(
        idiom
        for begins in ("interrupt_decl", "global_interrupt_decl")
        for idiom in (
            Idiom(begins + " {d}_when " + _IN + " [ {d2} ] <==|=> <true|1>_do_{n} <( )|>", "REACTI {d2+1000}, {n}", _OF, note=_STANDS),
            Idiom(begins + " {d}_when " + _IN + " [ {d2} ]_do_{n} <( )|>", "REACTI {d2+1000}, {n}", _OF, note=_STANDS),
            Idiom(begins + " {d}_when " + _IN + " [ {d2} ] <==|=> <false|0>_do_{n} <( )|>", "REACTI -{d2+1000}, {n}", _OF, note=_STANDS),
            Idiom(begins + " {d}_when_not " + _IN + " [ {d2} ]_do_{n} <( )|>", "REACTI -{d2+1000}, {n}", _OF, note=_STANDS),
            Idiom(begins + " {r}_do_{n} <( )|>", "", _OF, help="write `REACTI 1001, {n}`, with the number of the signal", note=_STANDS),
        )
    ),
    Idiom("interrupt_<off|disable> {r}", "", _OF, help="write `IGNORE 1001`, with the number of the signal: it is watched no longer"),
    Idiom("interrupt_<on|enable> {r}", "", _OF, help="leave it out: REACTI watches its signal from there on", drop=True),
    Idiom("interrupt {r}", "", _OF, help="write `REACTI 1001, program`, with the number of the signal", note=_STANDS),
    Idiom("trigger_when {r}", "", _OF, help="write `SIGNAL 3` between two motions, with `BREAK` before it: it is set where the first one ends"),
    # motions
    Idiom("sptp_{v}", "MOVE {v}", _OF),
    Idiom("<slin|lin_abs>_{v}", "MOVES {v}", _OF),
    Idiom("<sptp_rel|slin_rel> {r}", "", _OF, help="write `DRAW dx, dy, dz`: how far to go along X, Y and Z"),
    Idiom("<scirc|circ_rel|spl|spline|endspline> {r}", "", _OF, help="VAL-II has no arcs: compute points on the arc and MOVES to them"),
    Idiom("<ptp|sptp|movej> { a1 {d} , a2 {d2} , a3 {d3} , a4 {d4} , a5 {d5} , a6 {d6} <}|, e1 {r} }>", "MOVE #PPOINT({d}, {d2}, {d3}, {d4}, {d5}, {d6})", _OF, help="write `MOVE #PPOINT({d}, {d2}, {d3}, {d4}, {d5}, {d6})`", sure=False),
    Idiom("move_{v}_<c_ptp|c_dis|c_vel|c_ori|c_spl>", "MOVE {v}", says="MOVE takes the location alone", note="motions run into each other while CP is on"),
    Idiom("moves_{v}_<c_ptp|c_dis|c_vel|c_ori|c_spl>", "MOVES {v}", says="MOVES takes the location alone", note="motions run into each other while CP is on"),
    # signals and channels
    Idiom("pulse ( $out [ {d} ] , true , {e} )", "SIGNAL {d}\nDELAY {e}\nBREAK\nSIGNAL -{d}", _OF, sure=False),
    Idiom("pulse ( $out [ {d} ] , false , {e} )", "SIGNAL -{d}\nDELAY {e}\nBREAK\nSIGNAL {d}", _OF, sure=False),
    Idiom("$out [ {v} ] = <true|on|1>", "SIGNAL {v}", _OF),
    Idiom("$out [ {v} ] = <false|off|0>", "SIGNAL -{v}", _OF),
    Idiom("anin_on_{v} = {r}", "", _OF, help="write `{v} = ADC(1)`, with the number of the channel"),
    Idiom("anin_off {r}", "", _OF, help="leave it out: `ADC(1)` reads a channel when it is asked", drop=True),
    Idiom("<anin|digin> {r}", "", _OF, help="write `x = ADC(1)` for an analog input, `n = BITS(1001, 8)` for digital ones"),
    Idiom("anout {r}", "", _OF, help="write `DAC 1 = x`, with the number of the channel"),
    # declarations and frames of a file
    Idiom("<decl|global_decl|decl_global>_<int|real|bool|char>_{v} = {e}", "{v} = {e}", says="VAL-II has no declarations", note=_NO_TYPES),
    Idiom("<decl|global_decl|decl_global>_{n}_{v} = { {r}", "", says="VAL-II has no declarations", help="write `SET {v} = TRANS(x, y, z, o, a, t)`, with the numbers alone"),
    Idiom("decl_" + _KUKA + "_{r}", "", says="VAL-II has no declarations", help="leave it out", note=_NO_TYPES, drop=True),
    Idiom("<global_decl|decl_global|decl>_{r}", "", says="VAL-II has no declarations", help="leave it out", note=_NO_TYPES, drop=True),
    Idiom("<e6pos|e6axis>_{r}", "", says="VAL-II has no declarations", help="leave it out", note=_NO_TYPES, drop=True),
    Idiom("<struc|struct|enum>_{r}", "", says="VAL-II has no types of one's own", help="leave it out: give each value a name of its own, or an array"),
    Idiom("<ext|extfct>_{r}", "", _OF, help="leave it out: all programs of a file know each other", drop=True),
    Idiom("deffct_{n}_{n2} ( {r} )", "", _OF, help="write `.PROGRAM {n2}(a, result)`, and CALL it: a program gives its result to an argument"),
    Idiom("defdat_{r}", "", _OF, help="leave it out: data stand in `.LOCATIONS` and `.REALS` below the programs"),
    Idiom("<ini|enddat>", "", _OF, help="leave it out", drop=True),
    Idiom("&{n} {r}", "", _OF, help="leave it out: a program begins with `.PROGRAM name`", drop=True),
    Idiom("resume", "", _OF, help="write `RETURN` at the end of the program that a signal calls"),
)
