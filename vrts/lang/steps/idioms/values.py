"""Declarations, values and calls of other languages."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_NO_TYPES = "variables of VAL-II need no declaration: the first value makes them"
_TYPES = "<int|integer|float|double|real|num|bool|boolean|long|short|byte|char|string|var|let|const|auto|unsigned_int|single|decl_int|decl_real|decl_bool|pers_num|var_num|local|static_int|global|dim|number|variable|define|set_var>"

VALUES = (
    Idiom(_TYPES + "_{v} = {e}", "{v} = {e}", "a typed language", says="VAL-II has no declarations", note=_NO_TYPES),
    Idiom(_TYPES + "_{v} := {e}", "{v} = {e}", says="VAL-II has no declarations", note=_NO_TYPES),
    Idiom("dim_{r}_as_{r2}", says="VAL-II has no declarations", note=_NO_TYPES, drop=True, help="leave it out"),
    Idiom("var_{r}:{r2}", says="VAL-II has no declarations", note=_NO_TYPES, drop=True, help="leave it out"),
    Idiom(_TYPES + "_{v}", says="VAL-II has no declarations", note=_NO_TYPES, drop=True, help="leave it out"),
    Idiom(_TYPES + "_{v} , {r}", says="VAL-II has no declarations", note=_NO_TYPES, drop=True, help="leave it out"),
    Idiom("dim_{r}", says="VAL-II has no declarations", note=_NO_TYPES, drop=True, help="leave it out"),
    Idiom("<const|constant>_<int|float|double|num|>_{v} = {e}", "{v} = {e}", says="VAL-II has no declarations", note=_NO_TYPES),
    Idiom("#define_{v}_{e}", "{v} = {e}", "C"),
    Idiom("#include {r}", "", "C", help="leave it out: all programs of a file know each other", drop=True),
    Idiom("<import|from|using|include>_{r}", "", "Python and C", help="leave it out: all programs of a file know each other", drop=True),
    Idiom("set_{v} to {e}", "{v} = {e}", says="a value is given by `=`"),
    Idiom("{v} += {e}", "{v} = {v}+{e}", says="`+=` is not an operator of VAL-II"),
    Idiom("{v} -= {e}", "{v} = {v}-{e}", says="`-=` is not an operator of VAL-II"),
    Idiom("{v} *= {e}", "{v} = {v}*({e})", says="`*=` is not an operator of VAL-II"),
    Idiom("{v} /= {e}", "{v} = {v}/({e})", says="`/=` is not an operator of VAL-II"),
    Idiom("{v} ++", "{v} = {v}+1", says="`++` is not an operator of VAL-II"),
    Idiom("++ {v}", "{v} = {v}+1", says="`++` is not an operator of VAL-II"),
    Idiom("{v} --", "{v} = {v}-1", says="`--` is not an operator of VAL-II"),
    Idiom("-- {v}", "{v} = {v}-1", says="`--` is not an operator of VAL-II"),
    Idiom("<inc|incr|increment> {v}", "{v} = {v}+1", "other languages"),
    Idiom("<inc|incr|increment> ( {v} )", "{v} = {v}+1", "Pascal and RAPID"),
    Idiom("<dec|decr|decrement> {v}", "{v} = {v}-1", "other languages"),
    Idiom("<dec|decr|decrement> ( {v} )", "{v} = {v}-1", "Pascal and RAPID"),
    Idiom("{v} <- {e}", "{v} = {e}", says="a value is given by `=`"),
    Idiom("{v} == {e}", "{v} = {e}", says="a comparison is not a step"),
    Idiom("{n} ( {e} ) = {e2}", "{n}[{e}] = {e2}", "BASIC and MATLAB", says="an element of an array is written with brackets"),
    Idiom("{n} ( {e} ) := {e2}", "{n}[{e}] = {e2}", "Pascal", says="an element of an array is written with brackets"),
    # procedures
    Idiom("<execute|exec>_{n}", "CALL {n}"),
    Idiom("<gosub|perform|run|start|goto_sub|call_sub|call_program|call_to>_{n}", "CALL {n}", says="a program is called by CALL"),
    Idiom("call_{n} , {e}", "CALL {n}({e})", says="arguments stand between parentheses"),
    Idiom("call_{n}_{v}", "CALL {n}({v})", says="arguments stand between parentheses"),
    Idiom("call_{s}", "", says="CALL takes the name of a program, without quotes", help="leave the quotes out"),
    Idiom("call_.{n}", "CALL {n}", says="CALL takes the name of a program, without a point"),
    Idiom("call_program_{n}", "CALL {n}", says="CALL takes the name of a program"),
    Idiom("return_{e}", "RETURN", says="a program returns no value", help="give the value to an argument before RETURN: arguments are passed by reference", sure=False),
    Idiom("return ( )", "RETURN", "C"),
    Idiom("<def|void|proc|sub|function|procedure|int|func|fun>_{n} ( {r} ) <{|:|>", "", "other languages", help="write each program between `.PROGRAM name` and `.END`"),
    Idiom("<def|void|proc|sub|function|procedure|func|program>_{n}", "", "other languages", help="write each program between `.PROGRAM name` and `.END`"),
    Idiom("<end_program|endproc|endsub|end_sub|end_proc|end_function|endfunction|endfct|end_main|end_def>", "", "other languages", help="a program ends with `.END`: leave this out", drop=True),
    Idiom("<quit|end_program|stop_program|terminate> <(|> <)|>", "HALT", "other languages", sure=False),
    Idiom("<go_to|jump|jmp|goto_label|goto_line|branch|jump_to|go> {d}", "GOTO {d}", "other languages"),
    Idiom("goto_label_{d}", "GOTO {d}", says="GOTO takes the label alone"),
    Idiom("goto_{d} :", "GOTO {d}", says="GOTO takes the label alone"),
    Idiom("goto , {d}", "GOTO {d}", says="GOTO takes the label alone"),
    Idiom("goto ( {d} )", "GOTO {d}", says="GOTO takes the label alone"),
    Idiom("label_{d} <:|>", "", says="a label stands before its step, without a word", help="write `{d}` at the start of the line"),
    Idiom("if {e} then_goto_{d}", "IF {e} GOTO {d}", "BASIC"),
    Idiom("if {e} then_{d}", "IF {e} GOTO {d}", "BASIC"),
    Idiom("if {e} <jump|go_to|jmp|then_go_to|then_jump> {d}", "IF {e} GOTO {d}", "BASIC"),
    Idiom("if {e} , goto_{d}", "IF {e} GOTO {d}", says="IF takes no comma before GOTO"),
    Idiom("if_not {e} goto_{d}", "IF NOT {e} GOTO {d}", "BASIC"),
    Idiom("{n} :", says="labels are whole numbers, not names", help="write a number instead: `10 READY`, then `GOTO 10`", habit="names of labels"),
    Idiom("{n} :_{n2}", says="labels are whole numbers, not names", help="write a number instead: `10 READY`, then `GOTO 10`", habit="names of labels"),
    Idiom("{n} :_{n2}_{r}", says="labels are whole numbers, not names", help="write a number instead: `10 READY`, then `GOTO 10`", habit="names of labels"),
    Idiom("label_{n} <:|>", says="labels are whole numbers, not names", help="write a number instead: `10 READY`, then `GOTO 10`", habit="names of labels"),
)
