"""The errors that a user can cause: each says what is wrong, and where.

`InputError` is the base: the command line turns it into one line on standard error and exit status 2. A claim
that fails is no error but a `Verdict` (see `exactmesh.claims.verdict`).
"""


class InputError(ValueError):
    """The input is refused: the message names the place and the reason."""


class FormatError(InputError):
    """A file is not what it claims to be; `place` says where in it."""

    def __init__(self, place: str, reason: str) -> None:
        super().__init__(f"{place}: {reason}" if place else reason)
        self.place = place
        self.reason = reason


class GeometryError(InputError):
    """A planar straight-line graph is not one: two features meet where they must not."""


class ConstructionFailed(RuntimeError):
    """A construction step found no candidate: a counterexample to the design, worth keeping.

    `place` is the exact input of the step that failed.
    """

    def __init__(self, step: str, place: object) -> None:
        super().__init__(f"{step} failed on {place}")
        self.step = step
        self.place = place
