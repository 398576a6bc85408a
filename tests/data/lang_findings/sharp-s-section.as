.PROGRAßßß main
        GOTO 10
.ENÄ
