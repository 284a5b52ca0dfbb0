"""The walls 1 to 6 of Ferris and Tin-Loi: dry units of 0.4 x 0.175 m, friction 0.65; 3 to 6 have openings."""

UNIT, HEIGHT, FRICTION = 0.4, 0.175, 0.65  # [m], [m], [-]

# Widths of each kind of course in units; negative: an opening. Then the courses from below.
WALLS = {
    1: ({"L": [0.5, 1, 1, 1, 1, 0.5], "M": [1] * 5}, "L M L M L M"),
    2: ({"L": [0.5, 1, 1, 1, 1, 0.5], "M": [1] * 5}, "L M L M L M L M L M"),
    3: ({"F": [1] * 4, "G": [0.5, 1, 1, 1, 0.5], "W": [1, 0.5, -1, 0.5, 1], "V": [0.5, 1, -1, 1, 0.5]}, "F G F V W V W V F G F"),
    4: ({"F": [0.5, 1, 1, 1, 1, 0.5], "G": [1] * 5, "V": [1, -1, 1, -1, 1], "W": [0.5, 0.5, -1, 0.5, 0.5, -1, 0.5, 0.5]},
        "F G F V W V W V F G F"),
    5: ({"F": [0.5, 1, 1, 0.5], "G": [1] * 3, "V": [1, -1, 1], "W": [0.5, 0.5, -1, 0.5, 0.5]}, "F G F V W V W V F G F V W V W V F G F"),
    6: ({"F": [0.5, 1, 1, 1, 1, 1, 1, 0.5], "G": [1] * 7, "V": [0.5, 1, -1, 1, 1, -1, 1, 0.5], "W": [1, 0.5, -1, 0.5, 1, 0.5, -1, 0.5, 1]},
        "F G F G V W V W V G F G V W V W V G F G F"),
}


def courses(wall):
    """Widths [m] of each course from below, negative for an opening."""
    kinds, order = WALLS[wall]
    return [[UNIT * width for width in kinds[kind]] for kind in order.split()]


def blocks(rows):
    """(course, left edge [m], right edge [m]) of each block of such courses."""
    return [(c, sum(map(abs, widths[:i])), sum(map(abs, widths[:i])) + width)
            for c, widths in enumerate(rows) for i, width in enumerate(widths) if width > 0]
