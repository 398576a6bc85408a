; Example E18 of VAL-II and its relatives, written for vrts [manual language/dialects#differences].
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
