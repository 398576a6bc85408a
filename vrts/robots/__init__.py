"""Arms and grippers as data, their kinematics and arm branches: the only door to pinocchio."""
