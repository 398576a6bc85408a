"""All of them, in the order in which they are tried."""

from vrts.lang.dialect import Dialect
from vrts.lang.steps.misread.called_values import called_value
from vrts.lang.steps.misread.chains import chain
from vrts.lang.steps.misread.equals_behind import equals_behind
from vrts.lang.steps.misread.f_strings import f_string
from vrts.lang.steps.misread.foreign.inputs import asked_input
from vrts.lang.steps.misread.foreign.prose import prose
from vrts.lang.steps.misread.foreign.references import more_in_argument
from vrts.lang.steps.misread.foreign.results import several_results
from vrts.lang.steps.misread.foreign.words_between import word_between
from vrts.lang.steps.misread.format_letters import letter_behind
from vrts.lang.steps.misread.functions_given import given_function
from vrts.lang.steps.misread.hand_words import named_hand
from vrts.lang.steps.misread.joined_strings import joined_strings
from vrts.lang.steps.misread.left_out.blank import glued_number
from vrts.lang.steps.misread.left_out.compared import left_out_operand
from vrts.lang.steps.misread.left_out.quotes import opening_quote, unquoted_text
from vrts.lang.steps.misread.left_out.times import missing_times
from vrts.lang.steps.misread.meant import Meant
from vrts.lang.steps.misread.relatives.slips import slip
from vrts.lang.steps.misread.slips.brackets import odd_brackets
from vrts.lang.steps.misread.slips.digits_first import digit_first
from vrts.lang.steps.misread.slips.fillers import filler
from vrts.lang.steps.misread.slips.letters_in_numbers import letters_in_number
from vrts.lang.steps.misread.slips.lost_word import lost_word, stray_sign
from vrts.lang.steps.misread.slips.no_step import no_step
from vrts.lang.steps.misread.slips.odd_names import odd_name
from vrts.lang.steps.misread.slips.parted_names import odd_points, parted_name
from vrts.lang.steps.misread.slips.parted_words import parted_sign, parted_word
from vrts.lang.steps.misread.slips.twice import said_twice
from vrts.lang.steps.misread.slips.word_labels import word_label
from vrts.lang.steps.misread.surplus_parenthesis import surplus_parenthesis
from vrts.lang.steps.misread.units import unit_behind
from vrts.lang.steps.misread.value_ranges import value_range
from vrts.lang.steps.repair import Repair


def meant_by_line(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a line that is no step, where it is one of these."""
    return (
        slip(text, repair, dialect)
        or lost_word(text, repair, dialect)
        or stray_sign(text, repair, dialect)
        or parted_name(text, repair)
        or odd_points(text, repair)
        or chain(text)
        or said_twice(text, repair, dialect)
        or letters_in_number(text, repair)
        or asked_input(text, repair)
        or several_results(text, repair)
        or more_in_argument(text, repair, dialect)
        or word_between(text, repair, dialect)
        or f_string(text, repair)
        or unit_behind(text, repair)
        or letter_behind(text, repair)
        or unquoted_text(text, repair)
        or value_range(text)
        or glued_number(text, repair, dialect)
        or digit_first(text)
        or given_function(text, dialect)
        or called_value(text)
        or named_hand(text)
        or parted_sign(text, repair)
        or opening_quote(text, repair)
        or odd_brackets(text, repair, dialect)
        or parted_word(text, repair, dialect)
        or surplus_parenthesis(text, repair)
        or equals_behind(text, repair, dialect)
        or joined_strings(text, repair)
        or left_out_operand(text, repair)
        or missing_times(text, repair)
        or prose(text)
    )


def meant_after_all(text: str, repair: Repair, dialect: Dialect) -> Meant | None:
    """Return what is meant by a line that is no way of another language either."""
    return (
        word_label(text, repair, dialect)
        or odd_name(text, repair)
        or no_step(text, repair, dialect)
        or filler(text, repair, dialect)
    )
