"""The patches: each breaks one promise of the product in one line."""

from typing import NamedTuple

EXAMPLE = "tests/golden/test_example_01.py"
ENGINE = "tests/unit/engine"
MARK = "tests/unit/check/test_mark.py"
RUNS = "tests/spec/test_spec_run.py"
LANG = "tests/spec/test_spec_lang.py"
VOCABULARY = "tests/unit/lang/test_vocabulary.py"
COLLISION = "tests/unit/check/test_collision.py"
GEOMETRY = "tests/unit/geometry"
COMMANDS = "tests/unit/cli/test_commands.py"
ROBOTS = "tests/unit/robots"
MONITOR = "tests/spec/test_spec_monitor.py"


class Patch(NamedTuple):
    """Replace `before`, which stands once in `file`, by `after`; one of `tests` must fail."""

    name: str
    file: str
    before: str
    after: str
    tests: tuple[str, ...]


PATCHES: tuple[Patch, ...] = (
    Patch(
        "APPRO goes beyond the target",
        "vrts/engine/planner.py",
        "return target @ translation(0.0, 0.0, -distance_mm * MM)",
        "return target @ translation(0.0, 0.0, distance_mm * MM)",
        (EXAMPLE,),
    ),
    Patch(
        "ALWAYS is ignored",
        "vrts/engine/motion_steps.py",
        "if scope is ir.Scope.ALWAYS:",
        "if scope is None:",
        (EXAMPLE,),
    ),
    Patch(
        "OPENI does not wait for the arm",
        "vrts/engine/motion_steps.py",
        "                if not reached(c, c.planner.settled_at):\n"
        "                    return BLOCKED\n"
        "                command_hand(c, action, c.now, cause)",
        "                command_hand(c, action, c.now, cause)",
        (EXAMPLE,),
    ),
    Patch(
        "toppled objects stand",
        "vrts/engine/settle.py",
        "return Rest(height, standing.name, X_touch, stands=False)",
        "return Rest(height, standing.name, X_touch, stands=True)",
        (EXAMPLE,),
    ),
    Patch(
        "objects fall through the air unnoticed",
        "vrts/engine/hand.py",
        "DROP_HEIGHT = 2e-3",
        "DROP_HEIGHT = 2e3",
        (EXAMPLE,),
    ),
    Patch(
        "joint 1 turns the other way",
        "vrts/robots/spherical_wrist.py",
        "s1, c1 = math.sin(q1), math.cos(q1)\n    s23, c23 = math.sin(q2 + q3), "
        "math.cos(q2 + q3)\n    s4, c4 = math.sin(q4), math.cos(q4)\n    s5, c5 = math.sin(q5), "
        "math.cos(q5)\n    s6",
        "s1, c1 = -math.sin(q1), math.cos(q1)\n    s23, c23 = math.sin(q2 + q3), "
        "math.cos(q2 + q3)\n    s4, c4 = math.sin(q4), math.cos(q4)\n    s5, c5 = math.sin(q5), "
        "math.cos(q5)\n    s6",
        (EXAMPLE,),
    ),
    Patch(
        "motions need not be whole ticks",
        "vrts/engine/profile.py",
        "math.ceil(least / tick - TICK_TOLERANCE) * tick",
        "least",
        (EXAMPLE,),
    ),
    Patch(
        "no single precision",
        "vrts/base/numbers.py",
        "return _SINGLE.unpack(_SINGLE.pack(value))[0]",
        "return value",
        ("tests/unit/base/test_numbers.py",),
    ),
    Patch(
        "halves round down",
        "vrts/base/numbers.py",
        "math.floor(value + 0.5) if value >= 0",
        "math.floor(value + 0.49) if value >= 0",
        ("tests/unit/base/test_numbers.py",),
    ),
    Patch(
        "O and T change places",
        "vrts/base/oat.py",
        "so, co = _sine_cosine(o)",
        "so, co = _sine_cosine(t)",
        ("tests/unit/base/test_oat.py",),
    ),
    Patch(
        "the mark is cut, not rounded",
        "vrts/check/score.py",
        "(parts.unrounded / TENTH + Fraction(1, 2)).__floor__()",
        "(parts.unrounded / TENTH).__floor__()",
        (EXAMPLE,),
    ),
    Patch(
        "time counts although something is wrong",
        "vrts/check/score.py",
        "if not faultless(achieved) or achieved.duration_s is None:",
        "if achieved.duration_s is None:",
        (EXAMPLE,),
    ),
    Patch(
        "by-reference arguments are copies",
        "vrts/engine/executable.py",
        "return self._expressions.cell(argument)",
        "find = self._expressions.cell(argument)\n                return lambda c: find(c).copy()",
        (RUNS,),
    ),
    Patch(
        "FOR stops one too early",
        "vrts/engine/steps.py",
        "past = value > limit if",
        "past = value >= limit if",
        (RUNS,),
    ),
    Patch(
        "WAIT looks only once",
        "vrts/engine/steps.py",
        "            if test(c) != 0.0:\n                return following\n            if changes:",
        "            if test(c) is not None:\n"
        "                return following\n            if changes:",
        (RUNS,),
    ),
    Patch(
        "frames compose the wrong way round",
        "vrts/base/pose.py",
        "            multiply(self.rotation, other.rotation),\n",
        "            multiply(other.rotation, self.rotation),\n",
        ("tests/property/test_poses.py",),
    ),
    Patch(
        "results without a schema",
        "vrts/report/json_form.py",
        '"schema": RESULTS_SCHEMA, ',
        "",
        (COMMANDS,),
    ),
    Patch(
        "the cylinder's caps count as its side",
        "vrts/geometry/support.py",
        "return radius * math.hypot(x, y) + half_length * abs(z)",
        "return radius * math.hypot(x, y)",
        (GEOMETRY,),
    ),
    Patch(
        "a contact costs half",
        "vrts/check/task.py",
        "first_contact: Fraction = Fraction(3, 2)",
        "first_contact: Fraction = Fraction(3, 4)",
        (MARK,),
    ),
    Patch(
        "held objects reach their goal",
        "vrts/check/targets.py",
        'return "is still in the hand"',
        "return None",
        ("tests/unit/check/test_held_goal.py",),
    ),
    Patch(
        "the hand holds what only one pad meets",
        "vrts/engine/grip.py",
        "return self.across.lower < 0.0 < self.across.upper",
        "return True",
        (ENGINE,),
    ),
    Patch(
        "joint speeds may be ten times the limit",
        "vrts/check/limits.py",
        "(shares > 1.0 + SPEED_TOLERANCE)",
        "(shares > 10.0)",
        (MARK, "tests/unit/test_pages_run.py"),
    ),
    Patch(
        "blends are bounded by their ends only",
        "vrts/check/high_pieces.py",
        "inside = (turns > a[:, None, None]) & (turns < b[:, None, None])",
        "inside = turns > np.inf",
        ("tests/property/test_curves.py", "tests/unit/check/test_curves.py"),
    ),
    Patch(
        "the browser gets cubics of everything",
        "vrts/report/replay_data.py",
        "    count = len(row)\n",
        "    count = min(len(row), 4)\n",
        ("tests/unit/report/test_replay_data.py",),
    ),
    Patch(
        "one missed via point voids the next",
        "vrts/check/vias.py",
        "for count in range(len(best) - 1, -1, -1):",
        "for count in ([point] if point < len(best) else []):",
        (MARK,),
    ),
    Patch(
        "DRIVE uses up the pending speed",
        "vrts/engine/motion_steps.py",
        "fraction = _fraction(c, Speed(percent, ir.SpeedUnit.PERCENT), cause)",
        "c.planner.take_speed()\n"
        "                    fraction = _fraction(c, Speed(percent, ir.SpeedUnit.PERCENT), cause)",
        (ENGINE,),
    ),
    Patch(
        "the wrist solution farther away is taken",
        "vrts/robots/choice.py",
        "branch, q = min(within, key=",
        "branch, q = max(within, key=",
        ("tests/unit/robots", ENGINE, EXAMPLE),
    ),
    Patch(
        "a run may be asked beyond its horizon",
        "vrts/engine/run.py",
        "if not 0.0 <= time_s <= self.horizon_s:\n            raise OutOfHorizon",
        "if time_s < 0.0:\n            raise OutOfHorizon",
        ("tests/property/test_engine.py", ENGINE),
    ),
    Patch(
        "abbreviations need not be unique",
        "vrts/lang/vocabulary/lookup.py",
        "if len(found) > 1 and dialect.takes_all:",
        "if len(found) > 1:",
        (VOCABULARY,),
    ),
    Patch(
        "AND binds after comparisons in VAL-II",
        "vrts/lang/dialect.py",
        'VAL2 = Dialect("val2", "VAL-II", "2", False, Angles.OAT, Precedence.A, _STRICT_LINE)',
        'VAL2 = Dialect("val2", "VAL-II", "2", False, Angles.OAT, Precedence.B, _STRICT_LINE)',
        (LANG, RUNS),
    ),
    Patch(
        "V+ angles are taken for O, A, T",
        "vrts/lang/dialect.py",
        'VPLUS = Dialect("vplus", "V+", "+", True, Angles.ZYZ,',
        'VPLUS = Dialect("vplus", "V+", "+", True, Angles.OAT,',
        (LANG, RUNS),
    ),
    Patch(
        "EXIT goes to the next pass",
        "vrts/lang/lower.py",
        'jumps = self.leaving if node.word == "EXIT" else self.continuing',
        'jumps = self.continuing if node.word == "EXIT" else self.leaving',
        (LANG, RUNS),
    ),
    Patch(
        "AUTO variables are shared by all calls",
        "vrts/engine/executable.py",
        "slots += [_fresh(callee, auto) for auto in callee.autos]",
        "slots += self.fresh_slots(number)[len(slots) :] if not c.frames else c.slots[:0]",
        (RUNS, LANG),
    ),
    Patch(
        "the formatter glues signs together",
        "vrts/lang/spelling_of_tokens.py",
        "return True  # `a- -b`",
        "return False",
        ("tests/unit/lang/test_layout.py",),
    ),
    Patch(
        "the formatter moves comments",
        "vrts/lang/layout.py",
        "return row.ljust(max(column, len(row) + 2)) + comment",
        "return row + comment",
        ("tests/unit/lang/test_layout.py",),
    ),
    Patch(
        "a double is rounded twice on its way through STORE",
        "vrts/lang/decimals.py",
        "return float(_DIGITS.multiply(Decimal(text), _MM))",
        "return float(text) * 0.001",
        ("tests/property/test_store_laws.py",),
    ),
    Patch(
        "unreachable steps are not seen",
        "vrts/lang/flow.py",
        "if isinstance(instruction, i.Jump | i.NextFor | i.Stop | i.Halt | i.ReturnError):",
        "if isinstance(instruction, i.NextFor):",
        (LANG,),
    ),
    Patch(
        "text of programs reaches the terminal raw",
        "vrts/report/plain.py",
        'return _disarmed("".join(seen))',
        "return text",
        ("tests/unit/report",),
    ),
    Patch(
        "$DECODE leaves its piece in the variable",
        "vrts/engine/pieces.py",
        "return text[:end], text[end:]",
        "return text[:end], text",
        (RUNS,),
    ),
    Patch(
        "vrts support calls everything simulated",
        "vrts/report/support.py",
        "return RUNS if all(simulates(instruction) for instruction in own) else COMPILES",
        "return RUNS",
        ("tests/unit/report/test_support.py",),
    ),
    Patch(
        "one dialect is detected by a single word",
        "vrts/lang/detection.py",
        "_ENOUGH = 2",
        "_ENOUGH = 1",
        (LANG,),
    ),
    Patch(
        "arms without branches take the farthest solution",
        "vrts/robots/serial_solutions.py",
        "(bool(limit_violations(arm, q)), _change(q, near))",
        "(bool(limit_violations(arm, q)), -_change(q, near))",
        (ROBOTS,),
    ),
    Patch(
        "the axes of described joints are their x axes",
        "vrts/robots/urdf.py",
        "align = Pose(_from_z(joint.axis), (0.0, 0.0, 0.0))",
        "align = Pose(_from_z(X_AXIS), (0.0, 0.0, 0.0))",
        (ROBOTS, "tests/oracle/test_kinematics_oracle.py"),
    ),
    Patch(
        "many poses at once ignore the wrist asked for",
        "vrts/robots/batch_inverse.py",
        "sign = -1.0 if branch.wrist is Wrist.FLIP else 1.0",
        "sign = 1.0",
        (ROBOTS,),
    ),
    Patch(
        "links of a scene's folder lead anywhere",
        "vrts/scene/files.py",
        "if not place.is_relative_to(folder):",
        "if not place:",
        ("tests/unit/scene/test_robot_section.py",),
    ),
    Patch(
        "entities of a description are expanded",
        "vrts/robots/xml_tree.py",
        "parser.StartDoctypeDeclHandler = document_type",
        "parser.StartDoctypeDeclHandler = None",
        (ROBOTS,),
    ),
    Patch(
        "monitor forgets BASE",
        "vrts/monitor/values.py",
        "return now.state.base @ now.state.X_WT",
        "return now.state.X_WT",
        (MONITOR,),
    ),
    Patch(
        "monitor takes every command while a program executes",
        "vrts/monitor/monitor.py",
        "if word.text in IDLE_ONLY and now.executing:",
        "if word.text in IDLE_ONLY and False:",
        (MONITOR,),
    ),
    Patch(
        "monitor executes programs with bad lines",
        "vrts/monitor/execution.py",
        "if program.program is None:",
        "if False:",
        (MONITOR,),
    ),
    Patch(
        "monitor deletes what others use",
        "vrts/monitor/texts.py",
        "if callers <= gone | {called} and called not in kept:",
        "if called not in kept:",
        (MONITOR,),
    ),
    Patch(
        "monitor works expressions out in the run itself",
        "vrts/monitor/dialogue.py",
        "fork = advance(run, until, commands)",
        "fork = self.controller.run = advance(run, until, commands)",
        ("tests/unit/monitor/test_dialogue.py",),
    ),
    Patch(
        "monitor follows links",
        "vrts/monitor/folder.py",
        "if path.is_symlink() or (path.exists() and not path.is_file()):",
        "if path.exists() and not path.is_file():",
        ("tests/unit/monitor/test_folder.py",),
    ),
    Patch(
        "monitor overwrites files unasked",
        "vrts/monitor/folder.py",
        "            if not replace:",
        "            if False:",
        ("tests/unit/monitor/test_folder.py",),
    ),
    Patch(
        "pendant mixes the frames of its axes up",
        "vrts/monitor/pendant.py",
        'return f"MOVES HERE:TRANS({',
        'return f"MOVES SHIFT(HERE BY {',
        ("tests/unit/monitor/test_pendant.py",),
    ),
)
