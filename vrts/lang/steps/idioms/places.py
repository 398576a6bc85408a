"""Locations out of numbers, and values of locations, as beginners write them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_POINT = "TRANS({d}, {d2}, {d3}, o, a, t)"
_NUMBERS = "numbers make no location: TRANS does"
_LIST6 = "{e} , {e2} , {e3} , {e4} , {e5} , {e6}"
_SIX = "TRANS({e}, {e2}, {e3}, {e4}, {e5}, {e6})"
_UNTURNED = "with the angles of the hand behind the lengths"  # without them it points up

PLACES = (
    Idiom("set_{v} == {e}", "SET {v} = {e}", says="`==` compares, `=` gives a value"),
    Idiom("timer {d} == {e}", "TIMER {d} = {e}", says="`==` compares, `=` gives a value"),
    Idiom("<invert|inverse> {v}", "SET {v} = INVERSE({v})", says="INVERSE is a function", sure=False),
    # locations out of numbers
    Idiom("<move|goto|movet>_<to|>" + _LIST6, "MOVE " + _SIX, says=_NUMBERS),
    Idiom("move ( " + _LIST6 + " )", "MOVE " + _SIX, says=_NUMBERS),
    Idiom("move [ " + _LIST6 + " ]", "MOVE " + _SIX, says=_NUMBERS),
    Idiom("moves " + _LIST6, "MOVES " + _SIX, says=_NUMBERS),
    Idiom("moves ( " + _LIST6 + " )", "MOVES " + _SIX, says=_NUMBERS),
    Idiom("move {d} , {d2} , {d3}", "", says=_NUMBERS, help="write `MOVE " + _POINT + "`, " + _UNTURNED),
    Idiom("move ( {d} , {d2} , {d3} )", "", says=_NUMBERS, help="write `MOVE " + _POINT + "`, " + _UNTURNED),
    Idiom("move [ {d} , {d2} , {d3} ]", "", says=_NUMBERS, help="write `MOVE " + _POINT + "`, " + _UNTURNED),
    Idiom("move {d}_{d2}_{d3}", "", says=_NUMBERS, help="write `MOVE " + _POINT + "`, " + _UNTURNED),
    Idiom("moves {d} , {d2} , {d3}", "", says=_NUMBERS, help="write `MOVES " + _POINT + "`, " + _UNTURNED),
    Idiom("moves [ " + _LIST6 + " ]", "MOVES " + _SIX, says=_NUMBERS),
    Idiom("moves [ {d} , {d2} , {d3} ]", "", says=_NUMBERS, help="write `MOVES " + _POINT + "`, " + _UNTURNED),
    Idiom("moves ( {d} , {d2} , {d3} )", "", says=_NUMBERS, help="write `MOVES " + _POINT + "`, " + _UNTURNED),
    Idiom("move_<to|> x {d} <,|> y {d2} <,|> z {d3}", "", says=_NUMBERS, help="write `MOVE " + _POINT + "`, " + _UNTURNED),
    Idiom("set_{n} = " + _LIST6, "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("set_{n} = ( " + _LIST6 + " )", "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("set_{n} = [ " + _LIST6 + " ]", "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("set_{n} = { " + _LIST6 + " }", "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("{n} = { " + _LIST6 + " }", "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("<move|moves> { " + _LIST6 + " }", "MOVE " + _SIX, says=_NUMBERS, sure=False),
    Idiom("set_{n} , " + _LIST6, "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("set_{n} = {d} , {d2} , {d3}", "", says=_NUMBERS, help="write `SET {n} = " + _POINT + "`, " + _UNTURNED),
    Idiom("set_{n} = ( {d} , {d2} , {d3} )", "", says=_NUMBERS, help="write `SET {n} = " + _POINT + "`, " + _UNTURNED),
    Idiom("set_{n} = [ {d} , {d2} , {d3} ]", "", says=_NUMBERS, help="write `SET {n} = " + _POINT + "`, " + _UNTURNED),
    Idiom("<point|pos|location|pose>_{n} = trans ( {r} )", "SET {n} = TRANS({r})", "other languages"),
    Idiom("<point|location|pose|pos|position|frame|def_point|teach>_{n} = " + _LIST6, "SET {n} = " + _SIX, "other languages"),
    Idiom("{n} = ( " + _LIST6 + " )", "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("{n} = [ " + _LIST6 + " ]", "SET {n} = " + _SIX, "MATLAB and Python"),
    Idiom("{n} = ( {d} , {d2} , {d3} )", "", says=_NUMBERS, help="write `SET {n} = " + _POINT + "`, " + _UNTURNED),
    Idiom("{n} = [ {d} , {d2} , {d3} ]", "", says="VAL-II has no lists in `[`", help="for an array give each element a line: `{n}[0] = {d}`, `{n}[1] = {d2}`, `{n}[2] = {d3}`; for a location write `SET {n} = " + _POINT + "`, " + _UNTURNED),
    Idiom("{n} = [ {d} , {d2} ]", "{n}[0] = {d}\n{n}[1] = {d2}", says="VAL-II has no lists in `[`", sure=False, help="give each element a line: `{n}[0] = {d}`, `{n}[1] = {d2}`"),
    Idiom("{n} = [ {d} , {d2} , {d3} , {d4} ]", "{n}[0] = {d}\n{n}[1] = {d2}\n{n}[2] = {d3}\n{n}[3] = {d4}", says="VAL-II has no lists in `[`", help="give each element a line: `{n}[0] = {d}`, `{n}[1] = {d2}` and so on"),
    Idiom("{n} = <[|{|(> {v} , {r} <]|}|)>", "", says="VAL-II has no lists", help="give each element a line: for locations `SET {n}[1] = {v}`, for numbers `{n}[1] = {v}`, and so on"),
    Idiom("{n} = [ ]", "", says="VAL-II has no lists in `[`", help="leave it out: an element begins with its first value, as in `{n}[0] = 1`", drop=True),
    Idiom("{n} = { {r} }", "", says="VAL-II has no lists in `{`", help="give each element a line, as in `{n}[0] = 1`"),
    Idiom("{n} = {d} , {d2} , {d3}", "", says=_NUMBERS, help="write `SET {n} = " + _POINT + "`, " + _UNTURNED),
    Idiom("{n} = p [ " + _LIST6 + " ]", "", "URScript", help="write `SET {n} = TRANS(x, y, z, o, a, t)`, in mm and degrees"),
    Idiom("{n} = " + _LIST6, "SET {n} = " + _SIX, says=_NUMBERS),
    Idiom("set_<location|point|pose|pos>_{n} = {e}", "SET {n} = {e}", says="SET takes the name of the location alone"),
    Idiom("set_{n} := {e}", "SET {n} = {e}", "Pascal and RAPID"),
    Idiom("set_{n}_trans ( {r} )", "SET {n} = TRANS({r})", says="`=` is missing before `TRANS`"),
    Idiom("set_{n} , trans ( {r} )", "SET {n} = TRANS({r})", says="SET takes `=`, not a comma"),
    Idiom("<set|let>_{n}_<to|as>_{e}", "SET {n} = {e}", says="SET takes `=`"),
    # locations that change
    Idiom("set_{v} = shift ( {v2} , x = {d} )", "SET {v} = SHIFT({v2} BY {d}, 0, 0)", says="arguments have no names: their order tells"),
    Idiom("set_{v} = shift ( {v2} , y = {d} )", "SET {v} = SHIFT({v2} BY 0, {d}, 0)", says="arguments have no names: their order tells"),
    Idiom("set_{v} = shift ( {v2} , z = {d} )", "SET {v} = SHIFT({v2} BY 0, 0, {d})", says="arguments have no names: their order tells"),
    Idiom("set_{v} = {v2} + <[|(|{> {d} , {d2} , {d3} <]|)|}>", "SET {v} = SHIFT({v2} BY {d}, {d2}, {d3})", says="locations are not added, SHIFT moves them"),
    Idiom("shift ( {v} , {e} , {e2} , {e3} )", "SHIFT {v} BY {e}, {e2}, {e3}", says="the offsets of SHIFT follow BY", sure=False),
    Idiom("here = {v}", "HERE {v}", says="HERE takes the name of the location"),
    Idiom("here ( {v} )", "HERE {v}", says="HERE takes no parentheses"),
    Idiom("{v} = here", "HERE {v}", says="`=` gives a value to a number, HERE to a location"),
    Idiom("{v} = trans ( {r} )", "SET {v} = TRANS({r})", says="SET gives a value to a location"),
    Idiom("point_{n} = {e}", "SET {n} = {e}", says="POINT is a command for the monitor, not a step of a program"),
    Idiom("<teach|record|save|store_point|learn|where>_{v}", "HERE {v}", "other robot languages", sure=False),
    Idiom("base ( {r} )", "BASE {r}", says="BASE takes no parentheses"),
    Idiom("tool_" + _LIST6, "TOOL " + _SIX, says=_NUMBERS),
    Idiom("tool ( " + _LIST6 + " )", "TOOL " + _SIX, says=_NUMBERS),
    Idiom("tool_{d} , {e} , {e2}", "", says=_NUMBERS, help="for a tool that is not turned write `TOOL TRANS({d}, {e}, {e2}, 90, -90, 0)`"),
    Idiom("tool ( {d} , {e} , {e2} )", "", says=_NUMBERS, help="for a tool that is not turned write `TOOL TRANS({d}, {e}, {e2}, 90, -90, 0)`"),
    Idiom("tool ( {r} )", "", says="TOOL takes a location", help="write `TOOL TRANS(x, y, z, o, a, t)`"),
    Idiom("tool = {e}", "TOOL {e}", says="TOOL takes no `=`"),
    Idiom("<settool|set_tool|tooloffset|set_tcp>_{v}", "TOOL {v}", "other robot languages"),
    Idiom("<settool|set_tool|set_tcp> ( {v} )", "TOOL {v}", "other robot languages"),
)
