"""`vrts` with as many rooms as a benchmark asks for, each of them as a robot of somebody's own."""

from vrts.cli.main import main
from vrts.live.rooms import opening
from vrts.live.rooms.room import Room

if __name__ == "__main__":
    opening.MOST_ROOMS = 1000  # type: ignore[misc]
    Room.seldom = property(lambda _: True)  # type: ignore[assignment]
    main()
