"""The robot of a scene as LinuxCNC is configured: INI, HAL, and what the library knows of it."""

from typing import NamedTuple

from vrts.base.units import MM, deg
from vrts.dispatch.linuxcnc.locations import constant
from vrts.dispatch.linuxcnc.names import number
from vrts.dispatch.saying.table import Table
from vrts.engine.run import Run
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of
from vrts.robots.model import Configuration, Elbow, Shoulder, SphericalWristArm, Wrist

JOINT_3 = 180.0  # LinuxCNC's joint 3 (Craig's convention) is VAL's less this [deg]
FASTEST, QUICK = 2000.0, 5000.0  # of axes: they bound nothing, joints do [deg/s, deg/s^2 and mm]
CHAIN = 100_000.0  # acceleration where set points say the motion
AXES = "XYZABC"
MOTION = "servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS num_dio=64 num_aio=8"
MAY_TURN_DEG = 10.0  # of joint 5 along a line: farther from zero the wrist keeps its side
SET_POINTS = 4  # in a tick of the controller
SLOW = 0.3  # share of full speed up to which half as many do
LESS_S = 1e-7  # taken off the time of a set point: whole cycles, never one more [measured]
LEAD_S = 0.3  # by which the interpreter is ahead of set points


class Robot(NamedTuple):
    """What the texts depend on."""

    arm: SphericalWristArm
    run: Run
    table: Table

    @property
    def start(self) -> Configuration:
        """Where the arm stands when the program begins [rad]."""
        return self.run.timeline.configuration(0.0)


def setup_text(robot: Robot) -> str:
    """Return the subroutine that tells the library of arm, hand and pins."""
    arm, scene = robot.arm, robot.run.scene
    model = scene.controller
    branch = branch_of(arm, robot.start, INITIAL_BRANCH, model.branches)
    hand = model.programs.hand_s or scene.robot.gripper.stroke_time
    ticks = -(-hand // arm.tick)
    named = {
        "a2": arm.a2 / MM,
        "a3": arm.a3 / MM,
        "d2": arm.d2 / MM,
        "d4": arm.d4 / MM,
        "d6": arm.d6 / MM,
        "tick": arm.tick,
        "tacc": arm.acceleration_time,
        "least": model.pace.least_accelerations,
        "half": half_s(robot),
        "linear": arm.linear_speed / MM,
        "angular": deg(arm.angular_speed),
        "near_side": model.branches.shoulder_boundary_m / MM,
        "near_elbow": model.branches.elbow_boundary_m / MM,
        "near_wrist": model.branches.wrist_boundary_deg,
        "may_turn": MAY_TURN_DEG,
        "quick": CHAIN,
        "lead": LEAD_S,
        "gate": 0,
        "spacing": arm.tick / SET_POINTS,
        "less": LESS_S,
        "slow": SLOW,
        "hand_time": ticks * arm.tick,
        "open_output": robot.table.hand_open,
        "close_output": robot.table.hand_close,
        "side": 1 if branch.shoulder is Shoulder.LEFTY else -1,
        "elbow": 1 if branch.elbow is Elbow.ABOVE else -1,
        "wrist": 1 if branch.wrist is Wrist.NOFLIP else -1,
        "speed_always": 1,
        **dict.fromkeys(("speed_next", "ask_side", "ask_elbow", "ask_wrist"), 0),
        **dict.fromkeys(("pending", "zone", "n", "hand", "pause", "stays", "joined"), 0),
    }
    rows = [
        f"(the {arm.title}: lengths in mm, angles in degrees, times in s)",
        "o<v_setup> sub",
        *(f"  #<_v_{name}> = {number(value)}" for name, value in named.items()),
        *_six(196, arm.speed),
        *_six(202, arm.lower),
        *_six(208, arm.upper),
        *_six(154, arm.ready),
        *_six(100, robot.start),
        f"  {constant('130', scene.X_FT)}",
        "  o<v_inverse> call [142] [130]",
        "  o<v_here> call [110] [100]",
        "  M68 E1 Q0",
        "o<v_setup> endsub",
        "M2",
    ]
    return "\n".join(rows) + "\n"


def half_s(robot: Robot) -> float:
    """Return half the width of a rounded corner [s], as the engine rounds it."""
    arm, corners = robot.arm, robot.run.scene.controller.corners
    wanted = corners.half_accelerations * arm.acceleration_time
    if arm.blend_time is not None:
        wanted = 0.5 * arm.blend_time
    least = round(0.5 * arm.acceleration_time / arm.tick)
    return arm.tick * max(round(wanted / arm.tick), least)


def _six(at: int, joints: Configuration) -> list[str]:
    return [f"  #{at + k} = {number(round(deg(joint), 9))}" for k, joint in enumerate(joints)]


def ini_text(robot: Robot, name: str) -> str:
    """Return the INI file."""
    arm = robot.arm
    rows = [
        f"# {arm.title}, written by vrts. What is assumed of it stands on the sheet.",
        *_section("EMC", VERSION="1.1", MACHINE=f"{arm.name}-vrts", DEBUG=0),
        *_section("DISPLAY", DISPLAY="axis", CYCLE_TIME=0.1, OPEN_FILE=name),
        *_section("KINS", JOINTS=6, KINEMATICS="genserkins"),
        "[HAL]",
        "HALFILE = machine.hal",
        "POSTGUI_HALFILE = acceleration.hal",
        "",
        *_section(
            "RS274NGC",
            PARAMETER_FILE="parameters.var",
            SUBROUTINE_PATH="library",
            FEATURES=30,
            RS274NGC_STARTUP_CODE="G21 G90 G40 G49 G61.1",
        ),
        *_section("EMCMOT", EMCMOT="motmod", COMM_TIMEOUT=1.0, SERVO_PERIOD=1000000),
        *_section("TASK", TASK="milltask", CYCLE_TIME=0.001),
        *_section("EMCIO", EMCIO="io", CYCLE_TIME=0.1, TOOL_TABLE="tool.tbl"),
        *_section(
            "TRAJ",
            COORDINATES=" ".join(AXES),
            LINEAR_UNITS="mm",
            ANGULAR_UNITS="deg",
            DEFAULT_LINEAR_VELOCITY=100,
            MAX_LINEAR_VELOCITY=FASTEST,
            MAX_ANGULAR_VELOCITY=FASTEST,
            DEFAULT_LINEAR_ACCELERATION=CHAIN,
            MAX_LINEAR_ACCELERATION=CHAIN,
            NO_FORCE_HOMING=1,
            ARC_BLEND_ENABLE=0,
        ),
    ]
    for axis in AXES:
        bounds = {"MIN_LIMIT": -2000, "MAX_LIMIT": 2000}
        rows += _section(f"AXIS_{axis}", MAX_VELOCITY=FASTEST, MAX_ACCELERATION=QUICK, **bounds)
    joints = zip(arm.lower, arm.upper, arm.speed, robot.start, strict=True)
    for k, (lower, upper, speed, start) in enumerate(joints):
        less = JOINT_3 if k == 2 else 0.0
        home = round(deg(start) - less, 6)
        rows += _section(
            f"JOINT_{k}",
            TYPE="ANGULAR",
            MAX_VELOCITY=round(deg(speed), 6),
            MAX_ACCELERATION=CHAIN,
            MIN_LIMIT=round(deg(lower) - less, 6),
            MAX_LIMIT=round(deg(upper) - less, 6),
            FERROR=5,
            MIN_FERROR=5,
            HOME=home,
            HOME_OFFSET=home,
            HOME_SEARCH_VEL=0,
            HOME_LATCH_VEL=0,
            HOME_SEQUENCE=0,
        )
    return "\n".join(rows)


def hal_text(robot: Robot) -> str:
    """Return the HAL file: joints that follow at once, kinematics, their switch, signals."""
    arm = robot.arm
    rows = [
        "# Joints follow at once: replace that by the robot's drives and encoders.",
        "loadrt [KINS]KINEMATICS",
        f"loadrt [EMCMOT]EMCMOT {MOTION}",
        "loadrt sum2 count=2",
        "addf motion-command-handler servo-thread",
        "addf motion-controller servo-thread",
        "addf sum2.0 servo-thread",
        "addf sum2.1 servo-thread",
        "loadrt integ",
        "addf integ.0 servo-thread",
        *(f"net j{k} joint.{k}.motor-pos-cmd => joint.{k}.motor-pos-fb" for k in range(6)),
        "",
        "# geometry in Craig's convention, mm and rad; the tool stays in the program",
        *_kinematics(arm),
        "",
        "# joints until a program asks for the world: 1 - analog-out-03; motion says which holds",
        "setp sum2.0.in1 1",
        "setp sum2.0.gain0 -1",
        "setp sum2.0.gain1 1",
        "net asked motion.analog-out-03 => sum2.0.in0",
        "net kinematics sum2.0.out => motion.switchkins-type",
        "net joints kinstype.is-1 => motion.digital-in-62",
        "net world kinstype.is-0 => motion.digital-in-63",
        "",
        "# the seconds that the machine has run, for TIMER",
        "setp integ.0.in 1",
        "net seconds integ.0.out => motion.analog-in-01",
        "",
        "# signals of the program: connect them to the robot's cards",
        *(f"net input-{s} => motion.digital-in-{p:02}" for s, p in robot.table.inputs.items()),
        *(f"net output-{s} <= motion.digital-out-{p:02}" for s, p in robot.table.outputs.items()),
        f"net hand-open <= motion.digital-out-{robot.table.hand_open:02}",
        f"net hand-close <= motion.digital-out-{robot.table.hand_close:02}",
        "",
        "net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in",
        "net tool-change iocontrol.0.tool-change => iocontrol.0.tool-changed",
        "net tool-prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared",
    ]
    return "\n".join(rows) + "\n"


def acceleration_text() -> str:
    """Return the HAL file that is read once the task controller is up: acceleration by M68 E0."""
    pins = " ".join(f"ini.{axis.lower()}.max_acceleration" for axis in AXES)
    rows = [
        f"setp sum2.1.in1 {QUICK:g}",
        "net acceleration-asked motion.analog-out-00 => sum2.1.in0",
        f"net acceleration sum2.1.out => {pins}",
        "net acceleration => motion.analog-in-00",
    ]
    return "\n".join(rows) + "\n"


def _kinematics(arm: SphericalWristArm) -> list[str]:
    quarter = 1.5707963267948966
    lengths = {"A-2": arm.a2, "A-3": -arm.a3, "D-2": arm.d2, "D-3": arm.d4, "D-5": arm.d6}
    alphas = (0.0, -quarter, 0.0, -quarter, quarter, -quarter)
    rows: list[str] = []
    for k, alpha in enumerate(alphas):
        for name in (f"A-{k}", f"D-{k}"):
            rows.append(f"setp genserkins.{name} {number(lengths.get(name, 0.0) / MM).strip('[]')}")
        rows.append(f"setp genserkins.ALPHA-{k} {alpha!r}")
    return rows


def _section(name: str, **values: object) -> list[str]:
    rows = (
        f"{key} = {value:.10g}" if isinstance(value, float) else f"{key} = {value}"
        for key, value in values.items()
    )
    return [f"[{name}]", *rows, ""]
