"""Words of AS that are told apart and never carried out: what published lists hold.

Read from appendix 5 of [AS2015]; `OPTIONS` are in lists for editors, which say nothing of their
operands, and in programs [ASPrograms]; the words of arc welding are remembered. Each row: how it is
written, what it does.
"""

# written as a list of values; where `=` is shown, what is behind it may be left out
LISTS: tuple[tuple[str, str], ...] = (
    ("BITS32 first, count = value", "write a number of 32 bits to outputs"),
    ("BSPEED percent", "set the speed of the block steps"),
    ("CLOSES clamp", "turn the closing signal of a clamp on"),
    ("CLAMP number, ...", "switch clamps"),
    ("COLR value, ...", "set the limits of collision detection when running"),
    ("COLT value, ...", "set the limits of collision detection when teaching"),
    ("CURLIM axis, positive, negative", "set the limits of the current of an external axis"),
    ("ENA_TOOLSHAPE number = on", "let the shape of the tool limit the speed"),
    ("ENVCHKRATE axis, factor", "set the limit of the deviation of an external axis"),
    ("EXTCALL", "run the program that signals choose"),
    ("FFRESET", "reset the gains of acceleration"),
    ("FFSET gain, ...", "set the gains of acceleration"),
    ("GROUP number", "choose a group"),
    ("GUNOFF gun, distance", "turn the signal of a gun off on the way"),
    ("GUNOFFTIMER gun, seconds", "set when the signal of a gun goes off"),
    ("GUNON gun, distance", "turn the signal of a gun on on the way"),
    ("GUNONTIMER gun, seconds", "set when the signal of a gun comes on"),
    ("HSENSE number, result, on, location, error, left", "read what HSENSESET watched"),
    ("HSENSESET number = input, output", "keep the place where a signal comes"),
    ("IFPLABEL position, label, label, label, label", "label a switch of the panel"),
    ("IFPTITLE page, title", "give a page of the panel a title"),
    (
        "IFPWOVERWRITE window, row, column, background, colour = text, ...",
        "write over a window of the panel",
    ),
    (
        "IFPWPRINT window, row, column, background, colour = text, ...",
        "write to a window of the panel",
    ),
    ("LLIMIT location", "set the lower limits of the joints"),
    ("MON_SPEED percent", "set the operator's speed"),
    ("MON_TWAIT seconds", "wait for a time that the operator's speed stretches"),
    ("MVWAIT distance", "wait until the rest of the way is short enough"),
    ("NCHOFF", "turn the notch filter off"),
    ("NCHON", "turn the notch filter on"),
    ("OPENS clamp", "turn the opening signal of a clamp on"),
    ("OUTDA volts, channel", "write to an analog output"),
    ("PCSCAN seconds", "set the cycle of a program beside this one"),
    ("REFFLTRESET", "reset the averaging of commanded values"),
    ("REFFLTSET joints, position, turn, signal", "set the averaging of commanded values"),
    ("RELAXS clamp", "turn the signals of a clamp off"),
    ("RUNMASK signal, count", "outputs that are on only while a program runs"),
    ("SCNT signal = up, down, clear, value", "count signals"),
    ("SCNTRESET signal", "reset a counter"),
    ("SET2HOME mm, location", "say where the second home is"),
    ("SETHOME mm, location", "say where home is"),
    ("SETOUTDA channel = bit, bits, logic, high, low", "set up an analog output"),
    ("SETPICK seconds, ...", "set when clamps begin to close"),
    ("SETPLACE seconds, ...", "set when clamps begin to open"),
    ("SETTIME year, month, day, hour, minute, second", "set the clock"),
    ("SET_TOOLSHAPE number = location, location", "say how the tool is shaped"),
    ("SFLK signal = seconds", "a signal that blinks"),
    ("SFLP output = on, off", "an output that two conditions set and reset"),
    ("SJUMP $name, result", "go on in the program that a string names"),
    ("SOUT signal = condition", "an output that follows a condition"),
    ("STIM signal = input, seconds", "a signal that follows an input after a time"),
    ("TCP_ACCEPT result, port, seconds, address[0]", "take a connection of the network"),
    ("TCP_CLOSE result, socket", "close a connection of the network"),
    ("TCP_CONNECT result, port, address[0], seconds", "open a connection of the network"),
    ("TCP_END_LISTEN result, port", "stop listening on the network"),
    ("TCP_LISTEN result, port", "listen on the network"),
    ("TCP_RECV result, socket, $text[0], number, seconds, length", "receive from a connection"),
    ("TCP_SEND result, socket, $text[0], number, seconds", "send on a connection"),
    (
        "TCP_STATUS number, port[0], socket[0], error[0], more[0], $address[0]",
        "list the connections of the network",
    ),
    ("TOOLSHAPE number", "choose the shape of the tool that limits the speed"),
    ("TPLIGHT", "turn the light of the pendant on"),
    (
        "UDP_RECVFROM result, port, $text[0], number, seconds, address[0], length",
        "receive a message of the network",
    ),
    (
        "UDP_SENDTO result, address[0], port, $text[0], number, seconds",
        "send a message on the network",
    ),
    ("ULIMIT location", "set the upper limits of the joints"),
    ("UTIMER @name = seconds", "set a timer of the user"),
    ("WEIGHT kg, x, y, z, ix, iy, iz", "the mass in the hand"),
)

# written in a way of their own, taken as they stand
LINES: tuple[tuple[str, str], ...] = (
    ("DELETE /P name", "delete programs or variables"),
    ("JUMP program", "go on in another program"),
    ("NLOAD unit = file + file, result", "read files"),
    ("PCKILL number:", "clear a stopped program beside this one"),
    ("SLOAD unit = file, result", "read a file"),
    ("TRACE number: ON", "note what a program does"),
)

# motions that no simulated arm makes
MOTIONS: tuple[tuple[str, str], ...] = (
    ("HMOVE location, clamp", "move straight, with the wrist turning by its joints"),
    *(
        (f"{word} location, ...", "a motion of a controller with more than one arm or axis")
        for word in (
            *("L3LMOVE", "ZL3LMOVE", "L3C1MOVE", "L3C2MOVE", "FJMOVE", "FLMOVE"),
            *("MLJMOVE", "MLLMOVE", "MLC1MOVE", "MLC2MOVE", "MRLMOVE", "MRC1MOVE", "MRC2MOVE"),
        )
    ),
    *(
        (f"{word} location, ...", "a motion along with a conveyor")
        for word in (
            *("CVJMOVE", "CVLMOVE", "CVHMOVE", "CVC1MOVE", "CVC2MOVE", "CVLAPPRO", "CVLDEPART"),
            *("CVL3LMOVE", "CVMLJMOVE", "CVMLL3LMOVE"),
        )
    ),
)

OPTIONS: tuple[tuple[str, str], ...] = tuple(
    (word, about)
    for about, words in (
        (
            "collision detection",
            (
                "COLCALOFF COLCALON COLCOLDOFF COLCOLDON COLINIT COLMVOFF COLMVON COLRJ COLRJOFF "
                "COLRJON COLROFF COLRON COLSTATE COLTJ COLTJOFF COLTJON COLTOFF COLTON DECMPCOLR "
                "DECMPCOLRJ SETCOLTHID"
            ),
        ),
        (
            "conveyor tracking",
            (
                "CVCOOPJT CVDELAY CVENCSGN CVFLS2 CVFMAX CVFNONPITCH CVFPH2 CVGAIN CVMAXSPD "
                "CVPITCH CVPOS CVPOS2 CVRESET CVRESETSIG_DELAY CVSCALE CVSET CVSIMU CVSMAX "
                "CVSPEED CVSWITCH CVWAIT CVXYSIGN SETCCVSLOPE SETLCVSLOPE"
            ),
        ),
        (
            "motion that sensors change",
            "PMODEND PMODLIMIT PMODPRINTDATA PMODSTART PMODTXYZ PMODXYZ PMOD_LINSP PMOD_ROTSP",
        ),
        (
            "signals and analog channels",
            (
                "ADC CNTADC DAOFFSET PLCAIN PLCAOUT RSIGCORRECT RSIGPOINT RSIGRANGE SIGAPPRO "
                "SIGDEPART SIGPOINT ZSIGMAP ZSIGMAP_CLEAR ZSIGSPEC"
            ),
        ),
        (
            "arms that work together",
            (
                "ABSDRIVE ALLERESET ALLROB_SPSET ALONE COOPSTATUS ERR_ALLROBSTOP L3ACCURACY "
                "L3ARMSLOWMODE L3ARMSLOWRATE L3ARMSLOWSET L3JNT L3LINKSLOWMODE L3LINKSLOWRATE "
                "L3LINKSLOWSET L3SPEED L3TOOL L3TRN MASTER SLAVE ROBNETID ROBNETROBOT "
                "ROBNETSIG ROBNET_TCHMASTER ZL3ACCURACY ZL3JNT ZL3TRN"
            ),
        ),
        (
            "sensors and other devices",
            (
                "FB_PORT_ASSIGN FB_RESET_ABCC FB_SET_WORD FB_SIG_ORDER FB_S_CCL SC2RECEIVE SC2SEND "
                "SCPROTOCOL SCSETSIO STRGCLR STRGSET STRGSETIO STRGSTART STRGSTOP TCP_ISLINK"
            ),
        ),
        (
            "limits and other settings",
            (
                "ABS.SPEED FTOOL GETLLIMIT GETLLMIT GETULIMIT MHERE S_HERE FHERE PALMODE "
                "SETENCTEMP_THRES SET_MAXTOOLSHAPENUM ZAREASLOWMODE ZAREASLOWRATE ZAREASLOWSET "
                "ZPOWER ZZERO"
            ),
        ),
        ("a sequence that runs beside programs", "LSQ"),
        ("memory of the controller", "NOEXIST_SET_R ZCNTUP ZIFPOKE"),
        (
            "the controller itself",
            "RTC_SW SAEND SAENVCHKOFF SAENVCHKON SAGAIN SASTART SETAPPLIVER ZMONEXE ZREBOOT",
        ),
        ("a gun for spots, of which one electrode moves", "SGCLEARANS"),
        ("arc welding", "LWS LWC LWE C1WC C2WC C2WE W1SET W2SET"),
    )
    for word in words.split()
)
