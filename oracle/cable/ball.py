"""Real numbers enclosed in balls: their decimals, and the nearest f64 that the enclosure decides."""

from flint import arb, arb_poly, ctx, fmpq, fmpz

from ..fixtures import fixture

# Precision of every ball in bits, and stored digits. Radii near 1e-150 decide both digits and f64.
ctx.prec = 512
DIGITS = 40


def is_exact(values):
    """Whether nested lists hold only rational numbers."""
    if isinstance(values, (list, tuple)):
        return all(map(is_exact, values))
    return not isinstance(values, arb)


def at(polynomial, place):
    """A rational polynomial at a rational number, or enclosed at a ball."""
    return arb_poly(polynomial)(place) if isinstance(place, arb) else polynomial(place)


def decimal(ball):
    """Text with `DIGITS` significant digits; the error is at most one unit of the last digit."""
    assert ball.rel_accuracy_bits() > 300, f"the ball is too wide for {DIGITS} digits: {ball}"
    return ball.str(DIGITS, radius=False)


def nearest(value):
    """The f64 nearest to a rational number, or to every number in a ball."""
    if not isinstance(value, arb):
        return fixture.nearest(value)
    low, high = (fixture.nearest(rational(end)) for end in (value.lower(), value.upper()))
    assert low == high, f"the ball does not decide its nearest f64: {value}"
    return low


def rational(exact):
    """The rational value of a ball of radius zero."""
    mantissa, exponent = map(int, exact.man_exp())
    return fmpq(fmpz(mantissa)) * fmpq(2) ** exponent


def agree(a, b, size=0):
    """Whether two numbers agree. Rational numbers are equal; balls overlap and are tiny relative to the numbers or to `size`."""
    if is_exact([a, b]):
        return a == b
    a, b = arb(a), arb(b)
    largest = max(abs(float(a.mid())), abs(float(b.mid())), float(size))
    return a.overlaps(b) and float((a - b).rad()) <= 1e-100 * largest
