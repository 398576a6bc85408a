"""Words that mean the same to somebody who asks, though the manual may use only one of them.

A row is a group: whoever types one of its words also finds pages with the others. A group of
several words of the manual stays small, or everything would be alike.
"""

# fmt: off

ALIKE = (
    # time and motion
    "wait, pause, sleep, dwell, stand still, stay still, do nothing, delay, hold on",
    "second, seconds, sec, moment, while, time",
    "straight, linear, line, cartesian, rectilinear",
    "move, go, drive, travel, walk, fly, get to, bring, motion",
    "turn, rotate, twist, spin, swivel",
    "fast, speed, slow, quick, velocity, pace, rapid, mm per second, faster, slower, quicker",
    "stop, halt, end, terminate, quit, cancel",
    "above, over, before, in front of, approach, on top of",
    "away, back off, retreat, retract, depart, pull out, back up",
    "round, around, avoid, bypass, detour, via, obstacle, go round, walk round",
    "collision, collide, crash, hit, touch, bump, contact, smash, strike",
    "corner, blend, smooth, without stopping, fly-by, rounded, rounding",
    "exact, precise, accurate, accuracy, fine, precision",
    "home, rest position, start position, ready",
    # hand
    "hand, gripper, fingers, claw, jaw, jaws, grasper, pincers",
    "grasp, grip, grab, pick, pick up, seize, take, lift, hold",
    "put, place, set down, put down, lay down, deposit, release, let go, drop",
    "width, opening, wide, how far open, size",
    "thing, object, part, piece, workpiece, can, item, box",
    # places
    "location, position, point, pose, place, coordinate, spot, target, destination, waypoint",
    "teach, record, save a position, store a position, learn a position, jog",
    "offset, shift, relative, displacement, next to, beside",
    "frame, coordinate system, user frame, work object, base, origin",
    "tool, tcp, tool center point, tool centre point, end effector, tip",
    "grid, pallet, palletize, matrix, rows and columns, rows, array, tray",
    "angle, orientation, orient, tilt, degrees, yaw, pitch, roll",
    "reach, reachable, out of reach, too far, reachability",
    "joint, axis, axes, degree of freedom",
    # numbers and texts
    "variable, value, store a number, remember",
    "string, text, character, letters",
    "random, chance, dice, luck",
    "count, counter, how many, number of, tally",
    "integer, whole number, round off, rounding",
    # control
    "loop, repeat, again, iterate, iteration, times, over and over",
    "forever, endless, infinite, never ends, does not end",
    "if, condition, decide, when, choose, decision, depending",
    "subroutine, subprogram, function, procedure, routine, method, sub program, call",
    "argument, parameter, pass, hand over",
    "comment, remark, annotation",
    # signals
    "input, sensor, switch, button, light barrier, detector, digital in, di",
    "output, lamp, light, led, valve, relay, siren, digital out, do_out",
    "signal, io, i/o, pin, bit, port, line of input",
    "interrupt, react, reaction, event, watch, notice, trigger",
    "analog, voltage, analogue, sensor value",
    "parallel, two programs, same time, background, thread, multitask, concurrent, beside",
    "clock, timer, stopwatch, measure time, elapsed, how long",
    # people
    "print, write, display, show, output text, screen, terminal, message, say, log",
    "ask, prompt, keyboard, question, key in, type in, enter, user input, answer, operator",
    "emergency, panic",
    # mistakes
    "error, mistake, fault, problem, wrong, fail, bug, fails, broken",
    "mean, meaning, explain, explanation, understand",
    "correct, repair, mend, fix",
    "undefined, not defined, unknown, missing, no value",
    "format, layout, indent, pretty, tidy, beautify",
    # running and seeing
    "check, verify, test, prove, validate",
    "simulate, run, execute, start, play, launch",
    "see, view, watch, look at, animation, video, picture, 3d, visualise, visualize",
    "debug, debugger, breakpoint, step by step, single step, trace",
    "backward, backwards, back in time, rewind, reverse, undo",
    # marking
    "mark, grade, score, points, assess, assessment, rate",
    "student, class, course, learner, pupil",
    "hand-in, submission, hand in, handed in, homework, upload, submit, turned in",
    "late, deadline, overdue, after the deadline",
    "appeal, complaint, complain, disagree, protest, objection, disputes, unfair",
    "moodle, canvas, gradescope, learning platform, lms, grade book, gradebook",
    "plagiarism, cheating, copied, similar, alike, same program",
    "teacher, instructor, professor, lecturer, tutor",
    # authoring
    "task, assignment, exercise, lab, homework problem",
    "hidden, secret, hide, conceal, private",
    "scene, workspace, environment, world, surroundings, setup",
    "scenario, what happens, slips, late part",
    # real robot
    "real robot, hardware, controller, actual robot, machine, physical robot",
    "transfer, send, upload, download, load, bring",
    "log, recording, csv, measured, measurement",
    "kuka, krl", "abb, rapid", "fanuc, karel, tp", "universal robots, ur, urscript, ur5, ur3, ur10",
    "kawasaki, as language", "adept, v+, vplus", "staubli, val3",
    # understanding
    "assume, assumed, assumption, guess, guessed, not known, uncertain",
    "how exact, exactly, accuracy, precise, trust, believe, reliable",
    "proof, certificate, prove, guarantee, guaranteed, certain",
    "future, futures, every input, all inputs, any input",
    "simulation, simulator, virtual",
    "editor, vscode, vs code, neovim, emacs, ide",
    "install, set up, setup, installation",
    "share, browser, online, together, multiplayer",
)
