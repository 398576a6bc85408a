"""Programs that watch inputs: motions in threads, and what looks at the inputs meanwhile.

While the arm moves the program passes frame after frame and looks at what it watches. A reaction is
carried out there, so its outputs come at once; REACTI stops the thread that moves the arm before.
Reactions have functions of their own (`r_...`), which note what changes and take no reaction, so
nothing calls itself.
"""

from collections.abc import Iterable
from contextlib import suppress
from typing import NamedTuple

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain
from vrts.dispatch.saying.reactions import Reaction, Shared, called, reaction_of, reacts, shared
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.under_way import left_moving
from vrts.ir import instructions as ir
from vrts.ir.module import Module

THREADS = """
  global v_busy = False
  global v_braking = False
  global v_left = 0.0
  global v_priority = 0.0
  global v_s = 1.0
  global v_x = p[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
  global v_q = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
  thread v_goj():
    movej(v_x, a={joint_a} * v_s, v={joint_v} * v_s, r=0.0)
    global v_busy = False
  end
  thread v_goq():
    movej(v_q, a={joint_a} * v_s, v={joint_v} * v_s, r=0.0)
    global v_busy = False
  end
  thread v_gol():
    movel(v_x, a={linear_a} * v_s, v={linear_v} * v_s, r=0.0)
    global v_busy = False
  end
  thread v_stopping():
    stopj({brake_a})
    global v_braking = False
    global v_busy = False
  end
"""
MOTIONS = """
  def P_pass():
    sync()
    if v_left > 0.0:
      global v_left = v_left - get_steptime()
    end
    LOOK()
  end
  def P_wait():
    while v_busy or (v_left > 0.0):
      P_pass()
    end
  end
  def P_hold(t):
    local left = t
    while left > 0.0:
      P_pass()
      left = left - get_steptime()
    end
  end
  def P_sleep(t):
    P_wait()
    global v_left = t
    P_wait()
  end
  def P_movej(x, r):
    P_wait()
    global v_s = v_share()
    global v_x = pose_trans(v_turn, x)
    global v_at = x
    global v_busy = True
    global v_moving = run v_goj()
    P_wait()
  end
  def P_movejoints(q, r):
    P_wait()
    global v_s = v_share()
    global v_q = q
    global v_at = v_tool(q)
    global v_busy = True
    global v_moving = run v_goq()
    P_wait()
  end
  def P_movel(x, r):
    P_wait()
    global v_s = v_share()
    global v_x = pose_trans(v_turn, x)
    global v_at = x
    global v_busy = True
    global v_moving = run v_gol()
    P_wait()
  end
  def P_drive(k, by, share, r):
    P_wait()
    local q = get_target_joint_positions()
    q[k] = q[k] + v_rad * by
    local kept = v_next
    global v_next = share
    P_movejoints(q, r)
    global v_next = kept
  end
"""
BRAKE = """
  def v_brake():
    global v_left = 0.0
    if v_busy and (not v_braking):
      kill v_moving
      global v_braking = True
      global v_moving = run v_stopping()
    end
  end
"""
TOOK = """
    local kind = v_kind_S
    local before = v_priority
    global v_seen_S = False
    global v_priority = v_level_S
"""
NOTED = """
    local is_S = get_standard_digital_in(PIN)
    if is_S xor v_was_S:
      global v_was_S = is_S
      if (v_kind_S > 0) and (not (is_S xor v_for_S)):
        global v_seen_S = True
      end
    end
"""


class Watching(NamedTuple):
    """All reactions of a program."""

    reactions: tuple[Reaction, ...]
    shared: Shared  # with the programs that are interrupted
    module: Module

    @property
    def programs(self) -> tuple[str, ...]:
        """The programs that are called."""
        return tuple(dict.fromkeys(r.program for r in self.reactions if r.program is not None))

    def number(self, reaction: Reaction) -> int:
        """Return the number of a reaction, from 1."""
        return self.reactions.index(reaction) + 1

    def watch(self, step: ir.React, table: Table) -> list[str]:
        """Return the lines that begin to watch.

        Raises:
            CannotSay: URScript cannot do it so.
        """
        found = reaction_of(step)
        s, name = found.signal, found.program
        if any(found.priority != other.priority for other in self.reactions):
            raise CannotSay("reactions have different priorities", "give all the same")
        if name is not None and self.module.programs[name].formals:
            raise CannotSay(f"`{name}` takes arguments and is called as a reaction")
        if name is not None and left_moving(self.module, name):
            raise CannotSay(f"`{name}` may leave the arm moving", f"end `{name}` with BREAK")
        return [
            f"global v_was_{s} = get_standard_digital_in({table.input(s)})",
            f"global v_for_{s} = {found.on}",
            f"global v_seen_{s} = False",
            f"global v_level_{s} = {found.priority}",
            f"global v_kind_{s} = {self.number(found)}",
        ]

    def ignore(self, signal: int) -> list[str]:
        """Return the lines that end a watch."""
        if signal not in self.signals:
            return ["sync()"]
        return [f"global v_kind_{signal} = 0", f"global v_seen_{signal} = False"]

    @property
    def signals(self) -> tuple[int, ...]:
        """The signals that are watched."""
        return tuple(sorted({reaction.signal for reaction in self.reactions}))

    def notes(self, table: Table) -> list[str]:
        """Return the function that notes what has changed, and its variables."""
        rows = [
            row
            for s in self.signals
            for row in (
                f"  global v_was_{s} = False",
                f"  global v_for_{s} = True",
                f"  global v_seen_{s} = False",
                f"  global v_level_{s} = 0.0",
                f"  global v_kind_{s} = 0",
            )
        ]
        rows.append("  def v_note():")
        for s in self.signals:
            noted = NOTED.replace("PIN", str(table.input(s))).replace("S", str(s))
            rows += noted.strip("\n").split("\n")
        return [*rows, "  end"]

    def looks(self) -> list[str]:
        """Return the functions that take reactions; they stand behind the programs of those."""
        rows: list[str] = [*BRAKE.strip("\n").split("\n")]
        for s in self.signals:
            rows.append(f"  def v_take_{s}():")
            rows += TOOK.strip("\n").replace("S", str(s)).split("\n")
            word = "if"
            for reaction in self.reactions:
                if reaction.signal == s:
                    rows.append(f"    {word} kind == {self.number(reaction)}:")
                    rows += [f"      {row}" for row in _taken(reaction)]
                    word = "elif"
            rows += ["    end", "    global v_priority = before", "  end"]
        rows += ["  def v_look():", "    v_note()", "    local again = True", "    while again:"]
        rows.append("      again = False")
        for s in self.signals:
            rows.append(f"      if v_seen_{s} and (v_level_{s} > v_priority):")
            rows += [f"        v_take_{s}()", "        again = True", "      end"]
        return [*rows, "    end", "  end"]


def _taken(reaction: Reaction) -> Iterable[str]:
    if not reaction.always:
        yield f"global v_kind_{reaction.signal} = 0"
    if reaction.immediate:
        yield "v_brake()"
    if reaction.program is not None:
        yield f"react_{plain(reaction.program)}()"
    yield "sync()"


def motions(prefix: str, look: str) -> list[str]:
    """Return the functions that move the arm and let time pass."""
    return MOTIONS.strip("\n").replace("P_", f"{prefix}_").replace("LOOK", look).split("\n")


def watching(module: Module, entry: str) -> Watching | None:
    """Return what a program watches; None: nothing. What cannot be is told where it stands."""
    steps = reacts(module, entry)
    found: dict[Reaction, None] = {}
    for step in steps:
        with suppress(CannotSay):
            found[reaction_of(step)] = None
    if not steps:
        return None
    watched = Watching(tuple(found), Shared(frozenset(), frozenset()), module)
    return watched._replace(shared=shared(module, called(module, watched.programs)))
