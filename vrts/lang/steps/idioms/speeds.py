"""Speeds as other robot languages and beginners write them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_MM = "<mm/s|mm / s|mm/sec|mm / sec|mmps.|mms|mm|mm per s|mm per sec|mm_per_s|mm_per_sec|mm_per_second|mm s|mm sec|millimeters_per_second|mm/second|mmpsec>"

SPEEDS = (
    Idiom("speed {d} " + _MM, "SPEED {d} MMPS", says="the unit of millimetres a second is MMPS"),
    Idiom("speed {d} " + _MM + " always", "SPEED {d} MMPS ALWAYS", says="the unit of millimetres a second is MMPS"),
    Idiom("speed {d} <m/s|m / s|mps|m/sec>", "", says="VAL-II has no such unit", help="write millimetres a second: 0.1 m/s is `SPEED 100 MMPS`"),
    Idiom("speed {d} <m/s|m / s|mps|m/sec> always", "", says="VAL-II has no such unit", help="write millimetres a second: 0.1 m/s is `SPEED 100 MMPS ALWAYS`"),
    Idiom("speed {d} <%|percent|per cent|pct|prozent|procent>", "SPEED {d}", says="SPEED takes percent, without a sign"),
    Idiom("speed {d} <%|percent|per cent|pct> always", "SPEED {d} ALWAYS", says="SPEED takes percent, without a sign"),
    Idiom("speed_<=|to|:=|:|at|is> {d} <%|>", "SPEED {d}", says="SPEED takes the number alone"),
    Idiom("speed <=|:=|:|,> {d} <%|>", "SPEED {d}", says="SPEED takes the number alone"),
    Idiom("speed <=|:=|:|,> {d} " + _MM, "SPEED {d} MMPS", says="SPEED takes the number and its unit"),
    Idiom("always_{r}", "{r} ALWAYS", says="ALWAYS stands last"),
    Idiom("speed_always_{d}", "SPEED {d} ALWAYS", says="ALWAYS stands last"),
    Idiom("speed {d} mmps , always", "SPEED {d} MMPS ALWAYS", says="ALWAYS follows without a comma"),
    Idiom("speed <mmps|mm/s> {d}", "SPEED {d} MMPS", says="the unit stands behind the number"),
    Idiom("speed <mmps|mm/s> {d} always", "SPEED {d} MMPS ALWAYS", says="the unit stands behind the number"),
    Idiom("speed {d} always mmps", "SPEED {d} MMPS ALWAYS", says="the unit stands behind the number, and ALWAYS last"),
    Idiom("speed {d} , <always|all>", "SPEED {d} ALWAYS", says="ALWAYS follows without a comma"),
    Idiom("speed {d} <allways|alway|allway|alwais|allways.>", "SPEED {d} ALWAYS", says="ALWAYS is misspelt"),
    Idiom("speed {d} <for_ever|all|forever|permanent|always on>", "SPEED {d} ALWAYS", says="a speed for all motions that follow ends with ALWAYS"),
    Idiom("<setspeed|set_speed|velocity|velset|vel|set_velocity|setvel|speedset|override|ovr|set_override|spd|speed_set|robotspeed|feedrate> <=|:=|> {d} <%|>", "SPEED {d}", "other robot languages"),
    Idiom("<setspeed|set_speed|velocity|vel|set_velocity|setvel|speedset|override|spd|set speed> ( {d} )", "SPEED {d}", "other robot languages"),
    Idiom("<velocity|vel|spd|set_speed|setspeed|set_velocity|feedrate> <=|:=|> {d} " + _MM, "SPEED {d} MMPS", "other robot languages"),
    Idiom("<velocity|vel|spd|set_speed|setspeed|set_velocity|feedrate> <=|:=|> {d} <mmps|ips>_<always|>", "", "other robot languages", help="write `SPEED {d} MMPS`"),
    Idiom("<velocity|vel|spd|set_speed|setspeed|set_velocity|feedrate> <=|:=|> {d} always", "SPEED {d} ALWAYS", "other robot languages"),
    Idiom("set_<speed|velocity>_<to|=|> {d} <%|>", "SPEED {d}", says="SPEED is an instruction of its own"),
    Idiom("set_<speed|velocity> = {d} <%|>", "SPEED {d}", says="SPEED is an instruction of its own"),
    Idiom("accel_{r}", "", "V+", help="VAL-II has no such setting: use SPEED"),
)
