#include "wavecurve/io/animations/animated_svg.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wavecurve/io/animations/animation_sheet.hpp"
#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/animations/detail/control_points.hpp"

namespace wavecurve::io {
namespace {

/// All that stands between an opening and the next closing text. By hand, for std::regex recurses
/// over each character of a match, and path data are long.
std::vector<std::string> between(const std::string& text, const std::string& opening,
                                 const std::string& closing = "\"") {
  std::vector<std::string> result;
  std::size_t from = 0;
  while ((from = text.find(opening, from)) != std::string::npos) {
    from += opening.size();
    result.push_back(text.substr(from, text.find(closing, from) - from));
  }
  return result;
}

/// The values of the animated path data, one text a track.
std::vector<std::string> path_tracks(const std::string& svg) {
  std::vector<std::string> result;
  for (const std::string& element : between(svg, "attributeName=\"d\"", ">")) {
    result.push_back(between(element, " values=\"").at(0));
  }
  return result;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The numbers of path data.
std::vector<double> numbers(const std::string& path) {
  std::string text = path;
  std::ranges::replace_if(text, is_letter, ' ');
  std::istringstream stream(text);
  return {std::istream_iterator<double>(stream), {}};
}

/// Its letters alone.
std::string commands(const std::string& path) {
  std::string letters;
  std::ranges::copy_if(path, std::back_inserter(letters), is_letter);
  return letters;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ';');) parts.push_back(part);
  return parts;
}

TEST(AnimatedSvg, ValuesAreTheKeysToTheStatedAccuracy) {
  const motion::Animation animation = sample_animation();
  const auto tracks = path_tracks(animated_svg(animation));
  ASSERT_EQ(tracks.size(), 3U);
  for (std::size_t layer = 0; layer < 2; ++layer) {
    const std::vector<std::string> values = split(tracks[layer]);
    ASSERT_EQ(values.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      std::size_t i = 0;
      const std::vector<double> written = numbers(values[k]);
      for (const Contour& contour : animation.layers[layer].outline[k].contours) {
        for (Eigen::Index row = 0; row < contour.rows(); ++row) {
          // 1e-4 of a box of 100 asks for two places.
          EXPECT_NEAR(written.at(i++), contour(row, 0), 0.005 + 1e-9);
          EXPECT_NEAR(written.at(i++), contour(row, 1), 0.005 + 1e-9);
        }
      }
      EXPECT_EQ(i, written.size());
    }
  }
}

TEST(AnimatedSvg, ValuesOfATrackHaveTheSameCommands) {
  for (double tolerance : {0.0, 0.02}) {
    OutputOptions options;
    options.tolerance = tolerance;
    for (const std::string& track : path_tracks(animated_svg(sample_animation(), options))) {
      const std::vector<std::string> values = split(track);
      for (const std::string& value : values) {
        EXPECT_EQ(numbers(value).size(), numbers(values[0]).size());
        EXPECT_EQ(commands(value), commands(values[0]));
      }
    }
  }
}

TEST(AnimatedSvg, TimesRunFromZeroToOne) {
  const auto times = between(animated_svg(sample_animation()), "keyTimes=\"");
  EXPECT_EQ(times.back(), "0;0.25;0.75;1");
  for (const std::string& list : times) {
    EXPECT_EQ(split(list).front(), "0");
    EXPECT_EQ(split(list).back(), "1");
  }
}

TEST(AnimatedSvg, RepeatsOnRequestOrStaysAtItsEnd) {
  OutputOptions options;
  const std::string once = animated_svg(sample_animation(), options);
  options.loop = true;
  const std::string always = animated_svg(sample_animation(), options);
  EXPECT_NE(once.find("fill=\"freeze\""), std::string::npos);
  EXPECT_EQ(once.find("repeatCount"), std::string::npos);
  EXPECT_NE(always.find("repeatCount=\"indefinite\""), std::string::npos);
  EXPECT_EQ(always.find("fill=\"freeze\""), std::string::npos);
}

TEST(AnimatedSvg, AnimatesPaintsOnlyWhereTheyChangeAndEscapesIds) {
  const std::string svg = animated_svg(sample_animation());
  EXPECT_EQ(between(svg, "attributeName=\"fill\"").size(), 1U);
  EXPECT_EQ(between(svg, "attributeName=\"fill-opacity\"").size(), 1U);
  EXPECT_EQ(between(svg, "attributeName=\"stroke-width\"").size(), 1U);
  EXPECT_NE(svg.find("values=\"#ffcc33;#4d99ff\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"&lt;ring&gt; &amp; &quot;hole&quot;\""), std::string::npos);
}

TEST(AnimatedSvg, ShowsExchangedLayersByTurns) {
  const std::string svg = animated_svg(exchange_animation());
  EXPECT_EQ(between(svg, "<path id=\""),
            (std::vector<std::string>{"blue", "red", "blue-2", "line", "gone"}));
  EXPECT_EQ(between(svg, " visibility=\""), (std::vector<std::string>{"hidden", "visible"}));
  const std::string discrete = " calcMode=\"discrete\" dur=\"2s\" fill=\"freeze\" ";
  EXPECT_NE(svg.find("attributeName=\"visibility\"" + discrete +
                     "keyTimes=\"0;0.5;1\" values=\"hidden;visible;visible\""),
            std::string::npos);
  EXPECT_NE(svg.find("attributeName=\"stroke-linecap\"" + discrete +
                     "keyTimes=\"0;0.5;1\" values=\"square;round;round\""),
            std::string::npos);
  // An open line is not closed, whether as a polygon or as cubics.
  EXPECT_NE(svg.find("d=\"M60 20L80 20 80 60\""), std::string::npos);
  OutputOptions options;
  options.tolerance = 0.02;
  const std::string cubics = animated_svg(exchange_animation(), options);
  EXPECT_NE(cubics.find(";M60 30c"), std::string::npos);
  EXPECT_EQ(cubics.find("z;M60 30c"), std::string::npos);
}

TEST(AnimatedSvg, HasASizeAndABackground) {
  OutputOptions options;
  const std::string plain = animated_svg(sample_animation(), options);
  EXPECT_EQ(plain.find("<rect"), std::string::npos);
  EXPECT_EQ(plain.find(" width="), std::string::npos);
  options.size = RasterSize{400, 160};
  options.background = Colour{1, 0, 0};
  // The box of 100 by 80 gets 50 more on either side.
  EXPECT_NE(animated_svg(sample_animation(), options)
                .find("viewBox=\"-60 5 200 80\" width=\"400\" height=\"160\">\n"
                      "<rect x=\"-60\" y=\"5\" width=\"200\" height=\"80\" fill=\"#ff0000\"/>"),
            std::string::npos);
}

TEST(PathData, OfCubicsIsTheControlPointsInEitherForm) {
  const Contour contour =
      (Contour(6, 2) << 10, 20, 10.25, 20.5, 9.5, 19, 30, -0.25, 0, 0, -1, 1).finished();
  const Decimals decimals(2);
  EXPECT_EQ(path_data({contour}, true, decimals),
            "M10 20c.25 .5-.5-1 20-20.25-30 .25-31 1.25-20 20.25z");
  EXPECT_EQ(path_data({contour}, true, decimals, {}, Coordinates::absolute),
            "M10 20C10.25 20.5 9.5 19 30 -0.25 0 0 -1 1 10 20z");
  // Roundings do not add up: the last vertex of a long line is as near as the first.
  Contour line(301, 2);
  for (Eigen::Index i = 0; i < 301; ++i) line.row(i) << 0.3333 * static_cast<double>(i), 0;
  const std::string text = path_data({line}, true, Decimals(1), {true});
  double x = 0;
  std::size_t number = 0;
  for (const double value : numbers(text.substr(text.find('c') + 1))) {
    if (number++ % 6 == 4) x += value;
  }
  EXPECT_NEAR(x, 100, 0.05 + 1e-9);
}

TEST(AnimatedSvg, IsTheSameEachTime) {
  EXPECT_EQ(animated_svg(sample_animation()), animated_svg(sample_animation()));
}

TEST(AnimationSheet, ShowsTheFramesInReadingOrder) {
  OutputOptions options;
  options.frames = 5;
  const motion::Animation animation = sample_animation();
  const std::string sheet = animation_sheet(animation, options);
  EXPECT_EQ(between(sheet, "τ = ", "<"),
            (std::vector<std::string>{"0", "0.25", "0.5", "0.75", "1"}));
  const auto paths = between(sheet, " d=\"");
  ASSERT_EQ(paths.size(), 15U);
  const Decimals decimals = Decimals::for_box(animation.view_box, options.accuracy);
  for (std::size_t i = 0; i < 5; ++i) {
    const motion::FrameLayer face = motion::frame_at(animation, 0.5 * static_cast<double>(i))[0];
    EXPECT_EQ(paths[3 * i], path_data(face.contours, false, decimals)) << i;
  }
}

TEST(Decimals, AreShortAndRounded) {
  const Decimals decimals(3);
  EXPECT_EQ(decimals.text(0), "0");
  EXPECT_EQ(decimals.text(-0.0001), "0");
  EXPECT_EQ(decimals.text(0.05), "0.05");
  EXPECT_EQ(decimals.text(-12.5), "-12.5");
  EXPECT_EQ(decimals.text(1.9996), "2");
  EXPECT_EQ(decimals.text(120), "120");
  EXPECT_EQ(decimals.text(0.1234), "0.123");
  EXPECT_EQ(decimals.text(1e18), "1000000000000000000.000");
  EXPECT_EQ(Decimals(0).text(20.4), "20");
  EXPECT_EQ(Decimals::for_box({0, 0, 100, 20}, 1e-4).places(), 2);
  EXPECT_EQ(Decimals::for_box({0, 0, 24, 32}, 1e-4).places(), 3);
  EXPECT_EQ(Decimals::for_box({0, 0, 1e9, 1}, 1e-4).places(), 0);
}

}  // namespace
}  // namespace wavecurve::io
