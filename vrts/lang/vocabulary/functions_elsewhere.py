"""Functions that one language of the family has and another has not, and what to write there.

In a template `{a}` is all arguments, `{0}` the first. What takes another number of arguments
than the template names is left to words.
"""

import re
from collections.abc import Sequence

from vrts.lang.dialect import Dialect

_SIMPLE = re.compile(r"[\w.$]+(?:\[[^\[\]]*\]|\([^()]*\))?")
_PLACE = re.compile(r"\{(\d)\}")
_OPERATORS = re.compile(r"\}[ ]?(?:[-+*/^:]|==|<>|MOD|BAND|BOR|BXOR)|-\{|COM \{")
_WITHIN = "randint random.randint rand_int irand rand_range randrange"
_FROM_ONE = "INT({1}*RANDOM)+1"
_MODULES = frozenset({"math", "np", "numpy", "m", "str", "string"})


def _named(*rows: tuple[str, str]) -> dict[str, tuple[str, ...]]:
    """Return templates by the names of functions: several of these stand in a row."""
    found: dict[str, tuple[str, ...]] = {}
    for names, template in rows:
        for name in names.split():
            found[name] = (*found.get(name, ()), template)
    return found


_EVERYWHERE = _named(
    # texts and numbers
    (
        (
            "atoi atof stoi stof stod strtol strtod parseint parsefloat parse_int parse_float "
            "tonumber tonum to_num to_number str2num str2double str2int str2real strtoint "
            "strtonum strtofloat "
            "strtoreal stringtonum stringtoint stringtoreal string2num numval "
            "number.parse int.parse "
            "strtoval str_to_num str_to_int to_int valstr cvs"
        ),
        "VAL({0})",
    ),
    (
        (
            "itoa ftoa itos str string tostring to_string to_str num2str int2str real2str inttostr "
            "inttostring numtostr numtostring realtostr valtostr valtostring floattostr cstr dtoa "
            "num_to_str int_to_str int2string num2string"
        ),
        "$ENCODE({0})",
    ),
    ("numtostr valtostr num2str str_format", "$ENCODE({0})"),
    (
        (
            "strcmp stricmp strcmpi strcasecmp strcomp isequal strequal strequals str_equal streq "
            "equals equal str_eq comparestr comparetext cmpstr"
        ),
        "{0} == {1}",
    ),
    ("strcat str_cat concat concatenate strconcat strjoin strappend join", "{0}+{1}"),
    ("strcat str_cat concat concatenate strconcat", "{0}+{1}+{2}"),
    ("strlen length str_len lenstr strsize len_str stringlength", "LEN({0})"),
    ("asc2 ascii charcode charcodeat ord code", "ASC({0})"),
    ("char chrw tochar to_char fromcharcode", "$CHR({0})"),
    ("mid midstr strmid substr substring strpart str_sub strsub midb extract", "$MID({a})"),
    # numbers
    ("fmod rem remainder modulo modulus mod_ irem", "{0} MOD {1}"),
    ("idiv intdiv div quotient floordiv", "INT({0}/{1})"),
    ("trunc fix truncate toint intval int32 cint floor", "INT({0})"),
    ("fabs absolute absval labs iabs abs_", "ABS({0})"),
    ("sqroot root squareroot sqrtf sqr_root", "SQRT({0})"),
    ("sind sinus", "SIN({0})"),
    ("cosd cosinus", "COS({0})"),
    ("atan2d arctan2 arctg2", "ATAN2({0}, {1})"),
    ("atan arctan atand atn arctg", "ATAN2({0}, 1)"),
    ("bitand bit_and iand and_bits", "{0} BAND {1}"),
    ("bitor bit_or ior or_bits", "{0} BOR {1}"),
    ("bitxor bit_xor ieor ixor bitexor", "{0} BXOR {1}"),
    ("bitnot bitcmp bit_not inot bitneg", "COM {0}"),
    ("radians deg2rad degrees rad2deg rad deg torad todeg d2r r2d deg_to_rad rad_to_deg", "{0}"),
    ("rand rnd random.random", "RANDOM"),
    (_WITHIN, "INT(({1}-{0}+1)*RANDOM)+{0}"),
    # places
    (
        "pose_dist posedist pointdist point_dist dist distance_between dist3d euclidean",
        "DISTANCE({0}, {1})",
    ),
    ("offs offset pose_offset shiftpos shift_pos poseoffset", "SHIFT({0} BY {1}, {2}, {3})"),
)
NAMES_ELSEWHERE = _EVERYWHERE | _named(
    ("maxval maximum maxi max2", "MAX({a})"),
    ("minval minimum mini min2", "MIN({a})"),
    ("left $left leftstr strleft", "$MID({0}, 1, {1})"),
    ("right $right rightstr strright", "$MID({0}, LEN({0})-{1}+1, {1})"),
    ("instr find strfind strstr index indexof strpos str_find locate position", "POS({0}, {1})"),
    ("instr", "POS({1}, {2}, {0})"),
    ("contains includes strcontains", "POS({0}, {1}) > 0"),
    ("startswith starts_with", "$MID({0}, 1, LEN({1})) == {1}"),
    ("sq square sqr2 sqare", "SQR({0})"),
    ("round nint rint anint", "INT({0}+0.5)"),
    ("tand tg", "TAN({0})"),
    ("frac fractional modf", "FRACT({0})"),
    ("sgn signum sgnf", "SIGN({0})"),
    ("limit clamp constrain saturate", "MAX({1}, MIN({2}, {0}))"),
    ("pose_trans posemult pose_mul pose_mult", "{0}:{1}"),
    ("pose_inv poseinv inv invert inverse_pose pose_inverse invpose", "INVERSE({0})"),
    ("reltool", "{0}:TRANS({1}, {2}, {3})"),
    ("isdefined exists present isset is_defined isvalid", "DEFINED({0})"),
)
_OF_AS = _EVERYWHERE | _named(
    ("max maximum maxi max2", "MAXVAL({a})"),
    ("min minimum mini min2", "MINVAL({a})"),
    ("pos find strfind strstr index indexof strpos str_find locate position", "INSTR({0}, {1})"),
    ("pos", "INSTR({2}, {0}, {1})"),
    ("contains includes strcontains", "INSTR({0}, {1}) > 0"),
    ("startswith starts_with", "$LEFT({0}, LEN({1})) == {1}"),
    ("inverse pose_inv poseinv inv invert inverse_pose pose_inverse invpose", "-{0}"),
    ("sqr sq square sqr2", "{0}^2"),
    ("pow power expt math.pow", "{0}^{1}"),
    ("tan tand tg", "SIN({0})/COS({0})"),
    ("fract frac fractional", "{0}-INT({0})"),
    ("nint rint anint round", "ROUND({0})"),
    ("left leftstr strleft", "$LEFT({a})"),
    ("right rightstr strright", "$RIGHT({a})"),
    ("limit clamp constrain saturate", "MAXVAL({1}, MINVAL({2}, {0}))"),
    ("pose_trans posemult pose_mul pose_mult", "{0}+{1}"),
    ("reltool", "{0}+TRANS({1}, {2}, {3}, 0, 0, 0)"),
    ("identical", "DISTANCE({0}, {1}) == 0"),
    ("strdif", "{0} == {1}"),
)
_HELP_OF_AS = {  # instead of what VAL-II has
    "sign": "AS has no such function: ask `IF x < 0 THEN`",
    "sgn": "AS has no such function: ask `IF x < 0 THEN`",
    "hypot": "use SQRT(x^2+y^2)",
    "asin": "use ATAN2(x, SQRT(1-x^2))",
    "arcsin": "use ATAN2(x, SQRT(1-x^2))",
    "acos": "use ATAN2(SQRT(1-x^2), x)",
    "arccos": "use ATAN2(SQRT(1-x^2), x)",
    "defined": 'AS asks by the name: `EXISTREAL("n")`, `EXISTTRANS("p")`, `EXISTCHAR("$s")`',
    "outside": "AS has no such function: compare, as in `(x < low) OR (x > high)`",
}
_HELP_EVERYWHERE = {
    "sprintf": "$ENCODE makes a text of numbers: `$ENCODE(/F8.2, x)`, and `+` joins texts",
    "fprintf": 'write `TYPE "text", x`',
    "ln": "there are no logarithms: keep a table of the values that are needed",
    "log": "there are no logarithms: keep a table of the values that are needed",
    "log10": "there are no logarithms: keep a table of the values that are needed",
    "exp": "there is no exponential function: keep a table of the values that are needed",
    "sum": "add them in a loop: `FOR i = 1 TO n`, `sum = sum+a[i]`, `END`",
    "mean": "add them in a loop, and divide by their number",
    "average": "add them in a loop, and divide by their number",
    "avg": "add them in a loop, and divide by their number",
    "clkread": "write `TIMER(1)`: seconds, counted up since the step `TIMER 1 = 0`",
}
_POWERS = {"2": "SQR({0})", "2.0": "SQR({0})", "0.5": "SQRT({0})", "3": "{0}*{0}*{0}"}
_POWER_NAMES = frozenset({"pow", "power", "expt"})


def rewritten(name: str, arguments: Sequence[str], dialect: Dialect) -> str:
    """Return what a dialect has for a call of a function that it lacks; empty where unknown."""
    table = _OF_AS if dialect.is_as else NAMES_ELSEWHERE
    module, _, last = name.rpartition(".")
    plain = last if module in _MODULES else name
    templates = table.get(name) or table.get(plain) or table.get(plain.lstrip("$"), ())
    if plain in _POWER_NAMES and not dialect.is_as and len(arguments) == 2:
        templates, arguments = (_POWERS.get(arguments[1], ""),), arguments[:1]
    if arguments[:1] == ["1"] and name in _WITHIN.split():
        templates = (_FROM_ONE,)
    for template in templates:
        wanted = {int(place) for place in _PLACE.findall(template)}
        if not template or (wanted and len(arguments) != max(wanted) + 1):
            continue
        if not wanted and "{a}" not in template:
            if arguments:
                continue
            return template
        if not arguments or not all(arguments):
            continue
        bare = _OPERATORS.search(template) is not None
        parts = [a if not bare or _is_simple(a) else f"({a})" for a in arguments]
        return template.replace("{a}", ", ".join(arguments)).format(*parts)
    return ""


def _is_simple(argument: str) -> bool:
    """Whether an argument needs no parentheses beside an operator."""
    return _SIMPLE.fullmatch(argument) is not None or re.fullmatch('"[^"]*"', argument) is not None


def compares_texts(name: str, dialect: Dialect) -> bool:
    """Return whether a function of another language tells how two texts differ, 0 for not."""
    table = _OF_AS if dialect.is_as else NAMES_ELSEWHERE
    return "{0} == {1}" in table.get(name, ())


def help_with(name: str, dialect: Dialect) -> str:
    """Return words for a function that a dialect lacks, where VAL-II's would mislead."""
    of_as = _HELP_OF_AS.get(name, "") if dialect.is_as else ""
    return of_as or _HELP_EVERYWHERE.get(name, "")
