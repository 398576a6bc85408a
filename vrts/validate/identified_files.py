"""What was found wrong with a robot, as a lab that can be laid over any scene."""

import json

from vrts.base.units import DEG, MM
from vrts.report.plain import one_line
from vrts.validate.identify.again import controller_arm
from vrts.validate.identify.causes import BY_TICKS
from vrts.validate.identify.identified import Identified
from vrts.validate.identify.words import clause_of
from vrts.validate.reports.identified_text import sentence


def identified_lab(found: Identified) -> str:
    """Return a lab with the speeds and times of the robot; the rest stands in it as comments.

    A lab says what a controller counts. Joints, links, tool and base that are off are to be put
    right at the robot.
    """
    values = {n.cause: n.value for n in found.numbers if n.cause.kind in BY_TICKS}
    arm = controller_arm(found.arm, values)
    rows = ["# Robot data found by `vrts validate --identify`, to be laid over a scene: `--lab`."]
    rows.append(f"# {sentence(found)}")
    rows.append(f"# from `{one_line(found.log).replace('`', chr(39))}`, sha256 {found.sha256}")
    if found.synthetic:
        rows.append("# SYNTHETIC: a log was made by a computer; this describes no real robot.")
    rows += [
        f"# not in this lab, to be put right at the robot: {clause_of(number)}"
        for number in found.numbers
        if number.cause not in values
    ]
    rows += ["", "[lab]", f"title = {json.dumps(f'the {found.arm.name} as identified')}", ""]
    rows.append("[lab.robot]")
    rows.append(f"speed_deg_s = [{', '.join(f'{speed / DEG:.4f}' for speed in arm.speed)}]")
    rows.append(f"linear_mm_s = {arm.linear_speed / MM:.3f}")
    rows.append(f"angular_deg_s = {arm.angular_speed / DEG:.4f}")
    rows.append(f"acceleration_s = {arm.acceleration_time:.4f}")
    if arm.blend_time is not None:
        rows.append(f"blend_s = {arm.blend_time:.4f}")
    return "\n".join(rows) + "\n"
