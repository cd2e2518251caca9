"""Colours that stay apart for people who see fewer of them, and in grey (hues by Okabe and Ito)."""

from typing import Literal

INK = "#14202e"
GREY = "#8a94a3"
FAINT = "#c9d0da"
PAPER = "#ffffff"
BLUE = "#0072b2"
GREEN = "#009e73"
ORANGE = "#e69f00"
PURPLE = "#b3559a"
SKY = "#56b4e9"
YELLOW = "#f0e442"
RED = "#d03a00"

Maker = Literal["given", "offset", "chord", "interior", "tube", "steiner"]
# Who placed a vertex.
MAKERS: dict[Maker, str] = {"given": INK, "offset": BLUE, "chord": GREEN, "interior": ORANGE, "tube": PURPLE,
                            "steiner": BLUE}

# Faces by their feature size over the mfs of the input: at least 1, 1/2, 1/4, .. and below the last.
FEATURE_FLOORS = (1, 2, 4, 8, 16, 32)
FEATURE_FILLS = ("#f6f8fb", "#e4ecf5", "#cddcec", "#aec8e0", "#86accf", "#5a8ab8", "#2f629a")
FEATURE_NAMES = ("1 or more", "1/2", "1/4", "1/8", "1/16", "1/32", "less than 1/32")
NO_TRIANGLE = "#f3c6de"


def tint(colour: str, share: float) -> str:
    """Return a colour mixed with white: `share` 1 leaves it as it is, 0 gives white."""
    parts = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(255 - (255 - part) * share):02x}" for part in parts)
