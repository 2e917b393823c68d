// SPDX-License-Identifier: Apache-2.0
// heat: what a picture costs. Each pixel shows the steps that its camera ray takes through the
// tree, boxes visited plus primitives tested, from black for none to pale yellow for the most.
#include "boxwood/render/heat.h"

#include <algorithm>

#include "boxwood/image/color_bar.h"
#include "boxwood/image/color_map.h"

namespace boxwood {

std::vector<Color> HeatIntegrator::radiances(std::span<const Ray> rays) const {
    std::vector<Color> colors;
    colors.reserve(rays.size());
    for (const Ray& ray : rays) {
        TraversalCounts counts;
        surfaces_.closest_hit(ray, &counts);
        colors.emplace_back(Color::Constant(static_cast<double>(counts.steps())));
    }
    return colors;
}

void HeatIntegrator::develop(ColorImage& image) const {
    double most = 1;
    for (const Color& pixel : image.pixels) most = std::max(most, pixel.x());
    for (Color& pixel : image.pixels) pixel = heat_color(pixel.x() / most);
    draw_color_bar(image, static_cast<int>(most));
}

}  // namespace boxwood
