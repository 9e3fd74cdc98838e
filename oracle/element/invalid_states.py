"""`fixtures/invalid.json`: element states that a program must reject, each with the wrong key and the reason."""

import copy

from ..fixtures import fixture
from .equations import inputs, nearest_angle
from .states import states

FILE = "invalid.json"

CONVENTIONS = {
    "states": "`state` has the shape of a state of equations.json and is that of `base` but for `key`. A program that is "
              "asked for `equation` has to answer with an error, not with a value.",
    "edits": "never by hand: the command under generator writes this file, and with --check compares it.",
}

BASE = "random-bar-2d"

SIZE = "a length is positive"
PRINCIPLE = "a positive modulus and -1 < nu < 1/2: otherwise (17) is infinite or the energy not positive"

# Id, requested quantity, key, its wrong value (or a function of the right one; None removes the key), reason.
CASES = (
    ("length-zero", "3.S", "l", 0.0, SIZE),
    ("length-negative", "3.S", "l", -4.0, SIZE),
    ("height-zero", "7.M", "h", 0.0, SIZE),
    ("height-negative", "21.K_1", "h", -0.5, SIZE),
    ("width-zero", "7.M", "w", 0.0, SIZE),
    ("width-negative", "18.U", "w", -0.25, SIZE),
    ("modulus-negative", "17.mu", "E", -2600.0, PRINCIPLE),
    ("modulus-zero", "16.D", "E", 0.0, PRINCIPLE),
    ("poisson-half", "17.lambda", "nu", 0.5, PRINCIPLE),
    ("poisson-beyond-half", "17.lambda", "nu", 0.6, PRINCIPLE),
    ("poisson-minus-one", "17.mu", "nu", -1.0, PRINCIPLE),
    ("density-zero", "22.eddot", "rho", 0.0, "a density is positive: the mass matrix has no inverse"),
    ("density-negative", "6.T", "rho", -1200.0, "a density is positive"),
    ("cold-beyond-nothing", "8.epsilon_T", "dT", -1000.0, "1 + 2 alpha dT is the square of the stretch without stress, and positive"),
    ("model-unknown", "8.epsilon_T", "model", "3d", "one of none, 1d, 2d"),
    ("e-short", "1.r", "e", lambda e: e[:13], "14 numbers"),
    ("e-long", "1.r", "e", lambda e: [*e, 0.0, 0.0], "14 numbers"),
    ("e-null", "1.r", "e", lambda e: [*e[:5], None, *e[6:]], "numbers"),
    ("e-missing", "1.r", "e", None, "it is there"),
    ("edot-text", "5.rdot", "edot", lambda e: [*map(str, e)], "numbers"),
    ("initial-collapsed", "9.J", "e0", [0.0] * 14, "the initial element is straight, unstretched and l long: J_0 has an inverse"),
    ("initial-stretched", "11.S_a", "e0", lambda e: [2 * v for v in e],
     "the initial element is straight, unstretched and l long: (11) rests on it"),
    ("angle-of-another-element", "11.S_a", "theta", lambda angle: angle + 0.125, "theta is the inclination of e0"),
    ("points-empty", "1.r", "points", [], "a quantity of a point has one value for each: none says nothing"),
    ("point-beyond-the-end", "1.r", "points", [[5.0, 0.0]], "0 <= x <= l"),
    ("point-above-the-section", "9.J", "points", [[1.0, 0.375]], "|y| <= h/2"),
)


def generate():
    """The fixture."""
    (base,) = (state for state in states() if state.id == BASE)
    state = inputs(base, fixture.nearest, {"theta": nearest_angle(*base.direction)})
    assert len({case[0] for case in CASES}) == len(CASES), "ids must be unique"
    entries = [entry(state, *case) for case in CASES]
    return {
        "schema": "ancf-invalid/1",
        "title": "Element states that have to be refused",
        "generator": {"command": "python -m oracle invalid"},
        "conventions": CONVENTIONS,
        "base": BASE,
        "states": entries,
        "cases": entries,
    }


def entry(state, id, quantity, key, value, because):
    """One case. The value None removes the key; a function computes the wrong value from the right one."""
    changed = copy.deepcopy(state)
    if value is None:
        del changed[key]
    else:
        changed[key] = value(changed[key]) if callable(value) else value
    assert changed != state
    return {"id": id, "tags": ["invalid"], "equation": quantity, "key": key, "because": because, "state": changed}


differences = fixture.differences
