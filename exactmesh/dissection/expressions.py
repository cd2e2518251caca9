"""Read exact numbers: integers, decimals, + - * / ( ) and sqrt( ), as Python and SymPy write and read them.

Output of `Real.expression()` is read back as the same number. Powers and names are refused. A decimal stands for the
rational that is written.
"""

import re

from exactmesh.errors import FormatError
from exactmesh.io.text import quoted
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.radicals import TooManyRoots
from exactmesh.numbers.rational import rational_from_text

MAX_LENGTH = 20_000
MAX_DEPTH = 40
_TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d*)?|\.\d+)|(sqrt\b|[-+*/()]))", re.ASCII)
_PLAIN = re.compile(r"[-+]?\d+(?:/\d+|\.\d*)?", re.ASCII)


class ExpressionReader:
    """Reads expressions; each text is evaluated once. Raises `FormatError` for what is no expression of a real."""

    def __init__(self) -> None:
        self._known: dict[str, Real] = {}

    def __call__(self, text: str) -> Real:
        value = self._known.get(text)
        if value is None:
            value = self._known[text] = _evaluated(text)
        return value


def _evaluated(text: str) -> Real:
    if len(text) > MAX_LENGTH:
        raise FormatError("", f"an expression of {len(text)} characters is too long: at most {MAX_LENGTH} are read")
    if _PLAIN.fullmatch(text):
        return Real(rational_from_text(text))
    try:
        parser = _Parser(text)
        value = parser.sum(0)
    except ZeroDivisionError:
        raise FormatError("", f"{quoted(text)} divides by zero") from None
    except TooManyRoots as error:
        raise FormatError("", f"{quoted(text)}: {error}") from None
    if parser.next is not None:
        raise parser.refused()
    return value


class _Parser:
    """Recursive descent; `next` is the token ahead, None at the end."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.place = 0
        self.next: str | None = None
        self._advance()

    def refused(self) -> FormatError:
        """Return the error for the token ahead."""
        what = "ends too early" if self.next is None else f"has {self.next!r} where it cannot be"
        return FormatError("", f"{quoted(self.text)} is no exact number: it {what}")

    def _advance(self) -> None:
        if not self.text[self.place :].strip():
            self.next = None
            return
        match = _TOKEN.match(self.text, self.place)
        if match is None:
            self.next = self.text[self.place :].strip()[0]
            raise self.refused()
        self.next = match[1] or match[2]
        self.place = match.end()

    def sum(self, depth: int) -> Real:
        """Read terms joined by + and -."""
        if depth > MAX_DEPTH:
            raise FormatError("", f"{quoted(self.text)} is nested more than {MAX_DEPTH} deep")
        value = self._product(depth)
        while self.next in ("+", "-"):
            sign = self.next
            self._advance()
            term = self._product(depth)
            value = value + term if sign == "+" else value - term
        return value

    def _product(self, depth: int) -> Real:
        value = self._factor(depth)
        while self.next in ("*", "/"):
            sign = self.next
            self._advance()
            factor = self._factor(depth)
            value = value * factor if sign == "*" else value / factor
        return value

    def _factor(self, depth: int) -> Real:
        negative = False
        while self.next in ("+", "-"):
            negative ^= self.next == "-"
            self._advance()
        value = self._atom(depth)
        return -value if negative else value

    def _atom(self, depth: int) -> Real:
        token = self.next
        if token is None or token in ")*/":
            raise self.refused()
        self._advance()
        if token not in ("(", "sqrt"):
            return Real(rational_from_text(token))
        if token == "sqrt":
            if self.next != "(":
                raise self.refused()
            self._advance()
        value = self.sum(depth + 1)
        if self.next != ")":
            raise self.refused()
        self._advance()
        if token == "(":
            return value
        if value.sign() < 0:
            raise FormatError("", f"{quoted(self.text)} has the square root of a negative number")
        return value.sqrt()
