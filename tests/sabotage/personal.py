"""Faults planted in what hands out one student of a class, and forgets one."""

from tests.sabotage.patch import Patch

HOME = "tests/unit/marking/personal"

PERSONAL: tuple[Patch, ...] = (
    Patch(
        "the program of a forgotten student is still kept to be compared",
        "vrts/marking/personal/compared.py",
        "for name, program in kept.programs.items() if name not in ids}",
        "for name, program in kept.programs.items() if name}",
        (f"{HOME}/test_forget.py",),
    ),
    Patch(
        "a decision about several still names the student who was forgotten",
        "vrts/marking/personal/decided.py",
        "    left = tuple(one for one in said.students if one not in ids)",
        "    left = said.students",
        (f"{HOME}/test_pieces.py",),
    ),
    Patch(
        "what a student is handed out names others whose programs are alike",
        "vrts/marking/personal/likeness_of_one.py",
        "[ME if one in ids else SOMEBODY for one in group.members]",
        "[ME if one in ids else one for one in group.members]",
        (f"{HOME}/test_hand_out.py",),
    ),
)
