"""Output and input of other languages."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

TERMINAL = (
    Idiom("<print|println|disp|display|echo|write|writeln|show|puts|cout|log|msg|message|say|output|tpwrite|popup|textmsg|printf|fprintf|console.log|system.out.println|serial.print|serial.println> ( {s} )", "TYPE {s}", "another language"),
    Idiom('printf ( "{r}%{r2}" , {e} )', 'TYPE "{r}", {e}', "C", sure=False),
    Idiom("<printf|fprintf|sprintf> ( {r} )", "", "C", help='write `TYPE "text", x`'),
    Idiom("<print|println|disp|display|echo|write|writeln|show|puts|log|msg|say|output|tpwrite|textmsg|console.log> ( {e} )", "TYPE {e}", "another language"),
    Idiom("<print|println|disp|display|echo|write|writeln|show|puts|msg|message|say|tpwrite|output|log|put|typ|text|typeln|printl>_{e}", "TYPE {e}", "another language"),
    Idiom("<print|println|disp|display|echo|write|writeln|show|puts|msg|say|tpwrite> {s}", "TYPE {s}", "another language"),
    Idiom("<print|println|disp|write|writeln> {s} , {e}", "TYPE {s}, {e}", "another language"),
    Idiom("<print|println|writeln|write|disp> <(|> <)|>", "TYPE", "another language"),
    Idiom("cout << {s}", "TYPE {s}", "C++"),
    Idiom("cout << {e} << endl", "TYPE {e}", "C++"),
    Idiom("type {s} % {e}", "", "Python", help="write the value behind a comma: `TYPE {s}, {e}`, and take the `%` out of the text"),
    Idiom("type {s} . format ( {e} )", "", "Python", help="write the value behind a comma: `TYPE {s}, {e}`, and take the braces out of the text"),
    Idiom("type {s}_{e}", "TYPE {s}, {e}", says="a comma is missing behind the text"),
    Idiom("type_{e} + {s}", "TYPE {e}, {s}", says="`+` joins strings, and this is a number", sure=False),
    Idiom("type_{e} & {e2}", "TYPE {e}, {e2}", "BASIC"),
    Idiom("type : {e}", "TYPE {e}", says="TYPE takes no colon"),
    Idiom("type = {e}", "TYPE {e}", says="TYPE takes no `=`"),
    Idiom("type , {e}", "TYPE {e}", says="TYPE takes no comma first"),
    Idiom("{v} = <input|raw_input> ( {s} )", "PROMPT {s}, {v}", "Python"),
    Idiom("{v} = <int|float> ( input ( {s} ) )", "PROMPT {s}, {v}", "Python"),
    Idiom("{v} = input ( )", 'PROMPT "", {v}', "Python", sure=False),
    Idiom("input_{s} <,|;|> {v}", "PROMPT {s}, {v}", "BASIC"),
    Idiom("<readln|read|input|scanf> ( {v} )", "PROMPT {v}", "another language"),
    Idiom("<input|read|readln|scanf|get|cin>_{v}", 'PROMPT "{v}? ", {v}', "BASIC", sure=False),
    Idiom("<input|read|readln|scanf|cin> ( {r} )", "", "another language", help='write `PROMPT "text", n`'),
    Idiom("cin >> {v}", 'PROMPT "{v}? ", {v}', "C++", sure=False),
    Idiom("prompt_{s}_{v}", "PROMPT {s}, {v}", says="a comma is missing behind the text"),
    Idiom("prompt ( {s} , {v} )", "PROMPT {s}, {v}", says="PROMPT takes no parentheses"),
    Idiom("type ( {s} , {e} )", "TYPE {s}, {e}", says="TYPE takes no parentheses", help="leave the parentheses out: write `TYPE {s}, {e}`"),
    Idiom('type ""{r}""', 'TYPE "{r}"', says="text stands between one pair of double quotes"),
    Idiom("type_{n}_{n2}", 'TYPE "{n} {n2}"', says="text stands between double quotes", help='put the text between double quotes: `TYPE "{n} {n2}"`', sure=False),
    Idiom("type_{n}_{n2}_{r}", 'TYPE "{n} {n2} {r}"', says="text stands between double quotes", help='put the text between double quotes: `TYPE "{n} {n2} {r}"`', sure=False),
    Idiom("stop_{n}_{r}", 'STOP "{n} {r}"', says="text stands between double quotes", help='put the text between double quotes: `STOP "{n} {r}"`'),
    Idiom("halt_{n}_{r}", 'HALT "{n} {r}"', says="text stands between double quotes", help='put the text between double quotes: `HALT "{n} {r}"`'),
    Idiom("pause_{n}_{r}", 'PAUSE "{n} {r}"', says="text stands between double quotes", help='put the text between double quotes: `PAUSE "{n} {r}"`'),
    Idiom("{v} = prompt_{s}", "PROMPT {s}, {v}", says="PROMPT is an instruction: the variable stands behind the text"),
    Idiom("{v} = prompt ( {s} )", "PROMPT {s}, {v}", says="PROMPT is an instruction: the variable stands behind the text"),
)
