"""Functions of V+ that are never carried out: devices, the bus, tasks, belts, vision.

One row a function: name, what it takes, what it yields, and what that is. Parameters are written
as in `functions.py`, with `x` for anything at all; a result is `r` real, `s` string, `p` pose or
`j` joints; `bare` may stand without parentheses.
"""

from typing import NamedTuple


class OpaqueFunction(NamedTuple):
    """A function that is known, and never carried out."""

    name: str  # lower case, with its sigil
    parameters: str
    result: str
    about: str
    bare: bool = False


_ROWS = (
    # devices and files
    ("aio.in", "x x?", "r", "value on an analog input"),
    ("aio.ins", "x", "r", "whether there is an analog channel"),
    ("device", "x x? x? x*", "r", "data of a device"),
    ("getc", "x x?", "r", "next character of a device"),
    ("iostat", "x x? x?", "r", "result of a device"),
    ("iogetb", "x x? x?", "r", "byte on the bus"),
    ("iogetd", "x x? x?", "r", "number of double precision on the bus"),
    ("iogetf", "x x? x?", "r", "number on the bus"),
    ("iogetl", "x x? x?", "r", "32 bits on the bus"),
    ("$iogets", "x x? x? x?", "s", "string on the bus"),
    ("iogetw", "x x? x?", "r", "16 bits on the bus"),
    ("iotas", "x x? x?", "r", "byte on the bus, which is then set"),
    ("network", "x x?", "r", "state of the network"),
    ("$default", "x? x?", "s", "name of the default disk", "bare"),
    ("$defaults", "x? x?", "s", "name of the default disk", "bare"),
    # the controller and its tasks
    ("get.event", "x? x?", "r", "events of a task"),
    ("hour.meter", "", "r", "hours that the robot had power", "bare"),
    ("id", "x x? x?", "r", "what the controller is made of"),
    ("$id", "x x? x?", "s", "what the controller is made of, in words"),
    ("select", "x x?", "r", "number of the device that is chosen"),
    ("$symbol", "x", "s", "name of what a pointer stands for"),
    ("symbol.ptr", "x x?", "r", "pointer to a program"),
    ("task", "x? x? x?", "r", "number of the task"),
    ("tps", "", "r", "ticks of the clock in a second", "bare"),
    ("sig.ins", "x", "r", "whether there is a signal"),
    # the robot
    ("accel", "x", "r", "setting of the acceleration"),
    ("config", "x? x?", "r", "arm branch and state of the servos", "bare"),
    ("duration", "x", "r", "setting of the duration"),
    ("latched", "x?", "r", "whether a position was latched"),
    ("latch", "x?", "p", "pose when the latch closed"),
    ("#platch", "x?", "j", "joints when the latch closed"),
    ("#set.point", "", "j", "joints that the servos are told", "bare"),
    ("solve.flags", "x", "r", "arm branch of joints"),
    ("$cal.data", "x", "s", "calibration of the robot"),
    ("belt", "x x?", "r", "position of a belt"),
    ("bstatus", "x?", "r", "state of belts", "bare"),
    ("window", "x x? x?", "r", "where a location is in a window of a belt"),
    # numbers as bytes
    ("bmask", "x x*", "r", "number with some bits set"),
    ("intb", "x x?", "r", "number of bytes as binary"),
    ("lngb", "x x?", "r", "number of bytes as binary"),
    ("fltb", "x x?", "r", "number of bytes as binary"),
    ("dblb", "x x?", "r", "number of bytes as binary"),
    ("$intb", "x", "s", "bytes of a number"),
    ("$lngb", "x", "s", "bytes of a number"),
    ("$fltb", "x", "s", "bytes of a number"),
    ("$dblb", "x", "s", "bytes of a number"),
    ("transb", "x x?", "p", "location of 48 bytes"),
    ("$transb", "x", "s", "48 bytes of a location"),
    # vision
    ("vfeature", "x x?", "r", "what is known of an object"),
    ("vqueue", "x? x?", "r", "number of objects that wait"),
    ("vlocation", "x x? x? x? x? x? x?", "p", "location of an object"),
    ("vparameter", "x x? x? x? x?", "r", "parameter of vision"),
    ("vresult", "x x*", "r", "result of vision"),
    ("$vresult", "x x*", "s", "result of vision, as text"),
    ("vstate", "x x? x?", "r", "state of vision"),
)

OPAQUE_VPLUS_FUNCTIONS = tuple(
    OpaqueFunction(row[0], row[1], row[2], row[3], len(row) > 4) for row in _ROWS
)
