"""Commands of the monitors of V+ and AS that VAL-II has not: what each is, in a few words.

[VplusOS] and [AS2015] chapter 5. None of them is carried out: a program file that holds one, or
somebody who types one, is told what it is.
"""

from functools import cache

from vrts.lang.dialect import Dialect

_Group = tuple[str, str]  # what the commands of a group do, and their words

_OF_VPLUS: tuple[_Group, ...] = (
    ("read, set and wait for signals", "BITS"),
    ("handle the files of the controller", "CD DEFAULT FSET MDIRECTORY NET PASSTHRU PING"),
    ("handle programs and their modules", "DELETEM LISTB MODULE STOREM"),
    ("look into programs that run", "DEBUG STACK TESTP"),
    ("run commands from a file", "COMMANDS WAIT.START"),
    ("edit a program", "SEE"),
    ("move or stop the robot", "ALIGN ESTOP JOG"),
    ("set up the robots and the controller", "INSTALL SELECT SRV.NET SRV.RESET"),
    (
        "handle pictures and models of vision",
        (
            "VAUTOTHR VDEF.SUBPROTO VDELETE VDISPLAY VHISTOGRAM "
            "VLOAD VPICTURE VQUEUE VRENAME VSHOW "
            "VSTATUS VSTORE VTRAIN"
        ),
    ),
)

_OF_AS: tuple[_Group, ...] = (
    ("list and trace programs", "LIST LSTRACE RESTRACE SETTRACE TRACE"),
    (
        "save and load programs and data",
        (
            "SAVE SAVE/ALLLOG SAVE/ELOG SAVE/FULL SAVE/OPLOG SAVE/P SAVE/ROB SAVE/STG SAVE/SYS "
            "USB_COPY USB_FDEL USB_FDIR USB_LOAD USB_MKDIR USB_RENAME USB_SAVE USB_SAVE/ALLLOG "
            "USB_SAVE/ELOG USB_SAVE/OPLOG USB_SAVE/P USB_SAVE/ROB USB_SAVE/SYS XFER"
        ),
    ),
    (
        "run and stop programs",
        "CONTINUE HOLD MSTEP PCCONTINUE PCKILL PCSTEP SLOW_REPEAT STEP STPNEXT",
    ),
    (
        "show what the controller noted",
        (
            "CHSUM ENV2_DATA ENV_DATA ERRLOG FFSET_STATUS IOBOARD_STATUS IPEAKCLR IPEAKLOG OPEINFO "
            "OPEINFOCLR OPLOG REFFLTSET_STATUS"
        ),
    ),
    (
        "show the words of the language",
        "HELP/DO HELP/F HELP/M HELP/MC HELP/P HELP/PPC HELP/SW",
    ),
    (
        "set up the controller",
        "DEFSIG ENCCHK_EMG ENCCHK_PON ERESET HSETCLAMP REC_ACCEPT SYSINIT ZPOWER ZSIGSPEC ZZERO",
    ),
    (
        "set what instructions set too",
        (
            "BITS BITS32 DLYSIG ENA_TOOLSHAPE HSENSE "
            "HSENSESET IFPLABEL IFPTITLE IFPWOVERWRITE IFPWPRINT "
            "LLIMIT OFF ON OUTDA POINT/18 POINT/7 "
            "POINT/A POINT/EXT POINT/O POINT/OAT POINT/T POINT/X "
            "POINT/Y POINT/Z PRINT PULSE SCNT SCNTRESET SET2HOME SETHOME SETOUTDA SETPICK SETPLACE "
            "SET_TOOLSHAPE SFLK SFLP SOUT STIM TOOLSHAPE TPLIGHT TYPE ULIMIT WEIGHT"
        ),
    ),
)

# what MC of AS gives the monitor [AS2015] 6.9, and what programs give it too
GIVEN_BY_PROGRAMS = frozenset({"ABORT", "CONTINUE", "ERESET", "EXECUTE", "HOLD", "SPEED"})


def _words(groups: tuple[_Group, ...]) -> dict[str, str]:
    return {word: about for about, words in groups for word in words.split()}


COMMANDS_OF = {"+": _words(_OF_VPLUS), "a": _words(_OF_AS)}


@cache
def commands_of(dialect: Dialect) -> dict[str, str]:
    """Return what each command does that a dialect has beside those of VAL-II.

    In VAL-II itself those of all relatives count, so that whoever types one is told whose it is.
    """
    letters = [letter for letter in COMMANDS_OF if dialect.has(letter)]
    found: dict[str, str] = {}
    for letter in letters or COMMANDS_OF:
        for word, about in COMMANDS_OF[letter].items():
            found.setdefault(word, about)
    return found


def languages_of(word: str) -> str:
    """Return the columns of the languages whose monitors have a command."""
    return "".join(letter for letter, words in COMMANDS_OF.items() if word in words)
