"""What is wrong with a bag, and how much of one is read."""

from vrts.validate.log.unreadable import Unreadable

MOST_BYTES = 200_000_000  # of a file
MOST_UNPACKED = 1_000_000_000  # bytes of all chunks of a file
MOST_CHUNK = 32_000_000  # bytes of a chunk, unpacked; ROS 2 writes 4 MB at most
MOST_MESSAGES = 1_000_000
MOST_MESSAGE = 100_000  # bytes of a message with joint states
KIND = "sensor_msgs/msg/JointState"


class BagFault(Unreadable):
    """A bag cannot be read; says why."""
