"""A program as the arms of Universal Robots take it: URScript, and a sheet.

In: a verified program for a UR arm. Out: a file of URScript. Unrolls nothing; talks to no robot.
"""
