// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "boxwood/query/ray_columns.h"

namespace boxwood {

/// Rays taken apart, and places for their hits.
class Columns {
public:
    explicit Columns(std::span<const Rayf> rays)
        : size_(rays.size()),
          hits_(6 * size_, -7.0f),
          numbers_(2 * size_, 7),
          any_(std::make_unique<bool[]>(size_)) {
        for (const Rayf& ray : rays) {
            // Something between one origin and the next, which must be left alone.
            origins_.insert(origins_.end(), {ray.origin[0], ray.origin[1], ray.origin[2], 1e30f});
            directions_.insert(directions_.end(), ray.direction, ray.direction + 3);
            t_min_.push_back(ray.t_min);
            t_max_.push_back(ray.t_max);
        }
    }

    RayColumns rays() const {
        return {size_,
                {origins_.data(), 4},
                {directions_.data(), 3},
                {t_min_.data(), 1},
                {t_max_.data(), 1}};
    }
    HitColumns hits() {
        float* const t = hits_.data();
        return {size_, t, numbers_.data(), numbers_.data() + size_, t + size_, t + 3 * size_};
    }
    std::span<bool> any() { return {any_.get(), size_}; }

    /// Whether those are the hits of an array; normals as near as rounding of three numbers allows.
    testing::AssertionResult hold(std::span<const Hitf> expected) {
        const HitColumns found = hits();
        for (std::size_t i = 0; i < size_; ++i) {
            const Hitf& hit = expected[i];
            const float numbers[] = {found.t[i], found.uv[2 * i], found.uv[2 * i + 1]};
            const std::uint32_t instance = hit.is_hit() ? hit.instance : Hitf::kNone;
            if (std::memcmp(numbers, &hit.t, sizeof numbers) != 0 ||
                found.triangle[i] != hit.triangle || found.instance[i] != instance)
                return testing::AssertionFailure() << "ray " << i << " of " << size_;
            const long double x = hit.normal[0], y = hit.normal[1], z = hit.normal[2];
            const long double length = std::sqrt(x * x + y * y + z * z);
            const float* const n = found.normal + 3 * i;
            if (!hit.is_hit()) {
                if (n[0] != 0 || n[1] != 0 || n[2] != 0)
                    return testing::AssertionFailure() << "a normal of ray " << i << ", a miss";
                continue;
            }
            if (!(length > 1e-30L && std::isfinite(length))) {
                // An area beyond float tells nothing of the direction.
                const float found_length = std::hypot(n[0], n[1], n[2]);
                if (!(std::fabs(found_length - 1) <= 1e-6f || (length == 0 && found_length == 0)))
                    return testing::AssertionFailure() << "the length of the normal of ray " << i;
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                if (!(std::fabs(n[k] - hit.normal[k] / length) <= 1e-7L))
                    return testing::AssertionFailure() << "the normal of ray " << i;
            }
        }
        return testing::AssertionSuccess();
    }

private:
    std::size_t size_;
    std::vector<float> origins_, directions_, t_min_, t_max_, hits_;
    std::vector<std::uint32_t> numbers_;
    std::unique_ptr<bool[]> any_;
};

}  // namespace boxwood
