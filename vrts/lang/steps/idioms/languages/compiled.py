"""What C, Java, BASIC and Pascal write that is no block."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_PROGRAMS = "write each program between `.PROGRAM name` and `.END`"
_ON = "GOTO goes to one label"

COMPILED = (
    # BASIC: jumps by a number
    Idiom("on_error {r}", "", "BASIC", help="write `REACTE program`: that program is called when a step fails"),
    *(
        Idiom(
            "on_{v}_<goto|go_to> " + " , ".join(f"{{d{k or ''}}}" for k in (0, 2, 3, 4, 5)[:count]),
            "\n".join(f"IF {{v}} == {k + 1} GOTO {{d{(k + 1) if k else ''}}}" for k in range(count)),
            "BASIC",
            note=_ON,
            help=("write " + ", ".join(f"`IF {{v}} == {k + 1} GOTO {{d{(k + 1) if k else ''}}}`" for k in range(count)) + ", each on a line of its own") if count > 1 else "",
        )
        for count in (1, 2, 3, 4, 5)
    ),
    Idiom("on_{v}_<gosub|call> {r}", "", "BASIC", help="write `CASE {v} OF`, `VALUE 1:` with a CALL below it, `VALUE 2:` with another, and `END`"),
    Idiom("on_{v}_<goto|go_to> {r}", "", "BASIC", help="write `IF {v} == 1 GOTO 10`, and one such line for each label"),
    Idiom("exit_<for|do|while|loop|repeat>", "", "BASIC", help="leave the loop by `GOTO label`, to a label below its END"),
    Idiom("exit_<sub|function|proc|procedure|main|program>", "RETURN", "BASIC"),
    Idiom("<exit|quit|_exit> ( {r} )", "HALT", "C and Python", help="write `HALT`, which ends the execution; a loop is left by `IF condition GOTO label`"),
    # the terminal
    Idiom("<?|lprint|msgbox|messagebox|alert|debug.print|showmessage> <(|> {s} <)|>", "TYPE {s}", "BASIC"),
    Idiom("<?|lprint|msgbox|messagebox|alert> {s} <,|;|&|+> {e}", "TYPE {s}, {e}", "BASIC"),
    Idiom("? {e}", "TYPE {e}", "BASIC"),
    Idiom("print_{s} ; {v} ; {s2}", "TYPE {s}, {v}, {s2}", "BASIC"),
    Idiom("print_{s} ; {v}", "TYPE {s}, {v}", "BASIC"),
    Idiom("print_{s} <&|+> {v}", "TYPE {s}, {v}", "BASIC"),
    Idiom("input_{v} , {v2}", "", "BASIC", help='PROMPT asks for one value: write `PROMPT "{v}? ", {v}`, and one more for `{v2}`'),
    Idiom("beep <( )|>", "TYPE $CHR(7)", "BASIC", help="leave it out, or write `TYPE $CHR(7)`", sure=False),
    Idiom("<randomize|srand|randseed|random.seed|rng> {r}", "", "other languages", help="leave it out: RANDOM needs no beginning", drop=True),
    Idiom("<option|defint|defdbl|deflng|uses|package|using_namespace|typedef|pragma|extern> {r}", "", "other languages", help="leave it out: VAL-II has no such declarations", drop=True),
    Idiom("<locate|color|width|gotoxy|textcolor|screen|setlocal> {r}", "", "BASIC", help="leave it out: VAL-II writes line by line", drop=True),
    Idiom("restore {r}", "", "BASIC", help="VAL-II has no DATA: give each element its value, as in `x[1] = 5`"),
    Idiom("poke {r}", "", "BASIC", help="to switch an output write `SIGNAL 3`; for an analog one `DAC 1 = x`"),
    Idiom("case_is {e}", "", "BASIC", help="a CASE takes values alone: write `IF x > 3 THEN` for a condition"),
    Idiom("case {d}_to_{d2}", "", "BASIC", help="write each value: `VALUE {d}, {d2}:`, with those between them"),
    Idiom("<readln|readkey|getch|getchar|get_char|input> <( )|>", "PAUSE", "other languages", help='write `PAUSE "text"` to wait for the operator, `PROMPT "text", n` to ask for a number', sure=False),
    Idiom('scanf ( "%<d|i|f|lf|s|c|u>" , & {v} )', 'PROMPT "{v}? ", {v}', "C"),
    Idiom("cin >> {v} >> {v2}", "", "C++", help='PROMPT asks for one value: write `PROMPT "{v}? ", {v}`, and one more for `{v2}`'),
    Idiom("<std::|>cout << {s} << {v} <<< endl|<< std::endl|<< \"\\n\"|>", "TYPE {s}, {v}", "C++"),
    Idiom("<std::|>cout << {s} << {v} << {s2} <<< endl|<< std::endl|>", "TYPE {s}, {v}, {s2}", "C++"),
    Idiom("std::cout << {s} <<< endl|<< std::endl|>", "TYPE {s}", "C++"),
    Idiom("<std::|>cout << {v} <<< endl|<< std::endl|>", "TYPE {v}", "C++"),
    Idiom("<std::|>cin >> {v}", 'PROMPT "{v}? ", {v}', "C++"),
    # numbers
    Idiom("<inc|incr|increment> ( {v} , {e} )", "{v} = {v}+{e}", "Pascal"),
    Idiom("<dec|decr|decrement> ( {v} , {e} )", "{v} = {v}-{e}", "Pascal"),
    Idiom("<inc|incr>_{v} , {e}", "{v} = {v}+{e}", "other languages"),
    Idiom("<dec|decr>_{v} , {e}", "{v} = {v}-{e}", "other languages"),
    # Pascal and C round their programs
    Idiom("end . ", "", "Pascal", help="leave it out: a program ends with `.END`", drop=True),
    Idiom("end_else <begin|>", "ELSE", "Pascal"),
    Idiom("function_{n} ( {r} ) : {r2}", "", "Pascal", help=_PROGRAMS),
    Idiom("<public|private|protected|static|public_static|private_static|public_static_void|async>_{r} ( {r2} ) <{|>", "", "Java", help=_PROGRAMS),
    Idiom("<string|const_string|char * |std::string>_{n} = {s}", "${n} = {s}", "a typed language", says="VAL-II has no declarations", note="the name of a string begins with `$`"),
    Idiom("<struct|enum|union|record|type>_{n} {", "", "C", help="leave it out: give each value a name of its own, or an array"),
    Idiom("enum_{r}", "", "C", help="give each name a number: `red = 1`, `green = 2`"),
    Idiom("new_{r}", "", "Java", help="leave it out: VAL-II has no objects", drop=True),
    # Arduino
    Idiom("pinmode ( {r} )", "", "Arduino", help="leave it out: signals from 1 are outputs, from 1001 inputs", drop=True),
    Idiom("analogwrite ( {e} , {e2} )", "DAC {e} = {e2}", "Arduino", sure=False),
)
