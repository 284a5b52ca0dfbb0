#pragma once
/// A number that counts what is done with it: the laws and the step written for it do what they
/// do for doubles, and say how much that was.

#include "dem/contact/pack.hpp"

#include <cmath>

namespace counting {

/// Number of operations done since the start.
inline long long operations = 0;

struct Mask {
    bool set;
    friend Mask operator|(Mask a, Mask b) { return ++operations, Mask{a.set || b.set}; }
    friend Mask operator&(Mask a, Mask b) { return ++operations, Mask{a.set && b.set}; }
    friend bool any(Mask m) { return ++operations, m.set; }
};

struct Counted {
    double x = 0.0;
    Counted() = default;
    Counted(double value) : x(value) {} // NOLINT: as Pack
    friend Counted operator+(Counted a, Counted b) { return ++operations, a.x + b.x; }
    friend Counted operator-(Counted a, Counted b) { return ++operations, a.x - b.x; }
    friend Counted operator*(Counted a, Counted b) { return ++operations, a.x * b.x; }
    friend Counted operator/(Counted a, Counted b) { return ++operations, a.x / b.x; }
    friend Counted operator-(Counted a) { return ++operations, -a.x; }
    Counted& operator+=(Counted b) { return *this = *this + b; }
    Counted& operator-=(Counted b) { return *this = *this - b; }
    friend Mask operator<(Counted a, Counted b) { return ++operations, Mask{a.x < b.x}; }
    friend Mask operator>(Counted a, Counted b) { return ++operations, Mask{a.x > b.x}; }
    friend Counted select(Mask m, Counted yes, Counted no)
    {
        return ++operations, m.set ? yes : no;
    }
    friend Counted sqrt(Counted a) { return ++operations, std::sqrt(a.x); }
    friend Counted rough_inverse_root(Counted a)
    {
        return operations += 2, dem::rough_inverse_root(a.x);
    }
    friend Counted multiply_add(Counted a, Counted b, Counted c)
    {
        return ++operations, std::fma(a.x, b.x, c.x);
    }
};

} // namespace counting
