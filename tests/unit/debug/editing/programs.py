"""Programs that are changed while they are debugged: calls, loops, reactions, a second program."""

LONG = """.PROGRAM main()
 SPEED 60 ALWAYS
 REACT 2005, ring, 3
 x = 0
 FOR i = 1 TO 4
  MOVE far
  CALL deep(i, x)
  IF x > 5 THEN
   SIGNAL 2005
   TYPE "over", x
  ELSE
   TYPE "under", x
  END
  CASE i OF
   VALUE 1,2:
    MOVES near
   ANY
    DRIVE 1, 10, 50
  END
  SIGNAL -2005
 END
 DELAY 2
 y = x*2
10 y = y-1
 IF y > 3 GOTO 10
 MOVE last
 BREAK
 z = y/w
.END
.PROGRAM deep(a, b)
 AUTO c
 c = a
 b = b+c
 IF a < 3 THEN
  CALL deep(a+1, b)
 END
 MOVE up
 TIMER 1 = 0
 WAIT TIMER(1) > 0.5
.END
.PROGRAM ring()
 rings = rings+1
 TYPE "ring"
 READY
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 250 0 90 90 0
up 600 200 100 90 90 0
last 700 -300 0 90 90 0
.END
.REALS
rings 0
w 2
.END
"""
WAITS = """.PROGRAM main()
 n = 0
 MOVE far
10 n = n+1
 k = k2
 MOVE near
 MOVE far
 IF n < 3 GOTO 10
20 m = m+1
 WAIT SIG(1005)
 GOTO 20
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 250 0 90 90 0
.END
.REALS
k2 3
m 0
.END
"""
