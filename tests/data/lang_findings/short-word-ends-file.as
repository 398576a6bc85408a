.PROGRAM a()
        SPEED 20
         M