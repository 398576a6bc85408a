"""Reactions: signals that a program watches, and what it does when one changes.

See [manual language/reactions].
"""

from dataclasses import dataclass

ERROR_PRIORITY = 254  # of a program that REACTE names [assumed, manual language/reactions#errors]
MOST_WATCHES = 8  # [assumed, manual language/reactions#number]


@dataclass(slots=True)
class Watch:
    """One watched signal."""

    signal: int
    on: bool  # whether it triggers when the signal comes on
    program: int | None  # number of the executable program
    priority: int
    immediate: bool  # REACTI: the motion is given up when the reaction is taken
    always: bool  # it stays armed
    after_motion: bool  # ON of AS: taken when the motion under way has ended
    state: bool | None  # of the signal when last looked at; None: nobody knows, in a future
    pending: bool = False

    def look(self, state: bool) -> None:
        """Take note of the signal's state at a tick."""
        if self.state is None:
            self.state = state
        elif state is not self.state:
            self.state = state
            if state is self.on:
                self.pending = True

    def copy(self) -> "Watch":
        """Return an independent copy."""
        return Watch(
            self.signal,
            self.on,
            self.program,
            self.priority,
            self.immediate,
            self.always,
            self.after_motion,
            self.state,
            self.pending,
        )
