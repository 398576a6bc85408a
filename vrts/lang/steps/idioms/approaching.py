"""Approaching and leaving as beginners write it, and single joints."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

APPROACHING = (
    Idiom("<approach|aproach|approch|appoach|apprach|approj|japproach>_<to|> {v} <,|by|at|> {d}", "APPRO {v}, {d}", says="APPROACH is not a VAL-II instruction"),
    Idiom("<approach|aproach|approch|japproach> ( {v} , {d} )", "APPRO {v}, {d}", says="APPROACH is not a VAL-II instruction"),
    Idiom("<approach|aproach|approch>_{v} , {e}", "APPRO {v}, {e}", says="APPROACH is not a VAL-II instruction"),
    Idiom("<approachs|approaches|sapproach|approach_straight|approachl|lapproach>_{v} , {e}", "APPROS {v}, {e}", says="APPROACHS is not a VAL-II instruction"),
    Idiom("approach_{v}", "", says="APPROACH is not a VAL-II instruction", help="write `APPRO {v}, 50`, with the distance in mm"),
    Idiom("appro {v} {d}", "APPRO {v}, {d}", says="a comma is missing before `{d}`"),
    Idiom("appros {v} {d}", "APPROS {v}, {d}", says="a comma is missing before `{d}`"),
    Idiom("appro ( {v} , {e} )", "APPRO {v}, {e}", says="APPRO takes no parentheses"),
    Idiom("appros ( {v} , {e} )", "APPROS {v}, {e}", says="APPROS takes no parentheses"),
    Idiom("appro_<to|> {v} , {d} <mm|m m>", "APPRO {v}, {d}", says="a distance is a number of mm, without a unit"),
    Idiom("appros_<to|> {v} , {d} <mm|m m>", "APPROS {v}, {d}", says="a distance is a number of mm, without a unit"),
    Idiom("appro_to_{v} , {e}", "APPRO {v}, {e}", says="APPRO takes the location first"),
    Idiom("appro_{v} <by|at|with|from> {e}", "APPRO {v}, {e}", says="a comma is missing before `{e}`"),
    Idiom("appros_{v} <by|at|with|from> {e}", "APPROS {v}, {e}", says="a comma is missing before `{e}`"),
    Idiom("appro {v} ; {d}", "APPRO {v}, {d}", says="`;` begins a comment, a comma parts operands"),
    Idiom("appros {v} ; {d}", "APPROS {v}, {d}", says="`;` begins a comment, a comma parts operands"),
    Idiom("appro {v} : {d}", "APPRO {v}, {d}", says="`:` joins locations, a comma parts operands"),
    Idiom("appro {v} = {d}", "APPRO {v}, {d}", says="a comma parts operands"),
    Idiom("depart_{v} , {d}", "DEPART {d}", says="DEPART takes the distance alone", note="it moves away from where the tool is"),
    Idiom("departs_{v} , {d}", "DEPARTS {d}", says="DEPARTS takes the distance alone", note="it moves away from where the tool is"),
    Idiom("depart_{n}_{d}", "DEPART {d}", says="DEPART takes the distance alone", note="it moves away from where the tool is"),
    Idiom("departs_{n}_{d}", "DEPARTS {d}", says="DEPARTS takes the distance alone", note="it moves away from where the tool is"),
    Idiom("depart_<by|to|from|=> {d}", "DEPART {d}", says="DEPART takes the distance alone"),
    Idiom("departs_<by|to|from|=> {d}", "DEPARTS {d}", says="DEPARTS takes the distance alone"),
    Idiom("depart = {d}", "DEPART {d}", says="DEPART takes no `=`"),
    Idiom("depart , {d}", "DEPART {d}", says="DEPART takes the distance alone"),
    Idiom("departs , {d}", "DEPARTS {d}", says="DEPARTS takes the distance alone"),
    Idiom("depart_{d} mm", "DEPART {d}", says="a distance is a number of mm, without a unit"),
    Idiom("departs_{d} mm", "DEPARTS {d}", says="a distance is a number of mm, without a unit"),
    Idiom("<retract|withdraw|departure|retreat|leave|back_off|lift|moveaway|move_up|raise>_{d}", "DEPART {d}", "other robot languages", sure=False),
    Idiom("drive_<j|joint|axis|joint_> {d} , {e} , {e2}", "DRIVE {d}, {e}, {e2}", says="DRIVE takes the number of the joint"),
    Idiom("drive_<j|joint|axis|joint_> {d} , {e}", "", says="DRIVE takes the number of the joint", help="write `DRIVE {d}, {e}, 100`: joint, change in degrees, speed in percent"),
    Idiom("drive_{e} , {d} <deg|degs|degree|degrees|°|grad>", "DRIVE {e}, {d}", says="angles are in degrees, without a unit"),
    Idiom("drive_{e} , {d} <deg|degs|degree|degrees|°|grad> , {e2}", "DRIVE {e}, {d}, {e2}", says="angles are in degrees, without a unit"),
    Idiom("drive_{d}_{d2}_{d3}", "DRIVE {d}, {d2}, {d3}", says="commas are missing between the operands"),
    Idiom("drive ( {e} , {e2} , {e3} )", "DRIVE {e}, {e2}, {e3}", says="DRIVE takes no parentheses"),
    Idiom("<movejoint|move_joint|rotate|turn>_{r}", "", "other robot languages", help="write `DRIVE joint, change, speed`, in degrees and percent"),
)
