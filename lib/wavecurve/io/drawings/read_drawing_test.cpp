#include "wavecurve/io/drawings/read_drawing.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <unistd.h>
#include <zlib.h>

#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/drawing_test.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;
const fs::path examples = fs::path(WAVECURVE_SOURCE_DIR) / "docs/examples";
const fs::path shared = fs::path(WAVECURVE_SOURCE_DIR) / "../shared/data";

std::vector<fs::path> files_of(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ReadDrawing, ErrorsNameTheFile) {
  const fs::path folder =
      fs::temp_directory_path() / ("wavecurve-drawing-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto refused = [&](const std::string& name, const std::string& text) {
    write_file(folder / name, text);
    const std::string message = test::refusal([&] { read_drawing(folder / name); });
    EXPECT_EQ(message.find((folder / name).string()), 0U) << message;
    return message.substr(message.find(": ") + 2);
  };
  EXPECT_EQ(refused("a.svg", ""), "the file is empty");
  EXPECT_EQ(refused("a.csv", ""), "the file is empty");
  EXPECT_EQ(refused("a.txt", "x"), "a drawing is read from .svg, .svgz or .csv");
  EXPECT_EQ(refused("a.svg", "<svg/>"), "nothing is painted: no path or shape");
  EXPECT_EQ(refused("a.csv", "x,y\n"), "no points");
  write_file(folder / "B.SVG", "<svg><circle r='1'/></svg>");
  EXPECT_EQ(read_drawing(folder / "B.SVG").drawing.layers.size(), 1U);
  EXPECT_THROW(read_drawing(folder / "none.svg"), std::invalid_argument);
  fs::create_directories(folder / "folder.svg");
  EXPECT_THROW(read_drawing(folder / "folder.svg"), std::invalid_argument);
  fs::remove_all(folder);
}

TEST(ReadDrawing, PackedDrawingsAreUnpacked) {
  const fs::path path =
      fs::temp_directory_path() / ("wavecurve-packed-" + std::to_string(::getpid()) + ".svgz");
  const auto pack = [&](const std::string& text, std::size_t times) {
    gzFile file = gzopen(path.c_str(), "wb1");
    for (std::size_t i = 0; i < times; ++i) {
      gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    }
    gzclose(file);
  };
  pack("<svg viewBox='0 0 9 9'><circle id='a' r='1'/></svg>", 1);
  EXPECT_EQ(read_drawing(path).drawing.view_box, (ViewBox{0, 0, 9, 9}));
  EXPECT_EQ(read_drawing(path.string() + "#a").drawing.layers.at(0).id, "a");
  pack(std::string(std::size_t{1} << 20, ' '), 257);
  EXPECT_NE(
      test::refusal([&] { read_drawing(path); }).find("it unpacks to more than 268435456 bytes"),
      std::string::npos);
  fs::remove(path);
}

TEST(ReadDrawing, AMarkMayBePartOfTheName) {
  const fs::path path =
      fs::temp_directory_path() / ("wavecurve-mark#" + std::to_string(::getpid()) + ".svg");
  write_file(path, "<svg><circle id='a' r='1'/><circle id='b' r='1'/></svg>");
  EXPECT_EQ(read_drawing(path).drawing.layers.size(), 2U);
  EXPECT_EQ(read_drawing(path.string() + "#b").drawing.layers.size(), 1U);
  EXPECT_THROW(read_drawing(path, {.open = true}), std::invalid_argument);
  fs::remove(path);
}

TEST(ReadDrawing, AFileThatIsTooLargeIsRefused) {
  const fs::path path =
      fs::temp_directory_path() / ("wavecurve-large-" + std::to_string(::getpid()) + ".svg");
  std::ofstream(path) << ' ';
  fs::resize_file(path, (std::uintmax_t{256} << 20) + 1);
  const std::string message = test::refusal([&] { read_drawing(path); });
  EXPECT_NE(message.find("larger than 268435456 bytes"), std::string::npos) << message;
  fs::remove(path);
}

TEST(ReadDrawing, TheExamplesAreReadWithoutWarning) {
  for (const fs::path& path : files_of(examples, ".svg")) {
    const DrawingFile file = read_drawing(path);
    EXPECT_EQ(file.warnings, std::vector<std::string>()) << path;
    Eigen::AlignedBox2d box;
    for (const Layer& layer : file.drawing.layers) box.extend(test::box_of(layer.subpaths));
    const ViewBox& view = file.drawing.view_box;
    const Eigen::AlignedBox2d shown(Eigen::Vector2d(view.x, view.y),
                                    Eigen::Vector2d(view.x + view.width, view.y + view.height));
    EXPECT_TRUE(shown.contains(box)) << path;
  }
}

TEST(ReadDrawing, TheExamplesAreWhatTheyAreFor) {
  const auto read = [](const char* name) { return read_drawing(examples / name).drawing; };
  EXPECT_EQ(read("three.svg").layers.at(0).subpaths.size(), 1U);
  EXPECT_FALSE(read("stroke.svg").layers.at(0).subpaths.at(0).closed);
  const Layer ring = read("ring.svg").layers.at(0);
  ASSERT_EQ(ring.subpaths.size(), 2U);
  EXPECT_GT(test::area_of({ring.subpaths[0]}), 0);
  EXPECT_LT(test::area_of({ring.subpaths[1]}), 0);
  const Drawing dog = read("face-dog.svg"), cat = read("face-cat.svg");
  const std::vector<std::string> common = test::ids_of(dog), others = test::ids_of(cat);
  for (const std::string& id : common) {
    EXPECT_NE(std::find(others.begin(), others.end(), id), others.end()) << id;
  }
}

TEST(ReadDrawing, TheSharedDrawingsAreReadWithoutWarning) {
  if (!fs::exists(shared)) GTEST_SKIP() << "no " << shared;
  for (const char* folder : {"faces", "glyphs", "silhouettes"}) {
    for (const fs::path& path : files_of(shared / folder, ".svg")) {
      const DrawingFile file = read_drawing(path);
      EXPECT_EQ(file.warnings, std::vector<std::string>()) << path;
      for (const Layer& layer : file.drawing.layers) {
        EXPECT_TRUE(layer.paint.fill) << path;
        for (const Subpath& subpath : layer.subpaths) EXPECT_TRUE(subpath.closed) << path;
      }
    }
  }
  EXPECT_EQ(read_drawing(shared / "glyphs/DejaVuSans_8.svg").drawing.layers.at(0).subpaths.size(),
            3U);
}

TEST(ReadDrawing, TheSilhouettesAreTheSameInBothForms) {
  if (!fs::exists(shared)) GTEST_SKIP() << "no " << shared;
  for (const fs::path& path : files_of(shared / "silhouettes", ".csv")) {
    const auto points = read_drawing(path).drawing.layers.at(0).subpaths;
    fs::path svg = path;
    const auto outline = read_drawing(svg.replace_extension(".svg")).drawing.layers.at(0).subpaths;
    ASSERT_EQ(points.at(0).segments.size(), 1024U);
    ASSERT_EQ(outline.at(0).segments.size(), 1024U);
    for (std::size_t i = 0; i < 1024; ++i) {
      const Eigen::MatrixXd difference =
          points[0].segments[i].control - outline[0].segments[i].control;
      // The SVG files have two decimals, the points three.
      EXPECT_LE(difference.cwiseAbs().maxCoeff(), 0.0055) << path << i;
    }
  }
}

}  // namespace
}  // namespace wavecurve::io
