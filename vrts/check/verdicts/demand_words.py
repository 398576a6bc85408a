"""What demands are called when they are kept, when they are not, and by how much."""

from fractions import Fraction

from vrts.base.beside import beside
from vrts.base.diagnostic import Rule
from vrts.base.units import deg, mm
from vrts.check.rounding import exact_deg, exact_mm
from vrts.check.task.demands import Demand, Keeps
from vrts.check.verdicts.singularity import in_words

ZONE = Rule("V432", "zone-entered")
TILTED = Rule("V433", "not-upright")
SPEED = Rule("V434", "speed-of-task")
SINGULAR = Rule("V435", "near-singular")


def rule_of(keeps: Keeps) -> Rule:
    """Return the code of what is wrong when a demand is not kept."""
    match keeps:
        case Keeps.TOOL_OUT | Keeps.ROBOT_OUT:
            return ZONE
        case Keeps.UPRIGHT:
            return TILTED
        case Keeps.JOINT_SPEED | Keeps.TOOL_SPEED:
            return SPEED
        case _:
            return SINGULAR


def wanted(demand: Demand) -> str:
    """Return what a demand asks for."""
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return f"the tool stays out of `{demand.name}`"
        case Keeps.ROBOT_OUT:
            return f"the robot stays out of `{demand.name}`"
        case Keeps.UPRIGHT:
            return f"`{demand.body}` stays within {deg(demand.limit):g} degrees of upright"
        case Keeps.JOINT_SPEED:
            return f"no joint turns faster than {100 * demand.limit:g} % of its limit"
        case Keeps.TOOL_SPEED:
            return f"the tool is no faster than {mm(demand.limit):g} mm/s"
        case Keeps.SINGULAR:
            return f"the smallest singular value stays above {demand.limit:g} on straight lines"
        case _:
            distance = _distance(demand)
            return f"the arm stays {distance} from the {demand.name} on straight lines"


def broken(demand: Demand, part: str) -> str:
    """Return what is wrong; `part` of the robot is in a zone."""
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return f"the tool enters the zone `{demand.name}`"
        case Keeps.ROBOT_OUT:
            return f"`{part}` enters the zone `{demand.name}`"
        case Keeps.UPRIGHT:
            return f"`{demand.body}` is tilted by more than {deg(demand.limit):g} degrees"
        case Keeps.JOINT_SPEED:
            return f"a joint turns faster than {100 * demand.limit:g} % of its limit"
        case Keeps.TOOL_SPEED:
            return f"the tool is faster than {mm(demand.limit):g} mm/s"
        case Keeps.SINGULAR:
            return f"the arm comes near a singularity: singular value below {demand.limit:g}"
        case _:
            return f"the arm comes nearer than {_distance(demand)} to the {demand.name}"


def reached(demand: Demand, largest: float) -> str:
    """Return how far a quantity went."""
    match demand.keeps:
        case Keeps.TOOL_OUT | Keeps.ROBOT_OUT:
            return f"at least {mm(largest):.1f} mm deep"
        case Keeps.UPRIGHT:
            most, _ = beside(exact_deg(largest), exact_deg(demand.limit))
            return f"{most} degrees are reached"
        case Keeps.JOINT_SPEED:
            most, _ = beside(_percent(largest), _percent(demand.limit), least=0)
            return f"{most} % are reached"
        case Keeps.TOOL_SPEED:
            most, _ = beside(exact_mm(largest), exact_mm(demand.limit), least=0)
            return f"{most} mm/s are reached"
        case _:
            return f"the smallest is {in_words(demand.keeps, -largest)}"


def _percent(share: float) -> Fraction:
    return Fraction(round(share * 10_000), 100)


def _distance(demand: Demand) -> str:
    if demand.keeps is Keeps.SHOULDER:
        return f"{mm(demand.limit):g} mm"
    return f"{deg(demand.limit):g} degrees"
