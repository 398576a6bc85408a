; Example E18 of the VAL-II language reference (val2.md), unchanged.
.PROGRAM asdemo()
  SPEED 200 MM/S ALWAYS
  ACCURACY 1 ALWAYS
  POINT place = tray+TRANS(30,0,0)+RX(180)
  JAPPRO place,80
  LMOVE place
  SWAIT 1001
  OPENI
  LDEPART 80
  HOME
.END
