"""What a new course begins with: files to be corrected."""

from typing import Final

from vrts.course.course import COURSE_FILE

EXAMPLE_TASK: Final = ("tasks/cans", "01-cans-on-bases")  # folder, and the example it is made from
ROSTER: Final = "roster.csv"

_LIST: Final = """\
name,email,team
Anna Berg,anna.berg@example.org,
Ben Otto,ben.otto@example.org,Red
Cara Lund,cara.lund@example.org,Red
"""
_COURSE: Final = """\
# A course: who is in it, its rooms, its assignments. `vrts course check FOLDER` finds faults;
# a server that runs takes people over from here as soon as this file is saved.

[course]
title = {title}
# The list of the class: Moodle's grading worksheet, the grade book of Canvas, or a table with the
# columns name and email, and if you like id and team.
roster = "roster.csv"
# Rooms that all share, each with one robot.
rooms = ["Class", "Lab"]
# More scenes than those of the assignments.
# scenes = ["cans-on-bases"]
# Whether the class code lets in who is on no list.
guests = false
# Whether each student may have a robot of their own.
own_robots = true

# Who teaches may do everything, in every room. Repeat the section for another teacher.
[[teacher]]
name = "Ada Lind"
email = "ada.lind@example.org"

# An assistant leads the rooms that are named, or all of them, and nothing else.
[[assistant]]
name = "Bo Holm"
email = "bo.holm@example.org"
rooms = ["Lab"]

# Students who share a robot, by e-mail address, name or id: this, or the column `team` of the list.
# [[team]]
# name = "Blue"
# members = ["anna.berg@example.org"]

[[assignment]]
task = "{task}"
# opens = 2026-10-01T08:00:00+02:00
# attempts = 3
# Where `vrts course mark` writes: later deadlines that you give at the desk count in the page, too.
# marked = "marked/cans"

# Robots of their own: how many, and when they fall asleep. What is left out is as usual.
# [robots]
# awake = 40  # at once, of everybody together
# empty_minutes = 5  # after which a robot sleeps where nobody is

# Times that students book for a shared robot.
# [slots]
# room = "Lab"
# time_zone = "Europe/Berlin"
# minutes = 30
# hours = "08:00-18:00"

# Log-in by a provider of OpenID Connect. Without this section the server begins no connection.
# [login]
# issuer = "https://id.example.org/realms/school"
# client = "vrts"
# secret = "/etc/vrts/login-secret"  # a file outside of this folder, with `chmod 600`
# name = "Log in with the school"
"""


def course_files(title: str) -> dict[str, str]:
    """Return the texts of a new course's files, by name; its example task is made elsewhere."""
    quoted = '"' + title.replace("\\", "\\\\").replace('"', '\\"') + '"'
    course = _COURSE.format(title=quoted, task=EXAMPLE_TASK[0])
    return {COURSE_FILE: course, ROSTER: _LIST}
