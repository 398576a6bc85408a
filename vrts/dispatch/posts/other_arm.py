"""How the arm of another controller counts its joints, and what tells it that the hand holds."""

from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.pipeline.refused import Refused

ARM_JOINTS = Rule("V865", "arm-joints")
LARGEST_DEG = 720.0  # of a zero position
_SIX = 6


class OtherArm(NamedTuple):
    """One joint of theirs is `sign * ours + zero`, where `order` says which of ours it is."""

    title: str
    order: tuple[int, ...] = (1, 2, 3, 4, 5, 6)
    sign: tuple[int, ...] = (1,) * _SIX
    zero_deg: tuple[float, ...] = (0.0,) * _SIX
    holds: int | None = None  # signal that is on while the hand holds something

    @property
    def counts_alike(self) -> bool:
        """Whether joint values are those of the arm that was simulated."""
        plain = OtherArm("")
        return (self.order, self.sign, self.zero_deg) == (plain.order, plain.sign, plain.zero_deg)

    def joints(self, ours_deg: tuple[float, ...]) -> tuple[float, ...]:
        """Return joint values as the other arm counts them [deg]."""
        each = zip(self.order, self.sign, self.zero_deg, strict=True)
        return tuple(sign * ours_deg[k - 1] + zero for k, sign, zero in each)


SAME = OtherArm("the arm that was simulated")


def read_arm(source: SourceFile) -> OtherArm:
    """Return the arm that a file describes.

    Raises:
        Refused: The file has errors.
    """
    top, problems = read_toml(source)
    if top is None:
        raise Refused(problems.in_order())
    title = top.string("title", required=True) or ""
    joints, hand = top.table("joints", required=True), top.table("hand")
    top.finish()
    found = SAME._replace(title=title)
    if joints is not None:
        order = joints.numbers("order", tuple(map(float, SAME.order)), count=_SIX)
        sign = joints.numbers("sign", count=_SIX, required=True) or SAME.sign
        zero = joints.numbers("zero_deg", count=_SIX, required=True) or SAME.zero_deg
        joints.finish()
        if order is not None and sorted(order) != list(SAME.order):
            headline = "`order` names each of the joints 1 to 6 once"
            problems.error(ARM_JOINTS, headline, joints.value_span("order"))
        if any(abs(value) != 1.0 for value in sign):
            headline = "a sign is 1 or -1"
            problems.error(ARM_JOINTS, headline, joints.value_span("sign"))
        if any(abs(value) > LARGEST_DEG for value in zero):
            headline = f"a zero position is within {LARGEST_DEG:g} degrees"
            problems.error(ARM_JOINTS, headline, joints.value_span("zero_deg"))
        found = found._replace(
            order=tuple(map(int, order or SAME.order)), sign=tuple(map(int, sign)), zero_deg=zero
        )
    if hand is not None:
        found = found._replace(holds=hand.integer("holds", minimum=1, maximum=2960, required=True))
        hand.finish()
    if problems.any_error:
        raise Refused(problems.in_order())
    return found
