"""Signals and waiting, as other languages write them."""

# fmt: off
# ruff: noqa: E501

from vrts.lang.steps.idioms.idiom import Idiom

_ON = "a signal is switched on by its number and off by the number with a minus sign"
_SAYS = "SIGNAL takes numbers only"
_OUT = "<set|setdo|set_do|do|dout|digitalwrite|digital_write|set_digital_out|set_standard_digital_out|set_output|setoutput|output|out|write_output|sig|sigon|setsig|setsignal|set_signal|setbit|set_bit>"

SIGNALS = (
    Idiom("signal {d} <=|:=|,|==|> <on|true|1|high>", "SIGNAL {d}", says=_SAYS, note=_ON),
    Idiom("signal {d} <=|:=|,|==|> <off|false|0|low>", "SIGNAL -{d}", says=_SAYS, note=_ON),
    Idiom("signal_<on|true|set|high> <,|> {d}", "SIGNAL {d}", says=_SAYS, note=_ON),
    Idiom("signal_<off|false|reset|low|clear> <,|> {d}", "SIGNAL -{d}", says=_SAYS, note=_ON),
    Idiom("signal ( {d} ) <=|,|> <on|true|1|high>", "SIGNAL {d}", says=_SAYS, note=_ON),
    Idiom("signal ( {d} ) <=|,|> <off|false|0|low>", "SIGNAL -{d}", says=_SAYS, note=_ON),
    Idiom("signal ( {d} , <on|true|1|high> )", "SIGNAL {d}", says=_SAYS, note=_ON),
    Idiom("signal ( {d} , <off|false|0|low> )", "SIGNAL -{d}", says=_SAYS, note=_ON),
    Idiom("signal ( {e} )", "SIGNAL {e}", says="SIGNAL takes no parentheses"),
    Idiom("signal_sig ( {e} )", "SIGNAL {e}", says=_SAYS),
    Idiom("signal = {d}", "SIGNAL {d}", says=_SAYS),
    Idiom("signal_{d}_{d2}", "SIGNAL {d}, {d2}", says="a comma is missing before `{d2}`"),
    Idiom("sig ( {d} ) <=|:=> <on|true|1|high|-1>", "SIGNAL {d}", says="SIG asks, SIGNAL switches", note=_ON),
    Idiom("sig ( {d} ) <=|:=> <off|false|0|low>", "SIGNAL -{d}", says="SIG asks, SIGNAL switches", note=_ON),
    Idiom("<set|switch|turn>_on_{d}", "SIGNAL {d}", "other languages", note=_ON),
    Idiom("<set|switch|turn>_off_{d}", "SIGNAL -{d}", "other languages", note=_ON),
    Idiom(_OUT + " ( {d} ) = <on|true|1|high>", "SIGNAL {d}", "other languages", note=_ON),
    Idiom(_OUT + " ( {d} ) = <off|false|0|low>", "SIGNAL -{d}", "other languages", note=_ON),
    Idiom(_OUT + " ( {d} , <on|true|1|high> )", "SIGNAL {d}", "other languages", note=_ON),
    Idiom(_OUT + " ( {d} , <off|false|0|low> )", "SIGNAL -{d}", "other languages", note=_ON),
    Idiom(_OUT + "_<do|out|output|signal|sig|> {d} <,|=|> <on|true|1|high>", "SIGNAL {d}", "other languages", note=_ON),
    Idiom(_OUT + "_<do|out|output|signal|sig|> {d} <,|=|> <off|false|0|low>", "SIGNAL -{d}", "other languages", note=_ON),
    Idiom("<set_signal|setsignal|sigon|output_on|signalon>_{d}", "SIGNAL {d}", "other languages", note=_ON),
    Idiom("<reset_signal|resetsignal|sigoff|output_off|signaloff|reset_do|resetdo>_{d}", "SIGNAL -{d}", "other languages", note=_ON),
    Idiom("$out [ {d} ] = <true|on|1>", "SIGNAL {d}", "KRL", note=_ON),
    Idiom("$out [ {d} ] = <false|off|0>", "SIGNAL -{d}", "KRL", note=_ON),
    Idiom("do [ {d} ] = <true|on|1>", "SIGNAL {d}", "Karel", note=_ON),
    Idiom("do [ {d} ] = <false|off|0>", "SIGNAL -{d}", "Karel", note=_ON),
    Idiom("<reset|clear>_{d}", "SIGNAL -{d}", says="RESET takes no numbers: it switches all off"),
    # waiting for signals
    Idiom("wait_for_<$in|in|di> [ {d} ] <==true|=true|==on|=on|>", "WAIT SIG({d})", "KRL", sure=False),
    Idiom("wait_<$in|in|di> [ {d} ] <==true|=true|=on|==on|>", "WAIT SIG({d})", "KRL", sure=False),
    Idiom("<waitdi|wait_di|waitsig|waitsignal|wait_signal|waitinput|wait_input|wait_for_signal|wait_for_input|wait_until_signal> {d} <,|=|==|> <on|true|1|high|>", "WAIT SIG({d})", "other languages"),
    Idiom("<waitdi|wait_di|waitsig|waitsignal|wait_signal|waitinput|wait_input|wait_for_signal|wait_for_input> {d} <,|=|==> <off|false|0|low>", "WAIT SIG(-{d})", "other languages"),
    Idiom("<waitdi|waitsig|wait_signal|waitsignal|wait_di|wait_input> ( {d} )", "WAIT SIG({d})", "other languages"),
    Idiom("wait_<until|for|till|while_not|if> sig ( {e} )", "WAIT SIG({e})", says="WAIT takes the condition alone"),
    Idiom("wait_<until|till|for>_{e}", "WAIT {e}", says="WAIT takes the condition alone"),
    Idiom("<waituntil|wait_until|waitfor|wait_for> sig ( {e} )", "WAIT SIG({e})", "other languages"),
    Idiom("<waituntil|wait_until>_{e}", "WAIT {e}", "other languages"),
    Idiom("wait_sig {d} <=|==|> <on|true|1|high|>", "WAIT SIG({d})", says="SIG without parentheses"),
    Idiom("wait_<signal|input|in|di> ( {d} )", "WAIT SIG({d})", says="a signal is asked for by SIG"),
    Idiom("wait_<signal|input|in|di>_{d} <=|==|> <on|true|1|high|>", "WAIT SIG({d})", says="a signal is asked for by SIG"),
    Idiom("wait_<signal|input|in|di>_{d} <=|==> <off|false|0|low>", "WAIT SIG(-{d})", says="a signal is asked for by SIG"),
    Idiom("wait_{d} <=|==> <on|true|1|high>", "WAIT SIG({d})", says="a signal is asked for by SIG", sure=False),
    # waiting for time
    Idiom("wait_for_{d} <s|sec|secs|seconds|second|>", "DELAY {d}", "other languages", note="WAIT takes a condition, DELAY a time in seconds"),
    Idiom("wait_{d} <s|sec|secs|seconds|second>", "DELAY {d}", "other languages", note="WAIT takes a condition, DELAY a time in seconds"),
    Idiom("wait_<sec|time|seconds>_{d}", "DELAY {d}", "KRL", note="WAIT takes a condition, DELAY a time in seconds"),
    Idiom("<waitfor|waittime|wait_time|sleep|time.sleep|pause|dwell|wait_sec|waitsec|twait|delay_s|timer_wait|hold|sleep_s> {d} <s|sec|secs|seconds|second|>", "DELAY {d}", "other languages"),
    Idiom("<waitfor|waittime|wait_time|sleep|time.sleep|pause|dwell|wait|delay> ( {e} )", "DELAY {e}", "other languages"),
    Idiom("<waitfor|waittime|wait_time|sleep|dwell>_{e}", "DELAY {e}", "other languages"),
    Idiom("delay_{d} <s|sec|secs|seconds|second>", "DELAY {d}", says="DELAY takes seconds, without a unit"),
    Idiom("delay_{d} <ms|msec|milliseconds>", "", says="DELAY takes seconds, without a unit", help="write the time in seconds: 500 ms is `DELAY 0.5`"),
    Idiom("<sleep|delay|wait>_{d} <ms|msec|milliseconds>", "", "other languages", help="write the time in seconds: 500 ms is `DELAY 0.5`"),
    Idiom("delay = {d}", "DELAY {d}", says="DELAY takes no `=`"),
    Idiom("<g4|g04> p {d}", "DELAY {d}", "G-code", sure=False),
    Idiom("<usleep|msleep|delay_ms|delayms|wait_ms> ( {r} )", "", "C", help="DELAY takes seconds: 500 ms is `DELAY 0.5`"),
    Idiom("react {e} , call_{n}", "REACT {e}, {n}", says="REACT takes the name of the program, without CALL"),
    Idiom("reacti {e} , call_{n}", "REACTI {e}, {n}", says="REACTI takes the name of the program, without CALL"),
    Idiom("pcexecute_call_{n}", "PCEXECUTE {n}", says="PCEXECUTE takes the name of the program, without CALL"),
)
