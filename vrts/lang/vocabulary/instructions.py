"""The instructions: first words of a step, in all dialects.

One row a word: columns of the dialects, class in the grammar, how it is written, what it does.
Classes are explained in `grammar.lark`; REST takes the rest of its line as it stands.
"""

from vrts.lang.vocabulary import kawasaki
from vrts.lang.vocabulary.opaque_vplus import OPAQUE_VPLUS
from vrts.lang.vocabulary.word import Place, Word


def _i(
    text: str,
    dialects: str,
    terminal: str,
    usage: str,
    about: str,
    operands: str = "",
    qualifiers: str = "",
    *,
    means: str = "",
    full: bool = False,
    shortest: str = "",
    flags: str = "",  # R robot, B breaks, U unit, O opaque
) -> Word:
    return Word(
        text,
        Place.INSTRUCTION,
        dialects,
        terminal,
        usage,
        about,
        tuple(operands.split(" | ")) if operands else (),
        frozenset(qualifiers.split()),
        means,
        full,
        shortest,
        robot="R" in flags,
        breaks="B" in flags,
        unit="U" in flags,
        opaque="O" in flags,
    )


_LOCATION = "a location"
_RETREAT = "a location | a distance in mm"
_HAND = "a location | an opening in mm"
_CLAMPED = "a location | the number of a clamp"
_DISTANCE = "a distance in mm"
_CONDITION = "a condition"
_TEXT = "a text"
_SIGNAL = "a signal number"

_MOTION = (
    _i("MOVE", "12+", "WORD1", "MOVE location", "move joint-interpolated", _LOCATION, flags="R"),
    _i("MOVES", "12+", "WORD1", "MOVES location", "move on a straight line", _LOCATION, flags="R"),
    _i(
        "MOVET",
        "12+",
        "WORD2",
        "MOVET location, opening",
        "move, and change the hand on the way",
        _HAND,
        flags="R",
    ),
    _i(
        "MOVEST",
        "12+",
        "WORD2",
        "MOVEST location, opening",
        "move straight, and change the hand on the way",
        _HAND,
        flags="R",
    ),
    _i(
        "APPRO",
        "12+",
        "WORD2",
        "APPRO location, distance",
        "move to a distance before a location",
        _RETREAT,
        flags="R",
    ),
    _i(
        "APPROS",
        "12+",
        "WORD2",
        "APPROS location, distance",
        "move straight to a distance before a location",
        _RETREAT,
        flags="R",
    ),
    _i(
        "DEPART",
        "12+",
        "WORD1",
        "DEPART distance",
        "move back along the tool",
        _DISTANCE,
        flags="R",
    ),
    _i(
        "DEPARTS",
        "12+",
        "WORD1",
        "DEPARTS distance",
        "move straight back along the tool",
        _DISTANCE,
        flags="R",
    ),
    _i(
        "DRIVE",
        "12+a",
        "DRIVE",
        "DRIVE joint, change, speed",
        "move one joint by an angle",
        "a joint number | a change in degrees | a speed in percent",
        flags="R",
    ),
    _i(
        "DRAW",
        "12a",
        "WORDLIST",
        "DRAW dx, dy, dz",
        "move straight by an offset in world axes",
        "an offset in mm",
        flags="R",
    ),
    _i("ALIGN", "12+a", "WORD0", "ALIGN", "turn the tool to the nearest world axis", flags="R"),
    _i("READY", "12+", "WORD0", "READY", "move to the ready position", flags="R"),
    _i("NEST", "1", "WORD0", "NEST", "move to the storage position", flags="R"),
    _i("REST", "1", "WORD0", "REST", "move to the storage position", means="NEST", flags="R"),
    _i(
        "DELAY",
        "12+a",
        "WORD1",
        "DELAY seconds",
        "stand still for a time",
        "a time in seconds",
        flags="RB",
    ),
    _i("BREAK", "2+a", "WORD0", "BREAK", "wait until the arm stands still", flags="B"),
    _i("BRAKE", "2+a", "WORD0", "BRAKE", "give up the motion under way", flags="B"),
    _i(
        "SPEED",
        "12+a",
        "SPEED",
        "SPEED value MMPS ALWAYS",
        "set the speed of the next motion, or of all",
        "a speed",
        "MMPS IPS ALWAYS",
        flags="R",
    ),
    _i(
        "COARSE",
        "12+",
        "SETTING",
        "COARSE ALWAYS",
        "loose tolerance at stops",
        "",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "FINE", "12+", "SETTING", "FINE ALWAYS", "tight tolerance at stops", "", "ALWAYS", flags="R"
    ),
    _i(
        "NULL",
        "12+",
        "SETTING0",
        "NULL ALWAYS",
        "wait at stops until the joints are there",
        "",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "NONULL",
        "12+",
        "SETTING0",
        "NONULL ALWAYS",
        "do not wait at stops",
        "",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "INTON",
        "12",
        "SETTING0",
        "INTON ALWAYS",
        "servos with integral action",
        "",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "INTOFF",
        "12",
        "SETTING0",
        "INTOFF ALWAYS",
        "servos without integral action",
        "",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "SINGLE",
        "2+",
        "SETTING0",
        "SINGLE ALWAYS",
        "keep joints 4 and 6 within half a turn",
        "",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "MULTIPLE",
        "2+",
        "SETTING0",
        "MULTIPLE ALWAYS",
        "let joints 4 and 6 turn as far as they go",
        "",
        "ALWAYS",
        flags="R",
    ),
    *(
        _i(word, dialects, "SETTING0", word, about, "", "ALWAYS", flags="RB")
        for word, dialects, about in (
            ("RIGHTY", "12+a", "ask for the arm like a right arm"),
            ("LEFTY", "12+a", "ask for the arm like a left arm"),
            ("ABOVE", "12+a", "ask for the elbow above"),
            ("BELOW", "12+a", "ask for the elbow below"),
            ("FLIP", "12+", "ask for joint 5 negative"),
            ("NOFLIP", "12+", "ask for joint 5 positive"),
        )
    ),
    _i(
        "TOOL",
        "12+a",
        "WORD01",
        "TOOL location",
        "say where the tool tip is on the flange",
        _LOCATION,
        flags="RB",
    ),
    _i(
        "BASE",
        "12+a",
        "WORDLIST",
        "BASE dx, dy, dz, rotation",
        "say how the robot was displaced",
        "an offset in mm",
        flags="RB",
    ),
    _i("ALTON", "2+", "DEVICE", "ALTON (unit) mode", "begin to alter the path", flags="RUO"),
    _i(
        "ALTER",
        "2+",
        "DEVICE",
        "ALTER dx, dy, dz, rx, ry, rz",
        "give a correction of the path",
        flags="RUO",
    ),
    _i("ALTOFF", "2+", "WORD0", "ALTOFF", "end altering the path", flags="RBO"),
    _i(
        "ACCEL",
        "+a",
        "SPEED",
        "ACCEL percent, percent ALWAYS",
        "set acceleration and deceleration",
        "a percentage",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "DURATION",
        "+",
        "SPEED",
        "DURATION seconds ALWAYS",
        "set the least time of a motion",
        "a time in seconds",
        "ALWAYS",
        flags="R",
    ),
)

_HANDS = (
    *(
        _i(word, "12+a", "WORD01", word, about, "an opening in mm", flags=flags)
        for word, about, flags in (
            ("OPEN", "open the hand with the next motion", "R"),
            ("CLOSE", "close the hand with the next motion", "R"),
            ("RELAX", "release the hand with the next motion", "R"),
            ("OPENI", "stop, and open the hand", "RB"),
            ("CLOSEI", "stop, and close the hand", "RB"),
            ("RELAXI", "stop, and release the hand", "RB"),
        )
    ),
    _i(
        "GRASP",
        "12",
        "WORD12",
        "GRASP distance, label",
        "close the hand and check that a part is in it",
        "a distance in mm | the number of a label",
        flags="RB",
    ),
)

_DATA = (
    _i(
        "SET",
        "12+",
        "SET",
        "SET location = value",
        "give a location a value",
        "the location to set",
    ),
    _i(
        "HERE",
        "12+a",
        "HERE",
        "HERE location",
        "give a location the present pose",
        _LOCATION,
        flags="R",
    ),
    _i(
        "SHIFT",
        "12",
        "SHIFT",
        "SHIFT location BY dx, dy, dz",
        "shift a location in world axes",
        _LOCATION,
        "BY",
    ),
    _i(
        "DECOMPOSE",
        "+a",
        "GIVE",
        "DECOMPOSE array[0] = location",
        "store the components of a location",
        "an array",
    ),
    _i(
        "PACK",
        "2+",
        "PACK",
        "PACK $s, first, count = $part",
        "replace a part of a string",
        "a string variable | a position | a number of characters",
    ),
    _i(
        "TIMER",
        "2+a",
        "PUT",
        "TIMER number = seconds",
        "set a timer",
        "the number of a timer",
    ),
    _i(
        "PARAMETER",
        "2+",
        "GIVE",
        "PARAMETER HAND.TIME = value",
        "set a parameter of the controller",
        "the name of a parameter",
    ),
    _i(
        "ENABLE",
        "2+",
        "WORDITEMS",
        "ENABLE CP",
        "turn system switches on",
        "the name of a switch",
    ),
    _i(
        "DISABLE",
        "2+",
        "WORDITEMS",
        "DISABLE CP",
        "turn system switches off",
        "the name of a switch",
    ),
    *(
        _i(word, "+", "DECLARE", f"{word} a, b", about, "a variable", "REAL DOUBLE LOC")
        for word, about in (
            ("AUTO", "variables of each call"),
            ("LOCAL", "variables of this program"),
            ("GLOBAL", "variables shared by all programs"),
        )
    ),
)

_CONTROL = (
    _i(
        "GOTO",
        "12+a",
        "GOTO",
        "GOTO label",
        "go on at a label",
        "the number of a label",
    ),
    _i(
        "IF",
        "12+a",
        "IF",
        "IF condition THEN",
        "do the steps up to ELSE or END under a condition",
        _CONDITION,
        "THEN GOTO",
        full=True,
    ),
    _i("ELSE", "2+a", "STRUCTURE", "ELSE", "otherwise", full=True),
    _i("END", "2+a", "STRUCTURE", "END", "ends IF, WHILE, FOR and CASE", full=True),
    _i(
        "WHILE",
        "2+a",
        "WHILE",
        "WHILE condition DO",
        "repeat while a condition holds",
        _CONDITION,
        "DO",
        shortest="WH",
    ),
    _i("DO", "2+a", "STRUCTURE", "DO", "repeat up to UNTIL", full=True),
    _i("UNTIL", "2+a", "UNTIL", "UNTIL condition", "ends DO", _CONDITION, full=True),
    _i(
        "FOR",
        "2+a",
        "FOR",
        "FOR variable = first TO last STEP increment",
        "count",
        "a variable",
        "TO STEP",
        full=True,
    ),
    _i(
        "CASE",
        "2+a",
        "CASE",
        "CASE expression OF",
        "choose by a value",
        "an expression",
        "OF",
        full=True,
    ),
    _i("VALUE", "2+a", "VALUE", "VALUE n:", "the steps for some values", "a value", full=True),
    _i("ANY", "2+a", "ANY", "ANY", "the steps for all other values", full=True),
    _i("EXIT", "+", "WORD01", "EXIT n", "leave the loop", "a number of loops"),
    _i("NEXT", "+", "WORD01", "NEXT n", "go to the next pass of the loop", "a number of loops"),
    _i("CALL", "2+a", "CALL", "CALL program(a, b)", "run another program", "the name of a program"),
    _i(
        "CALLS",
        "+",
        "CALLS",
        "CALLS $name",
        "run the program that a string names",
        "a string",
    ),
    _i("RETURN", "12+a", "WORD01", "RETURN", "go back to the caller", shortest="RET"),
    _i("RETURNE", "2+a", "WORD0", "RETURNE", "go on behind the step that failed"),
    _i("STOP", "12+a", "WORD01", "STOP", "end this cycle", _TEXT),
    _i("HALT", "12+a", "WORD01", "HALT", "end the execution", _TEXT, flags="B"),
    _i("PAUSE", "12+a", "WORD01", "PAUSE", "stop until PROCEED", _TEXT, flags="B"),
    _i("WAIT", "12+a", "WORD01", "WAIT condition", "wait for a condition", _CONDITION),
)

_SIGNALS = (
    _i(
        "SIGNAL",
        "12+a",
        "WORDITEMS",
        "SIGNAL number",
        "turn outputs on, or off by a negative number",
        _SIGNAL,
    ),
    _i("RESET", "2+a", "WORD0", "RESET", "turn all outputs off"),
    _i(
        "BITS",
        "2+a",
        "BITS",
        "BITS first, count = value",
        "write a number to consecutive outputs",
        "the first signal | a number of signals",
    ),
    _i(
        "DAC",
        "2",
        "PUT",
        "DAC channel = value",
        "write to an analog output",
        "a channel",
    ),
    _i("IOPUT", "2", "PUT", "IOPUT address = value", "write to the bus", "an address", flags="O"),
    _i(
        "REACT",
        "12+",
        "REACT",
        "REACT signal, program, priority",
        "call a program when a signal changes",
        _SIGNAL,
        "ALWAYS",
    ),
    _i(
        "REACTI",
        "12+",
        "REACT",
        "REACTI signal, program, priority",
        "stop, and call a program, when a signal changes",
        _SIGNAL,
        "ALWAYS",
    ),
    _i("REACTE", "2+", "WORD01", "REACTE program", "call a program on errors", "a program"),
    _i("IGNORE", "12+a", "REACT", "IGNORE signal", "end watching a signal", _SIGNAL, "ALWAYS"),
    _i("LOCK", "2+a", "WORD01", "LOCK priority", "hold reactions back", "a priority"),
    _i(
        "PCEXECUTE",
        "2a",
        "WORDLIST",
        "PCEXECUTE program, cycles, step",
        "run a program beside this one",
    ),
    _i("PCABORT", "2a", "WORD0", "PCABORT", "stop the program beside this one"),
    _i("PCEND", "2a", "WORD01", "PCEND", "let the program beside this one end", "1 or -1"),
)

_TERMINAL = (
    _i("TYPE", "12+a", "TYPE", 'TYPE "text", value', "write to the terminal"),
    _i(
        "PROMPT",
        "2+a",
        "WORDLIST",
        'PROMPT "text", variable',
        "ask the operator",
    ),
    _i("MC", "2+a", "REST", "MC command", "give the monitor a command", flags="O"),
)

_VAL = (
    _i("GO", "1", "DEVICE", "GO location", "move by another form of path", full=True, flags="RO"),
    _i("MOVEI", "1", "DEVICE", "MOVEI location", "move by a location", full=True, flags="RO"),
    _i("REMARK", "1", "REST", "REMARK text", "a comment"),
    _i("GOSUB", "1", "CALL", "GOSUB program", "run another program", means="CALL"),
    _i("SETI", "1", "GIVE", "SETI n = value", "give a number a value", "a variable"),
    _i("TYPEI", "1", "WORD1", "TYPEI n", "write a number", "a variable"),
    _i(
        "IFSIG",
        "1",
        "IFSIG",
        "IFSIG signal, signal THEN label",
        "go to a label when signals are as wanted",
        _SIGNAL,
        "THEN",
    ),
    _i("INVERSE", "1", "GIVE", "INVERSE a = b", "give a location an inverse", _LOCATION),
    _i("FRAME", "1", "GIVE", "FRAME f = a, b, c, d", "give a location a frame", _LOCATION),
)

_AS = (
    _i(
        "JMOVE",
        "+a",
        "WORD12",
        "JMOVE location, clamp",
        "MOVE of AS",
        _CLAMPED,
        means="MOVE",
        flags="R",
    ),
    _i(
        "LMOVE",
        "a",
        "WORD12",
        "LMOVE location, clamp",
        "MOVES of AS",
        _CLAMPED,
        means="MOVES",
        flags="R",
    ),
    _i(
        "JAPPRO",
        "a",
        "WORD2",
        "JAPPRO location, distance",
        "APPRO of AS",
        _RETREAT,
        means="APPRO",
        flags="R",
    ),
    _i(
        "LAPPRO",
        "a",
        "WORD2",
        "LAPPRO location, distance",
        "APPROS of AS",
        _RETREAT,
        means="APPROS",
        flags="R",
    ),
    _i(
        "JDEPART",
        "a",
        "WORD1",
        "JDEPART distance",
        "DEPART of AS",
        _DISTANCE,
        means="DEPART",
        flags="R",
    ),
    _i(
        "LDEPART",
        "a",
        "WORD1",
        "LDEPART distance",
        "DEPARTS of AS",
        _DISTANCE,
        means="DEPARTS",
        flags="R",
    ),
    _i(
        "TDRAW",
        "a",
        "WORDLIST",
        "TDRAW dx, dy, dz",
        "move straight by an offset in tool axes",
        "an offset in mm",
        flags="R",
    ),
    _i("HOME", "a", "WORD01", "HOME", "READY of AS", "a number", means="READY", flags="R"),
    _i("C1MOVE", "a", "WORD12", "C1MOVE location", "first part of an arc", _CLAMPED, flags="RO"),
    _i("C2MOVE", "a", "WORD12", "C2MOVE location", "second part of an arc", _CLAMPED, flags="RO"),
    _i(
        "ACCURACY",
        "a",
        "SPEED",
        "ACCURACY mm ALWAYS",
        "COARSE and FINE of AS",
        "a distance in mm",
        "ALWAYS FINE",
        flags="R",
    ),
    _i(
        "DECEL",
        "a",
        "SPEED",
        "DECEL percent ALWAYS",
        "set the deceleration",
        "a percentage",
        "ALWAYS",
        flags="R",
    ),
    _i(
        "STABLE",
        "a",
        "WORD1",
        "STABLE seconds",
        "stop, and wait",
        "a time in seconds",
        flags="RB",
    ),
    _i("UWRIST", "a", "WORD0", "UWRIST", "NOFLIP of AS", means="NOFLIP", flags="RB"),
    _i("DWRIST", "a", "WORD0", "DWRIST", "FLIP of AS", means="FLIP", flags="RB"),
    _i("POINT", "a", "SET", "POINT location = value", "SET of AS", _LOCATION, means="SET"),
    _i("SWAIT", "a", "WORDITEMS", "SWAIT signal", "wait for signals", _SIGNAL),
    _i("TWAIT", "a", "WORD1", "TWAIT seconds", "wait for a time", "a time in seconds"),
    _i("PULSE", "a", "WORD12", "PULSE signal, seconds", "a signal on for a time", _SIGNAL),
    _i(
        "DLYSIG",
        "a",
        "WORD2",
        "DLYSIG signal, seconds",
        "a signal after a time",
        "a signal number | a time in seconds",
    ),
    _i(
        "ON",
        "a",
        "ONCALL",
        "ON signal CALL program, priority",
        "REACT of AS",
        _SIGNAL,
        "CALL GOTO",
        full=True,
    ),
    _i(
        "ONI",
        "a",
        "ONCALL",
        "ONI signal CALL program, priority",
        "REACTI of AS",
        _SIGNAL,
        "CALL GOTO",
        full=True,
    ),
    _i("ONE", "a", "WORD01", "ONE program", "REACTE of AS", "a program", means="REACTE", full=True),
    _i("PRINT", "a", "TYPE", 'PRINT "text", value', "TYPE of AS", means="TYPE"),
    _i("SCALL", "a", "CALLS", "SCALL $name", "CALLS of AS", "a string", means="CALLS"),
    _i(
        "SCASE",
        "a",
        "CASE",
        "SCASE $s OF",
        "CASE of strings",
        "a string",
        "OF",
        means="CASE",
        full=True,
    ),
    _i(
        "SVALUE",
        "a",
        "VALUE",
        'SVALUE "text":',
        "VALUE of strings",
        "a string",
        means="VALUE",
        full=True,
    ),
    _i(
        "XMOVE",
        "a",
        "UNTILSIG",
        "XMOVE location TILL signal",
        "move straight until a signal comes",
        _LOCATION,
        "TILL",
        flags="RO",
        full=True,
    ),
    *(
        _i(usage.split()[0], "a", terminal, usage, about, flags=flags, full=True)
        for terminal, flags, rows in (
            ("DEVICE", "O", kawasaki.LISTS),
            ("DEVICE", "RO", kawasaki.MOTIONS),
            ("DEVICE", "O", kawasaki.OPTIONS),
            ("REST", "O", kawasaki.LINES),
        )
        for usage, about in rows
    ),
)

_VPLUS = (
    *(
        _i(word, "+", "SETTING0", f"{word} ALWAYS", about, "", "ALWAYS", full=True, flags="R")
        for word, about in (
            ("CPON", "blend motions; ENABLE CP with ALWAYS"),
            ("CPOFF", "do not blend motions; DISABLE CP with ALWAYS"),
        )
    ),
    *(
        _i(word, "+", "SETTING0", f"{word} ALWAYS", about, "", "ALWAYS", full=True, flags="RO")
        for word, about in (
            ("NOOVERLAP", "refuse motions that turn a joint the long way round"),
            ("OVERLAP", "take motions that turn a joint the long way round"),
        )
    ),
    _i(
        "SWITCH",
        "+",
        "GIVE",
        "SWITCH CP = state",
        "turn a system switch on or off",
        "the name of a switch",
        full=True,
    ),
    _i(
        "ATTACH", "+", "DEVICE", "ATTACH (unit, mode) name", "take the robot or a device", flags="U"
    ),
    _i("DETACH", "+", "DEVICE", "DETACH (unit)", "give the robot or a device back", flags="U"),
    _i(
        "WRITE",
        "+",
        "DEVICE",
        "WRITE (unit, record, mode) text, ...",
        "write to a device",
        flags="U",
    ),
    _i(
        "WAIT.EVENT",
        "+",
        "WORDLIST",
        "WAIT.EVENT mask, seconds",
        "wait for an event or a time",
        full=True,
    ),
    *(
        _i(word, "+", "REST", usage, about, flags="O", full=True)
        for word, usage, about in (
            ("CALLP", "CALLP pointer(a, b)", "run the program that a pointer stands for"),
            ("SEE", "SEE (unit) program, step", "edit a program"),
        )
    ),
    *(
        _i(word, "+", "TASKCALL", usage, about, flags="O", full=True)
        for word, usage, about in (
            ("EXECUTE", "EXECUTE task program(a), cycles, first, priority", "run a task"),
            ("PRIME", "PRIME task program(a), cycles, first, priority", "make a task ready to run"),
        )
    ),
    *OPAQUE_VPLUS,
)

_OPTIONS = tuple(
    _i(word, "2+1a", "REST", usage, about, flags="O", full=True)
    for word, usage, about in (
        ("WINDOW", "WINDOW %belt = a, b", "conveyor tracking"),
        ("SETBELT", "SETBELT %belt = value", "conveyor tracking"),
        ("DEFBELT", "DEFBELT %belt = location", "conveyor tracking"),
        ("FORCE.FRAME", "FORCE.FRAME", "force control"),
        ("FORCE.MODE", "FORCE.MODE", "force control"),
        ("FORCE.OFFSET", "FORCE.OFFSET", "force control"),
        ("FORCE.READ", "FORCE.READ", "force control"),
        ("PAYLOAD", "PAYLOAD kg", "the mass in the hand"),
    )
)

VPLUS_FORMS = {  # words whose operands are told apart in V+ only
    word.text: word
    for word in (
        _i(
            "JMOVE",
            "+",
            "WORDLIST",
            "JMOVE a, b, c, d, e, f",
            "move to joints in degrees",
            "a joint in degrees",
            full=True,
            flags="R",
        ),
        *(
            _i(word, "+", "DEVICE", usage, "conveyor tracking", full=True, flags="O")
            for word, usage in (
                ("WINDOW", "WINDOW %belt = location, location, program, priority"),
                ("SETBELT", "SETBELT %belt = value"),
                ("DEFBELT", "DEFBELT %belt = location, number, speed, scale"),
            )
        ),
    )
}

INSTRUCTIONS = {
    word.text: word
    for word in (
        *_MOTION,
        *_HANDS,
        *_DATA,
        *_CONTROL,
        *_SIGNALS,
        *_TERMINAL,
        *_VAL,
        *_AS,
        *_VPLUS,
        *_OPTIONS,
    )
}
GROUPS = {  # instructions of VAL-II by what they are for
    name: tuple(word.text for word in words if word.in_val2 and not word.opaque)
    for name, words in (
        ("motion", _MOTION),
        ("hand", _HANDS),
        ("values", _DATA),
        ("control", _CONTROL),
        ("signals", _SIGNALS),
        ("terminal", _TERMINAL),
    )
}
