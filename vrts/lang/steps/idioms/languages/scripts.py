"""What Python and MATLAB write that is no block: texts, values, the desk of MATLAB."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_CONVERTED = "<str|num2str|string|int2str|to_string|tostring|str2|repr|mat2str|cstr|inttostr|floattostr>"
_SHOWN = "<print|println|printf|disp|display|fprintf|writeln|write|cout|echo|puts|log|textmsg|msgbox|system.out.println|system.out.print|system.out.printf|console.log|console.writeline|serial.println|serial.print|type>"
_LETTER = "<d|i|f|s|g|u|ld|lf|c|x|.0f|.1f|.2f|.3f|.4f|2d|3d|4d|5d|6.2f|5.1f|5.2f|8.3f>"
_END = r"<\n|\r\n|>"
_FORMATS = "a value stands behind a comma; `/F8.2` before it says how many places it has"
_DESK = "leave it out: VAL-II has no windows, and its variables stay"

SCRIPTS = (
    # texts and values on the terminal
    Idiom(_SHOWN + ' ( <"|\'>{t}' + r"\n" + '<"|\'> )', 'TYPE "{t}"', "another language"),
    Idiom(_SHOWN + ' ( <"|\'>{t}%' + _LETTER + _END + '<"|\'> <,|%> {e} )', 'TYPE "{t}", {e}', "another language", note=_FORMATS),
    Idiom(_SHOWN + ' ( <"|\'>{t}%' + _LETTER + "{t2}" + '<"|\'> <,|%> {v} )', 'TYPE "{t}", {v}, "{t2}"', "another language", note=_FORMATS, sure=False),
    Idiom(_SHOWN + ' ( <"|\'>{t}%' + _LETTER + "{t2}%" + _LETTER + _END + '<"|\'> , {v} , {v2} )', 'TYPE "{t}", {v}, "{t2}", {v2}', "another language", note=_FORMATS),
    Idiom(_SHOWN + ' ( {s} <+|,> ' + _CONVERTED + " ( {e} ) )", "TYPE {s}, {e}", "another language"),
    Idiom(_SHOWN + ' ( {s} <+|,> ' + _CONVERTED + " ( {e} ) + {s2} )", "TYPE {s}, {e}, {s2}", "another language"),
    Idiom(_SHOWN + " ( [ {s} <,|> " + _CONVERTED + " ( {e} ) ] )", "TYPE {s}, {e}", "MATLAB"),
    Idiom(_SHOWN + " ( [ {s} <,|> " + _CONVERTED + " ( {e} ) <,|> {s2} ] )", "TYPE {s}, {e}, {s2}", "MATLAB"),
    Idiom(_SHOWN + " ( " + _CONVERTED + " ( {e} ) )", "TYPE {e}", "another language"),
    Idiom(_SHOWN + ' ( <"|\'>{t}{}<"|\'> . format ( {e} ) )', 'TYPE "{t}", {e}', "Python"),
    Idiom(_SHOWN + ' ( {s} . format ( {r} ) )', "", "Python", help='write the value behind a comma: `TYPE "text", n`'),
    Idiom("<print|println|writeln|write|disp|system.out.println|system.out.print> ( {s} + {v} )", "TYPE {s}, {v}", "another language"),
    Idiom("<print|println> ( {s} , {e} , <end|sep> = {r} )", "TYPE {s}, {e}", "Python", sure=False),
    Idiom("<print|println> ( {s} , <end|sep> = {r} )", "TYPE {s}, /S", "Python", help="write `TYPE {s}, /S`: `/S` keeps the line open", sure=False),
    Idiom("<\"\"\"|'''>{t}<\"\"\"|'''>", "; {t}", says="a comment begins with `;`"),
    Idiom("\"{t}\"", "; {t}", says="a text alone is no step", help="if this is a comment, begin it with `;`; to show the text write `TYPE \"{t}\"`", sure=False),
    # values
    Idiom("{v} //= {d}", "{v} = INT({v}/{d})", says="`//=` is not an operator of VAL-II"),
    Idiom("{v} %= {d}", "{v} = {v} MOD {d}", says="`%=` is not an operator of VAL-II"),
    Idiom("{v} //= {e}", "{v} = INT({v}/({e}))", says="`//=` is not an operator of VAL-II"),
    Idiom("{v} %= {e}", "{v} = {v} MOD ({e})", says="`%=` is not an operator of VAL-II"),
    Idiom("{v} **= 2", "{v} = SQR({v})", says="`**=` is not an operator of VAL-II"),
    Idiom("{v} , {v2} = {v2} , {v}", "", says="a step gives one value to one variable", help="keep one of them meanwhile: `t = {v}`, `{v} = {v2}`, `{v2} = t`, each on a line of its own"),
    Idiom("{v} , {v2} = {d} , {d2}", "{v} = {d}\n{v2} = {d2}", says="a step gives one value to one variable"),
    Idiom("swap <(|> {v} , {v2} <)|>", "", "other languages", help="keep one of them meanwhile: `t = {v}`, `{v} = {v2}`, `{v2} = t`, each on a line of its own"),
    # words that VAL-II has none for
    Idiom("<with|async|await>_{r}", "", "Python", help="leave it out: VAL-II has no such blocks"),
    Idiom("assert_{e} <, {s}|>", "IF NOT ({e}) THEN\n    HALT\nEND", "Python", help="write `IF NOT ({e}) THEN`, `HALT`, `END`, each on a line of its own", sure=False),
    Idiom("<raise|throw>_{r}", "", "Python and Java", help='write `HALT "text"`, which ends the execution with that text'),
    Idiom("yield_{r}", "RETURN", "Python", help="give the value to an argument, and write RETURN", sure=False),
    Idiom("nonlocal_{r}", "", "Python", help="leave it out: variables of VAL-II are global", drop=True),
    Idiom("<class|interface|namespace|package>_{r}", "", "Python and Java", help="leave it out: VAL-II has programs only, each between `.PROGRAM name` and `.END`"),
    Idiom("lambda_{r}", "", "Python", help="write a program of its own, and CALL it"),
    # MATLAB
    Idiom("tic <( )|>", "TIMER 1 = 0", "MATLAB", note="`TIMER(1)` are the seconds since then"),
    Idiom("{v} = tic <( )|>", "TIMER 1 = 0", "MATLAB"),
    Idiom("toc <( )|( {r} )|>", 'TYPE TIMER(1)', "MATLAB", help="the seconds since `TIMER 1 = 0` are `TIMER(1)`: write `TYPE TIMER(1)`"),
    Idiom("{v} = toc <( )|( {r} )>", "{v} = TIMER(1)", "MATLAB"),
    Idiom("<clc|clear|clear_all|close_all|figure|hold_on|hold_off|clearvars|format_long|format_short|warning_off|cls|clrscr|clear_screen|screen> <( )|>", "", "MATLAB and BASIC", help=_DESK, drop=True),
    Idiom("<plot|subplot|xlabel|ylabel|title|legend|axis|grid> {r}", "", "MATLAB", help="leave it out: VAL-II draws nothing; TYPE writes numbers to the terminal"),
    Idiom("<error|abort|fatal|die|panic> ( <\"|'>{t}<\"|'> )", 'HALT "{t}"', "other languages"),
    Idiom("function <[ {r} ]|{n}> = {n2} <( {r2} )|>", "", "MATLAB", help="write `.PROGRAM {n2}(a, result)`, and CALL it: a program gives its result to an argument"),
)
