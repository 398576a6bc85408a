"""Instructions of V+ that no simulator of an arm carries out: files, tasks, windows, vision.

One row a word: how it is written, what it does. The grammar and the numbers of operands follow
from how it is written (`room.py`), so a step with one is read like any other, and a run stops
where it is reached. Kinds and operands are those of the V and V+ Quick Reference Guide, version
10.1, and of the reference guides after it.
"""

from vrts.lang.vocabulary.word import Place, Word

_FILES = (
    ("READ (unit, record, mode) variable, ...", "read from a device"),
    ("FOPEN (unit, mode) name, ...", "open a file, a window or a connection"),
    ("FOPENA (unit, length, mode) name, ...", "open a file to append"),
    ("FOPEND (unit, length, mode) name, ...", "open a folder"),
    ("FOPENR (unit, length, mode) name, ...", "open a file to read"),
    ("FOPENW (unit, length, mode) name, ...", "open a file to write"),
    ("FCLOSE (unit)", "close a file"),
    ("FDELETE (unit) name", "delete a file"),
    ("FEMPTY (unit)", "empty a buffer"),
    ("FSEEK (unit, record)", "go to a record"),
    ("FCMND (unit, command) out, in", "give a device a command"),
    ("FSET (unit) attributes, ...", "set up a device"),
    ("SETDEVICE (kind, unit, error, command) a, ...", "set up a device"),
    ("DEVICE (kind, unit, error, a, ...) out[], in[], out, in", "send data to a device"),
    ("DEVICES (kind, unit, error, a, ...) out, in", "send strings to a device"),
    ("INSTALL password, option", "install an option"),
    ("KEYMODE first, last = mode, setting", "how keys of the manual control work"),
    ("PDNT.CLEAR", "clear the display of the manual control"),
    ("PDNT.NOTIFY a, ...", "show a message on the manual control"),
    ("PDNT.WRITE a, ...", "write to the manual control"),
    ("AIO.OUT channel = number", "write to an analog output"),
    ("IOPUTB address, kind = number", "write a byte to the bus"),
    ("IOPUTD address, kind = number", "write a number of double precision to the bus"),
    ("IOPUTF address, kind = number", "write a number to the bus"),
    ("IOPUTL address, kind = number", "write 32 bits to the bus"),
    ("IOPUTS address, kind = number", "write a string to the bus"),
    ("IOPUTW address, kind = number", "write 16 bits to the bus"),
    ("DEF.DIO number = address, kind", "give signals an address on the bus"),
)

_TASKS = (
    ("ABORT task", "stop a task"),
    ("CLEAR.EVENT task, mask, processor", "clear an event of a task"),
    ("CYCLE.END task, flag", "wait until a task has ended"),
    ("DOS text, error", "carry out an instruction that a string holds"),
    ("ESTOP", "stop as the emergency button does"),
    ("INT.EVENT source, level", "send an event at an interrupt"),
    ("KILL task", "clear a stopped task"),
    ("MCS text", "give the monitor a command that a string holds"),
    ("PANIC", "stop everything at once"),
    ("PROCEED task", "let a stopped task go on"),
    ("RELEASE task", "let other tasks run"),
    ("RETRY task", "repeat the step of a stopped task"),
    ("RUNSIG number", "an output that is on while the task runs"),
    ("SELECT kind = number", "choose the robot, or another device, that the task means"),
    ("SET.EVENT task, mask, processor", "set an event of a task"),
    ("TIME text", "set the clock"),
)

_ROBOT = (
    ("AMOVE axis = position", "move an extra axis with the next motion"),
    ("CALIBRATE mode, status", "calibrate the joints"),
    ("GAIN.SET number, motor", "choose the gains of a motor"),
    ("JHERE a, b, c, d, e, f, g, h, i, j, k, l", "store the present joints in variables"),
    ("JOG (status) robot, mode, axis, rate, location, near", "move by hand"),
    ("MOVEC location, location", "move on an arc"),
    (
        "MOVEF location, back, near, torque, acceleration, torque, model",
        "pick and place as fast as possible",
    ),
    (
        "MOVESF location, back, near, torque, acceleration, torque, model",
        "pick and place straight, as fast as possible",
    ),
    ("ROBOT.OPR (mode, state, kind) number[], ...", "operations of some robots"),
    (
        "SOLVE.ANGLES joints[0], flags, error = location, joints[0], flags",
        "joints of a location",
    ),
    ("SOLVE.TRANS location, error = joints[0]", "location of joints"),
    ("SPIN rate, ...", "turn joints without end"),
)

_GRAPHICS = (
    ("GARC (unit, mode) x, y, radius, first, last", "draw an arc in a window"),
    ("GCHAIN (unit) x, y, points, direction[0]", "draw a chain of points"),
    ("GCLEAR (unit)", "clear a window"),
    ("GCLIP (unit) x, y, dx, dy", "draw in a part of a window only"),
    ("GCOLOR (unit) front, back", "choose colours"),
    ("GCOPY (unit) x, y = x, y, dx, dy", "copy a part of a window"),
    ("GETEVENT (unit, mode) events[0]", "read what was done in a window"),
    ("GFLOOD (unit) x, y", "fill a part of a window"),
    ("GGET.LINE (unit) data[0] = x, y, n", "read points of a window"),
    ("GGETLINE (unit) data[0], n = x, y, n", "read points of a window"),
    ("GICON (unit, mode) x, y, name, index", "draw an icon"),
    ("GLINE (unit) x, y, x, y", "draw a line"),
    ("GLINES (unit, mode) points, data[0]", "draw many lines"),
    ("GLOGICAL (unit) code, planes", "how what is drawn meets what is there"),
    ("GPANEL (unit, mode) x, y, dx, dy", "draw a panel"),
    ("GPOINT (unit) x, y", "draw a point"),
    ("GRECTANGLE (unit, mode) x, y, dx, dy", "draw a rectangle"),
    ("GSCAN (unit) lines, data[0]", "draw horizontal lines"),
    ("GSLIDE (unit, mode) id = x, y, length, most, change, handle", "draw a slide bar"),
    ("GTEXTURE (unit) mode, pattern", "choose a pattern"),
    ("GTRANS (unit, mode) a, ...", "how what is drawn is moved and turned"),
    ("GTYPE (unit, mode) x, y, text, font, path, turn", "write in a window"),
)

_VISION = (
    ("VADD (kind) frame = frame, frame", "add images"),
    ("VAUTOTHR (mode, first, last) data[0] = frame", "find thresholds"),
    ("VCONVOLVE (kind, a) frame = frame, frame", "filter an image"),
    ("VCOPY (a) frame = frame", "copy an image"),
    ("VCORRELATE (camera, a, ...) data[0] = a, ...", "find a template"),
    ("VDEF.AOI area = shape, a, ...", "define an area"),
    ("VDEF.CONVOLVE kind = data[,]", "define a filter"),
    ("VDEF.FONT (mode) font, chars, height, black", "define a font"),
    ("VDEF.MORPH kind = data[]", "define an operator"),
    ("VDEF.SUBPROTO name, first, last", "define a part of a prototype"),
    ("VDEFGRIP name, grip, mode, fingers, place[0], w[0], h[0]", "define a grip"),
    ("VDELETE name", "delete a prototype"),
    ("VDISPLAY (camera) mode, overlay, a, ...", "choose what the vision monitor shows"),
    ("VEDGE (kind, threshold, a) frame = frame, frame", "find edges"),
    ("VEDGE.INFO data[0] = name, edge", "what is known of an edge"),
    ("VFIND.ARC (camera, a, ...) data[0] = a, ...", "fit an arc"),
    ("VFIND.LINE (camera, a, ...) data[0] = a, ...", "fit a line"),
    ("VFIND.POINT (camera, a, ...) data[0] = a, ...", "find a point"),
    ("VFINDER (camera, a, ...) data[0] = a, ...", "find objects"),
    ("VGAPS data[0] = name, edge", "gaps of a match"),
    ("VGETCAL (camera) data[0], place", "read the calibration of a camera"),
    ("VGETPIC (camera, a, ...) picture[0] = a, ...", "read an image"),
    ("VHISTOGRAM (mode, a) data[0] = frame, a", "count grey levels"),
    ("VLOAD (unit) name", "load prototypes"),
    ("VLOCATE (camera, mode, order) name, place", "find an object"),
    ("VMASK (camera, a, ...) a = a, ...", "hide a part of an image"),
    ("VMORPH (kind, a) frame = frame", "transform an image"),
    ("VOCR (camera, a, ...) data[0], place[0] = a, ...", "read characters"),
    ("VPARAMETER (sequence, a, ...) name = number", "set a parameter of vision"),
    ("VPICTURE (camera, a, ...) mode, number", "take a picture"),
    ("VPLAN.FINDER (camera, a, ...) a, ...", "plan how to find objects"),
    ("VPUTCAL (camera) data[0], place", "set the calibration of a camera"),
    ("VPUTPIC (camera, a, ...) picture[0], x, y", "store an image"),
    ("VRULERI (camera, a, ...) data[0], more[0] = a, ...", "edges along a line or an arc"),
    ("VRUN (sequence, a, ...) a, ...", "run a sequence of vision"),
    ("VSELECT frame, a", "choose an image"),
    ("VSHOW mode, name, place, grip, edge", "show a prototype"),
    ("VSHOW.MODEL (mode) name, data[0] = font, a, ...", "show fonts"),
    ("VSTATUS (camera, kind) data[0]", "state of vision"),
    ("VSTORE (unit) name = model, ...", "store prototypes"),
    ("VSUBPROTO percent, place = name, edge", "how much of a part was found"),
    ("VSUBTRACT (kind, a) frame = frame, frame", "subtract images"),
    ("VTHRESHOLD (kind, a, b) frame = frame", "make an image black and white"),
    ("VTRAIN name, shape, x, y, w, h, angle", "train a prototype"),
    ("VTRAIN.FINDER (camera, a, ...) a, ...", "train a finder"),
    ("VTRAIN.MODEL (camera, plan) font, text, shape, x, y, dx, dy, angle", "train a font"),
    ("VWAIT (mode) a", "wait for vision"),
    ("VWAITI (sequence, a, ...) a, ...", "wait for a sequence of vision"),
    ("VWINDOW (camera, a, ...) a, ...", "look at a part of an image"),
    ("VWINDOWI (camera, a, ...) data[0] = a, ...", "read a part of an image"),
)


def _word(usage: str, about: str) -> Word:
    text, _, rest = usage.partition(" ")
    return Word(
        text,
        Place.INSTRUCTION,
        "+",
        "DEVICE",
        usage,
        about,
        full=True,
        unit=rest.startswith("("),
        opaque=True,
    )


OPAQUE_VPLUS = tuple(_word(*row) for row in (*_FILES, *_TASKS, *_ROBOT, *_GRAPHICS, *_VISION))
