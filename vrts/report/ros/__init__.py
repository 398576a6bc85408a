"""A run as messages of ROS 2, in a bag that `ros2 bag`, Foxglove and PlotJuggler read.

In: an assessment. Out: a folder with a bag (MCAP), or the one file of it. Time 0 is the start of
the run. A door to rosbags. Decides nothing.
"""
