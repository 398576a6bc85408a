"""Every command of the debugger: its words, and what it does. Help and manual are made of this."""

from typing import NamedTuple


class Entry(NamedTuple):
    """A command."""

    word: str
    rest: str  # what follows the word; `[x]` may be left out
    says: str  # what it does, as the help has it
    group: str

    @property
    def usage(self) -> str:
        """Return the command as it is written."""
        return f"{self.word} {self.rest}".strip()


GO, STOP, LOOK, CHANGE = "Go", "Stop", "Look", "Change"

COMMANDS = (
    Entry("step", "[into|over|out|back]", "the next step; `over` calls without a word", GO),
    Entry("tick", "[back]", "one set point of the arm, forward or back", GO),
    Entry("continue", "", "to the next stop, or to the end", GO),
    Entry("reverse", "", "to the last stop before, or to the beginning", GO),
    Entry("to", "LINE", "to the next time the line is executed", GO),
    Entry("at", "TIME [step N]|begin|end", "to a time [s], where N statements are finished", GO),
    Entry("go", "[NUMBER|NAME]", "to a row with this number that was shown last, or to a mark", GO),
    Entry("mark", "NAME", "gives this place a name, to `go` to", GO),
    Entry("marks", "[keep]", "lists marks; `keep`: in a file beside the program or run", GO),
    Entry("unmark", "NAME|all", "no such mark any more", GO),
    Entry("link", "", "what opens this place: a command, a page, the line in an editor", GO),
    Entry("restart", "", "the beginning again, with the files as they are now", GO),
    Entry("program", "[robot|process]", "whose steps are gone: robot program, process control", GO),
    Entry(
        "break",
        "LINE[:CONDITION] [hits RULE] [log TEXT]",
        "stop at a line: where a condition holds, at some hits (`5`, `>= 5`, `% 3`); or log there",
        STOP,
    ),
    Entry("unbreak", "LINE|all", "no breakpoint there any more", STOP),
    Entry("watch", "NAME", "stop when a variable, a location or a signal (`SIG(3)`) changes", STOP),
    Entry("unwatch", "NAME|all", "no more", STOP),
    Entry(
        "alarms", "[KIND ...|all|none]", "which alarms stop; without a word: which there are", STOP
    ),
    Entry("stops", "", "lists breakpoints, watches and alarms", STOP),
    Entry("print", "EXPRESSION", "the value of an expression here", LOOK),
    Entry("where", "", "the programs under way, and where the arm is", LOOK),
    Entry("state", "", "all that can be seen here: variables, arm, things, signals", LOOK),
    Entry("why", "[NAME]", "why the arm does what it does, or a name has its value", LOOK),
    Entry("who", "NAME", "which step changed a value, a signal, a thing or HERE last", LOOK),
    Entry("next", "NAME", "when it changes next, and by which step", LOOK),
    Entry(
        "events",
        "[WORD ...] [where CONDITION] [by COLUMN [down]] [first N|last N]",
        "what happens in the run, in rows to `go` to: `events where body = can1 and depth > 1`",
        LOOK,
    ),
    Entry(
        "calls",
        "[WORD ...] [where CONDITION] [by COLUMN [down]] [first N|last N]",
        "calls of programs: `calls where program = pick and took > 2 by took down`",
        LOOK,
    ),
    Entry("help", "[COMMAND]", "lists these commands", LOOK),
    Entry("assert", "EXPRESSION", "fails where an expression is zero, and says its value", LOOK),
    Entry("set", "NAME = VALUE", "another value from here on: another future", CHANGE),
    Entry("jump", "LINE", "the step of the line comes next: another future", CHANGE),
    Entry("answer", "TEXT", "what the program gets that waits for a line", CHANGE),
    Entry(
        "reload", "", "the files as they are now, from before the first step that differs", CHANGE
    ),
    Entry("branches", "", "the futures so far: where each forked, and by what", CHANGE),
    Entry("branch", "NAME", "to another future, at the same time", CHANGE),
    Entry("undo", "", "to the future before the last change", CHANGE),
    Entry("redo", "", "what was undone, again", CHANGE),
    Entry("name", "NAME", "a name for this future, which is kept then", CHANGE),
    Entry(
        "keep",
        "[NAME] [yes]",
        "shows the literal that a value set by hand is written back to; `yes` writes it",
        CHANGE,
    ),
    Entry(
        "would",
        "NAME|LINE",
        "the value there that would earn the full mark, as far as the task allows hints",
        CHANGE,
    ),
    Entry("compare", "A B", "two futures: mark, clearance, time, lost points", CHANGE),
)
BY_WORD = {entry.word: entry for entry in COMMANDS}
ELSE = "Any other line is an expression, `x = 5`, or a command of the monitor."


def help_lines(word: str = "") -> list[str]:
    """Return the help of all commands, or of one; nothing where there is no such command."""
    found = [BY_WORD[word]] if word in BY_WORD else [] if word else list(COMMANDS)
    lines = [f"{entry.usage}: {entry.says}" for entry in found]
    return lines if word else [*lines, ELSE]
