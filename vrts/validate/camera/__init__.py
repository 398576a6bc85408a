"""A real camera, found from marked points, and the simulated robot drawn over what it saw.

The only door to OpenCV. `calibration_file` reads what was marked, `calibrate` finds the camera,
`views` says where it looked when, `frames` opens pictures and videos, `overlay` draws.
"""
