// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <ostream>

#include "boxwood/core/ray.h"
#include "boxwood/tree/tree.h"

namespace boxwood {

inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof(a)) == 0; }

/// The same answer to the last bit.
inline bool are_identical(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return same_bits(a->t, b->t) && same_bits(a->u, b->u) && same_bits(a->v, b->v) &&
           a->triangle == b->triangle && a->instance == b->instance;
}

inline bool are_identical(const Tree& a, const Tree& b) {
    if (a.order != b.order || a.nodes.size() != b.nodes.size()) return false;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        const Node &p = a.nodes[i], &q = b.nodes[i];
        if (!(p.box == q.box) || p.first != q.first || p.count != q.count) return false;
    }
    return true;
}

// How failed tests show these.
inline void PrintTo(const Hit& hit, std::ostream* out) {
    *out << "t " << hit.t << " u " << hit.u << " v " << hit.v << " triangle " << hit.triangle
         << " instance " << hit.instance;
}
inline void PrintTo(const Ray& ray, std::ostream* out) {
    const auto precision = out->precision(17);
    *out << "origin " << ray.origin.transpose() << " direction " << ray.direction.transpose()
         << " t " << ray.t_min << " to " << ray.t_max << " skip " << ray.skip.triangle;
    out->precision(precision);
}

}  // namespace boxwood
