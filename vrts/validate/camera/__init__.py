"""A real camera, found from marked points, and the simulated robot drawn over what it saw.

In: frames and marks. Out: one camera for all pictures, frames with the robot drawn over them.
Knows no log. The only door to OpenCV.
"""
