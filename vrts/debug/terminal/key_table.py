"""Every key of the debugger at the terminal, and what it does. Help and manual are made of this."""

from typing import NamedTuple


class Key(NamedTuple):
    """A key."""

    shown: str
    says: str
    group: str
    names: tuple[str, ...]  # as the keyboard takes them
    command: str = ""  # the command that does the same; empty: there is none


FORWARD, BACK, TEXT, STOPS, MORE = "Forward", "Backward", "In the text", "Stops", "More"

KEYS = (
    Key("n", "the next step, over calls", FORWARD, ("n",), "step"),
    Key("s", "the next step, into calls", FORWARD, ("s",), "step into"),
    Key("o", "out of this program", FORWARD, ("o",), "step out"),
    Key("c", "to the next stop", FORWARD, ("c",), "continue"),
    Key("t", "one set point of the arm", FORWARD, ("t",), "tick"),
    Key("right", "0.1 s", FORWARD, ("right",)),
    Key("end", "the end", FORWARD, ("end",), "at end"),
    Key("N, S", "back to where the last step came from", BACK, ("N", "S"), "step back"),
    Key("C", "to the last stop before", BACK, ("C",), "reverse"),
    Key("T", "one set point back", BACK, ("T",), "tick back"),
    Key("left", "0.1 s back", BACK, ("left",)),
    Key("home", "the beginning", BACK, ("home",), "at begin"),
    Key("up, down", "choose a line", TEXT, ("up", "down")),
    Key("PgUp, PgDn", "... ten lines further", TEXT, ("page up", "page down")),
    Key("g", "run to the line", TEXT, ("g",), "to"),
    Key("j", "go on with the line next (another future)", TEXT, ("j",), "jump"),
    Key("b", "breakpoint at the line, or none any more", STOPS, ("b",), "break"),
    Key("B", "... with a condition, hits or a log: asks for each", STOPS, ("B",), "break"),
    Key("w", "stop when a variable or a signal changes", STOPS, ("w",), "watch"),
    Key("a", "which alarms stop", STOPS, ("a",), "alarms"),
    Key("y", "why the arm does what it does", MORE, ("y",), "why"),
    Key("e", "the events of the run, as a list: Enter goes to one", MORE, ("e",), "events"),
    Key(":", "a command (below), an expression, `x = 5`, the monitor's commands", MORE, (":",)),
    Key("p", "robot program or process control program", MORE, ("p",), "program"),
    Key("v", "see this moment in 3D", MORE, ("v",)),
    Key("V", "... in the Rerun viewer", MORE, ("V",)),
    Key("r", "again from the beginning, with the files as they are now", MORE, ("r",), "restart"),
    Key("R", "on with the text as it is saved now (another future)", MORE, ("R",), "reload"),
    Key("u", "to the future before the last change", MORE, ("u",), "undo"),
    Key("U", "... and back", MORE, ("U",), "redo"),
    Key("?", "this help", MORE, ("?",)),
    Key("Ctrl-C", "stops what is under way", MORE, ()),
    Key("q, Ctrl-D", "end", MORE, ("q",)),
)
WHILE_TYPING = (
    "While you type: left, right, Ctrl-A and Ctrl-E move, Ctrl-K, Ctrl-U and Ctrl-W delete,"
    " up and down bring earlier lines back, Tab completes, Escape leaves."
)


def help_of_keys() -> list[str]:
    """Return the help of all keys, in lines."""
    lines: list[str] = []
    for k, key in enumerate(KEYS):
        if k == 0 or KEYS[k - 1].group != key.group:
            lines += ["", key.group] if lines else [key.group]
        lines.append(f"  {key.shown:<10} {key.says}")
    return [*lines, "", WHILE_TYPING]
