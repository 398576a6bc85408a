"""The set of scenes of a course: its tasks by the ids of the assignments, and further scenes."""

from vrts.course.course import Course
from vrts.live.places import places_of
from vrts.live.settings import Place
from vrts.pipeline.files import TASK_FILE


def places_of_course(course: Course) -> tuple[Place, ...]:
    """Return the scenes and tasks that rooms of a course may have.

    Raises:
        CannotRead: There is no such scene, or two have the same name.
    """
    tasks = (Place(one.id, "", str((one.task / TASK_FILE).resolve())) for one in course.assignments)
    known = {one.id for one in course.assignments}
    others = (place for place in places_of(course.scenes) if place.id not in known)
    return (*tasks, *others)
