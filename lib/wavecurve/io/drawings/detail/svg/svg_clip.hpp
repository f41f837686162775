#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/io/drawings/detail/svg/region.hpp"
#include "wavecurve/io/drawings/detail/svg/svg_style.hpp"

namespace wavecurve::io {

/// Clips the layers of one file to clip paths and viewports. All that it throws is std::invalid_argument with the
/// reason why something cannot be clipped.
class Clipping {
 public:
  /// Where an element stands that is clipped: its coordinates, and what it draws.
  struct Place {
    Eigen::Affine2d transform;
    Viewport viewport;
    std::span<const Layer> layers;
  };

  /// What a value of the property clip-path lets through: the union of the shapes of the element <clipPath> that it
  /// refers to, within what the clip paths of that element and of its shapes let through.
  Region region(std::string_view value, const Place& place, const StyleSource& source);

  /// What remains of a layer within a region: the layer as it is where that changes nothing to be seen, else its fill
  /// and its stroke as polygons to be filled, if there is something of them. No longer one layer where it had both.
  std::vector<Layer> clipped(const Layer& layer, const Region& region);

 private:
  Region region_of_element(const XmlElement& clip, const Place& place, const StyleSource& source);
  Region region_of_shape(const XmlElement& shape, const Properties& outer, const Place& place,
                         const StyleSource& source);
  Region within_its_own(Region region, const Properties& properties, const Place& place,
                        const StyleSource& source);
  bool is_within(const Layer& layer, const Region& region);
  std::vector<Contour> polygons(const std::vector<Subpath>& subpaths, double size);
  Eigen::AlignedBox2d box_of_layers(const Place& place);
  void take_steps(std::size_t count);
  void take_steps(const std::vector<Contour>& polygons, const Region& region);

  std::vector<const XmlElement*> used_;  ///< those in which the one that is read is used
  std::size_t steps_ = 0;
};

/// A box in coordinates that a transformation maps to those of the drawing.
Region region_of(const ViewBox& box, const Eigen::Affine2d& transform);

}  // namespace wavecurve::io
