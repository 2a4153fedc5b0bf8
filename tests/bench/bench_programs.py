# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs for the benchmarks, of any number of blocks. No two blocks are alike, so that nothing can
be joined or kept; the same number of blocks and seed give the same program."""
import random

RADII = (1, 2, 5, 10, 25)
LIMIT = 500  # mm: a path stays in a square of about this half side


def mixed_rs274(out, blocks, seed=1):
    """Mixed blocks: 34 of 100 are lines, the rest arcs, half of them by centre and half by R. Arcs are
    quarters and three quarters of circles, so that every end is exact in decimals."""
    chance = random.Random(seed)
    x = y = 0  # thousandths of a millimetre
    out.write("G21 G17 G90 G1 X0 Y0 F1000\n")
    for _ in range(blocks - 2):
        across = -1 if x > LIMIT * 1000 else 1 if x < -LIMIT * 1000 else chance.choice((-1, 1))
        along = -1 if y > LIMIT * 1000 else 1 if y < -LIMIT * 1000 else chance.choice((-1, 1))
        if chance.random() < 0.34:
            x += across * chance.randrange(1, 20000)
            y += along * chance.randrange(1, 20000)
            out.write("G1 X%.3f Y%.3f\n" % (x / 1000, y / 1000))
            continue
        radius = chance.choice(RADII)
        turn = chance.choice((2, 3))
        x += across * radius * 1000
        y += along * radius * 1000
        if chance.random() < 0.5:
            tail = "I%d" % (across * radius)
        else:
            tail = "R%d" % chance.choice((radius, -radius))
        out.write("G%d X%.3f Y%.3f %s\n" % (turn, x / 1000, y / 1000, tail))
    out.write("M2\n")


def rs274_cycles(out, blocks, seed=1):
    """Holes: drilled, dwelt in, pecked and bored, a third of the blocks repeating the cycle in force."""
    chance = random.Random(seed)
    out.write("G21 G17 G90 G98 F100\nG0 X0 Y0 Z10\n")
    cycle = None
    for _ in range(blocks - 3):
        place = "X%d.%03d Y%d" % (chance.randrange(-LIMIT, LIMIT), chance.randrange(1000),
                                 chance.randrange(-LIMIT, LIMIT))
        if cycle and chance.random() < 0.33:
            out.write(place + "\n")
            continue
        cycle = chance.choice(("G81", "G82", "G83", "G73", "G85", "G89"))
        words = {"G82": " P0.5", "G89": " P0.5", "G83": " Q2.5", "G73": " Q2.5"}.get(cycle, "")
        out.write("%s %s Z-%d.%d R%d%s\n" % (cycle, place, chance.randrange(1, 12),
                                            chance.randrange(10), chance.randrange(1, 4), words))
    out.write("M2\n")


def gsk_tapers(out, blocks, seed=1):
    """A taper cycle a block: four motions each."""
    del seed
    out.write("G18 G00 X2100 Z5 F200\nG94 X1 Z-30 R-1\n")
    for i in range(2, blocks - 1):
        out.write("N%d X%d.%d Z-%d R-%d.5;\n" % (i, i * 7 % 1999, i % 1000, 30 + i * 13 % 997,
                                                 i % 25))
    out.write("M30;\n")


def hnc_turning(out, blocks, seed=1):
    """A turning cycle a block: four motions each."""
    del seed
    out.write("%0001\nG00 X2100 Z5 F200\n")
    for i in range(3, blocks):
        out.write("N%d G80 X%d.%d Z-%d F%d\n" % (i, 2 + i * 7 % 1999, i % 1000, 30 + i * 13 % 997,
                                                 100 + i % 50))
    out.write("M30\n")


def sinumerik_contour(out, blocks, seed=1):
    """Lines and quarters of circles, a third of them by CR=."""
    chance = random.Random(seed)
    x = y = 0
    out.write("G17 G90 G71 G1 X0 Y0 F1000\n")
    for i in range(2, blocks):
        across, along = (-1 if v > LIMIT else 1 if v < -LIMIT else chance.choice((-1, 1))
                         for v in (x, y))
        kind = chance.randrange(3)
        radius = chance.choice(RADII)
        x += across * radius
        y += along * radius
        end = "N%d G%d X%d.%03d Y%d" % (i, (1, 2, 3)[kind], x, 0, y)
        out.write(end + ("\n" if kind == 0 else " CR=%d\n" % radius if kind == 1 else
                         " I%d J0\n" % (across * radius)))
    out.write("M30\n")


def gsk_pockets(out, blocks, seed=1):
    """A circular pocket a block: two levels, each cleared."""
    del seed
    out.write("G17 G00 X0 Y0 Z10\nG110 X20 Y10 W-3 R-1 I6 L4 Q2 D4 F200\n")
    for i in range(2, blocks - 1):
        out.write("X%d Y%d W-%d I%d.%d\n" % (i * 7 % 400, i * 13 % 300, 3 + i % 2, 6 + i % 4, i % 10))
    out.write("M30\n")


def gsk_threads(out, blocks, seed=1):
    """A milled thread a block: two passes."""
    del seed
    out.write("G17 G00 X0 Y0 Z10\nG114 X20 Y10 W-4 R-1 I2 E24 P1 Q0.6 D3 J0 F200\n")
    for i in range(2, blocks - 1):
        out.write("X%d Y%d W-%d R-1 I2 E%d P1 Q0.6 D3 J0\n" % (i * 7 % 400, i * 13 % 300, 4 + i % 3,
                                                           24 + i % 7))
    out.write("M30\n")
