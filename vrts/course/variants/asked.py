"""What is asked of the process that reads tasks, about variants: a line of JSON each."""

import msgspec


class Called(msgspec.Struct, frozen=True):
    """Somebody, as lists of the class call them."""

    email: str
    ids: dict[str, str]  # on platforms


class GiveIt(msgspec.Struct, frozen=True, tag="give"):
    """Give somebody a variant of a task."""

    task: str  # path of its file
    roster: str  # path of the list of the class
    people: tuple[Called, ...]  # whose it is; of a team all
    team: str  # its name; empty: it is one person's
    folder: str  # that variants of the task are written into, each by its tag


class Given(msgspec.Struct, frozen=True):
    """The answer to it."""

    tag: str = ""
    task: str = ""  # path of the file of the variant
    problem: str = ""  # why there is none
