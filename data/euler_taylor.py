#!/usr/bin/env python3
"""An oracle for the free rigid body that shares nothing with the library: Taylor series of y and q in decimal arithmetic.

    python3 data/euler_taylor.py > data/rigid_body_flow.csv

Each step of 1/16 sums 70 terms with 90 digits; the recurrences are Euler's equations and q' = 1/2 q (0, y/I), term by
term (Cauchy products). Halving the step changes no digit that is written. Python's standard library is all it needs.
"""
from decimal import Decimal, getcontext

getcontext().prec = 90
TERMS, PARTS = 70, 16  # terms a step, steps a unit of time
BODIES = [
    # inertia, momentum, attitude (exact decimals; the attitude need not be a unit quaternion to obey its equation)
    (("0.6", "0.8", "1.0"), ("1.8", "0.4", "-0.9"), ("1", "0", "0", "0")),
    (("0.6", "0.8", "1.0"), ("0.4", "0.3", "-1.7"), ("0.5", "-0.5", "0.5", "0.5")),
    (("0.9", "1.1", "1.7"), ("-0.6", "0.8", "1.9"), ("0.1", "0.7", "-0.7", "0.1")),
]


def product(a, b, n):
    """The n-th coefficient of the product of two series."""
    return sum(a[i] * b[n - i] for i in range(n + 1))


def series(inertia, y0, q0):
    """Taylor coefficients of y and q at y0, q0."""
    y, q = [[v] for v in y0], [[v] for v in q0]
    w = [[y0[j] / inertia[j]] for j in range(3)]
    for n in range(TERMS):
        rate_y = [product(y[(j + 1) % 3], w[(j + 2) % 3], n) - product(y[(j + 2) % 3], w[(j + 1) % 3], n) for j in range(3)]
        rate_q = [
            -product(q[1], w[0], n) - product(q[2], w[1], n) - product(q[3], w[2], n),
            product(q[0], w[0], n) + product(q[2], w[2], n) - product(q[3], w[1], n),
            product(q[0], w[1], n) + product(q[3], w[0], n) - product(q[1], w[2], n),
            product(q[0], w[2], n) + product(q[1], w[1], n) - product(q[2], w[0], n),
        ]
        for j in range(3):
            y[j].append(rate_y[j] / (n + 1))
            w[j].append(y[j][-1] / inertia[j])
        for j in range(4):
            q[j].append(rate_q[j] / (2 * (n + 1)))
    return y, q


def advance(inertia, y0, q0, h):
    y, q = series(inertia, y0, q0)
    horner = lambda c: sum(c[n] * h**n for n in reversed(range(len(c))))
    return [horner(c) for c in y], [horner(c) for c in q]


def main():
    print("body,time,y1,y2,y3,q0,q1,q2,q3")
    for body, (inertia, y, q) in enumerate(BODIES):
        inertia, y, q = ([Decimal(v) for v in values] for values in (inertia, y, q))
        for time in range(1, 11):
            for _ in range(PARTS):
                y, q = advance(inertia, y, q, Decimal(1) / PARTS)
            print(body, time, *(f"{v:.60e}" for v in y + q), sep=",")


if __name__ == "__main__":
    main()
