"""An interpreter of a part of URScript, made of Universal Robots' script manual and not of vrts.

In: a program, forward kinematics, inputs. Out: motions, outputs and messages, in order.
May not import vrts.
"""
