#pragma once

// Everything of the link target wavecurve::io, namespace wavecurve::io: files. Drawings from SVG and
// CSV, animations as SVG, Lottie, pages and videos, traced limbs, filters, descriptors and matrices.
// Files are written whole or not at all.

#include "wavecurve/io/animations/animated_svg.hpp"
#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/io/animations/end_paths.hpp"
#include "wavecurve/io/animations/lottie.hpp"
#include "wavecurve/io/animations/output_options.hpp"
#include "wavecurve/io/animations/write_animation.hpp"
#include "wavecurve/io/descriptor_json.hpp"
#include "wavecurve/io/drawings/read_drawing.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"
#include "wavecurve/io/filter_json.hpp"
#include "wavecurve/io/load_filter.hpp"
#include "wavecurve/io/matrix_market.hpp"
#include "wavecurve/io/matrix_picture.hpp"
#include "wavecurve/io/tracks/gait_parameters_json.hpp"
#include "wavecurve/io/tracks/read_limb_tracks.hpp"
