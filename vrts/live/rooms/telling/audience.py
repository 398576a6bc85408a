"""Who is told something."""

from typing import Final, NamedTuple

from vrts.live.rooms.member import Member


class Audience(NamedTuple):
    """Who is told something."""

    persons: frozenset[str] = frozenset()  # places in the room
    accounts: frozenset[int] = frozenset()
    supervisors: bool = False
    everybody: bool = False

    def includes(self, member: Member) -> bool:
        """Return whether somebody is meant."""
        return (
            self.everybody
            or member.id in self.persons
            or member.account.id in self.accounts
            or (self.supervisors and member.supervisor)
        )


EVERYBODY: Final = Audience(everybody=True)
