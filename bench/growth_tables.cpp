// SPDX-License-Identifier: Apache-2.0
#include "growth_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace boxwood::bench {

namespace {

struct Point {
    double x, y;
};

/// Of the straight line with the least squares; nothing for less than two places.
std::optional<double> slope(const std::vector<Point>& points) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const Point& point : points) {
        x += point.x;
        y += point.y;
    }
    x /= static_cast<double>(points.size());
    y /= static_cast<double>(points.size());
    for (const Point& point : points) {
        xx += (point.x - x) * (point.x - x);
        xy += (point.x - x) * (point.y - y);
    }
    if (!(xx > 0)) return std::nullopt;
    return xy / xx;
}

double log2_of(std::size_t n) { return std::log2(static_cast<double>(n)); }

/// How one name's times grow.
struct Fit {
    std::string name;
    std::optional<double> build_exponent;
    struct Rays {
        std::optional<double> exponent;
        std::optional<double> ns_a_doubling;
    };
    std::vector<Rays> rays;
};

Fit fit_of(const std::string& name, const std::vector<GrowthScore>& scores, std::size_t kinds) {
    std::vector<Point> builds;
    std::vector<std::vector<Point>> exponents(kinds), doublings(kinds);
    for (const GrowthScore& score : scores) {
        if (score.name != name) continue;
        const double x = log2_of(score.triangles);
        builds.push_back({x, std::log2(score.build_seconds)});
        for (std::size_t i = 0; i < score.seconds_per_ray.size(); ++i) {
            exponents[i].push_back({x, std::log2(score.seconds_per_ray[i])});
            doublings[i].push_back({x, 1e9 * score.seconds_per_ray[i]});
        }
    }
    Fit fit = {name, slope(builds), {}};
    for (std::size_t i = 0; i < kinds; ++i)
        if (!exponents[i].empty()) fit.rays.push_back({slope(exponents[i]), slope(doublings[i])});
    return fit;
}

/// In the order of the names.
std::vector<Fit> fits_of(const std::vector<GrowthScore>& scores, std::size_t kinds) {
    std::vector<Fit> fits;
    for (const GrowthScore& score : scores) {
        const bool is_known = std::any_of(fits.begin(), fits.end(),
                                          [&](const Fit& fit) { return fit.name == score.name; });
        if (!is_known) fits.push_back(fit_of(score.name, scores, kinds));
    }
    return fits;
}

double ns_a_step(const GrowthScore& score) {
    return 1e9 * score.build_seconds /
           (static_cast<double>(score.triangles) * log2_of(score.triangles));
}

}  // namespace

void print_growth(const std::vector<GrowthScore>& scores, const std::vector<std::string>& kinds) {
    fmt::print("  {:<16}{:>12}{:>12}", "", "build ms", "ns a step");
    for (const std::string& kind : kinds) fmt::print("{:>16}", kind + " ns");
    fmt::print("\n");
    for (const GrowthScore& score : scores) {
        fmt::print("  {:<16}{:>12.2f}{:>12.2f}", score.name, 1e3 * score.build_seconds,
                   ns_a_step(score));
        for (const double seconds : score.seconds_per_ray) fmt::print("{:>16.1f}", 1e9 * seconds);
        fmt::print("\n");
    }
}

void print_fits(const std::vector<GrowthScore>& scores, const std::vector<std::string>& kinds) {
    for (const Fit& fit : fits_of(scores, kinds.size())) {
        if (!fit.build_exponent) continue;
        fmt::print("{:<16} build n^{:.2f}", fit.name, *fit.build_exponent);
        for (std::size_t i = 0; i < fit.rays.size(); ++i)
            fmt::print(", {} n^{:.2f}, {:+.1f} ns a doubling", kinds[i], *fit.rays[i].exponent,
                       *fit.rays[i].ns_a_doubling);
        fmt::print("\n");
    }
}

nlohmann::ordered_json as_json(const std::vector<GrowthScore>& scores,
                               const std::vector<std::string>& kinds) {
    nlohmann::ordered_json json = {{"scores", nlohmann::ordered_json::array()},
                                   {"fits", nlohmann::ordered_json::array()}};
    for (const GrowthScore& score : scores) {
        nlohmann::ordered_json rays = nlohmann::ordered_json::object();
        for (std::size_t i = 0; i < score.seconds_per_ray.size(); ++i)
            rays[kinds[i]] = score.seconds_per_ray[i];
        json["scores"].push_back({{"mesh", score.mesh},
                                  {"triangles", score.triangles},
                                  {"name", score.name},
                                  {"build_seconds", score.build_seconds},
                                  {"ns_a_step", ns_a_step(score)},
                                  {"seconds_per_ray", rays}});
    }
    for (const Fit& fit : fits_of(scores, kinds.size())) {
        if (!fit.build_exponent) continue;
        nlohmann::ordered_json rays = nlohmann::ordered_json::object();
        for (std::size_t i = 0; i < fit.rays.size(); ++i)
            rays[kinds[i]] = {{"exponent", *fit.rays[i].exponent},
                              {"ns_a_doubling", *fit.rays[i].ns_a_doubling}};
        json["fits"].push_back(
            {{"name", fit.name}, {"build_exponent", *fit.build_exponent}, {"rays", rays}});
    }
    return json;
}

}  // namespace boxwood::bench
