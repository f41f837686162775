#include "wavecurve/io/animations/write_animation.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/io/animations/animation_test.hpp"
#include "wavecurve/io/animations/detail/html_player.hpp"
#include "wavecurve/io/files/read_file.hpp"
#include "wavecurve/io/files/write_file.hpp"

namespace wavecurve::io {
namespace {

namespace fs = std::filesystem;

class WriteAnimation : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    options_.frames = 4;
    options_.pixels = 64;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t entries(const fs::path& folder) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
  }
  void write(const fs::path& path) const { write_animation(path, sample_animation(), options_); }

  fs::path folder_ =
      fs::temp_directory_path() / ("wavecurve write animation " + std::to_string(::getpid()));
  OutputOptions options_;
};

TEST_F(WriteAnimation, WritesEveryFormatTwiceTheSame) {
  const std::pair<std::string, std::string> beginnings[] = {
      {".svg", "<svg"}, {".json", "{"}, {".html", "<!doctype html>"}, {".gif", "GIF89a"}};
  for (const AnimationFormat& format : animation_formats()) {
    const std::string ending(format.ending);
    const fs::path path = folder_ / ("a" + ending);
    if (ending == ".png") continue;
    write(path);
    const std::string first = read_file(path);
    for (const auto& [name, beginning] : beginnings) {
      if (name != ending) continue;
      EXPECT_EQ(first.substr(0, beginning.size()), beginning);
    }
    EXPECT_GT(first.size(), 500U) << ending;
    write(path);
    EXPECT_EQ(read_file(path), first) << ending;
  }
  EXPECT_EQ(entries(folder_), animation_formats().size() - 1);
}

TEST_F(WriteAnimation, APngIsAFolderOfFrames) {
  const fs::path path = folder_ / "a.png";
  int calls = 0;
  options_.progress = [&](int done, int all) {
    EXPECT_EQ(done, ++calls);
    EXPECT_EQ(all, 4);
  };
  write(path);
  EXPECT_EQ(calls, 4);
  EXPECT_EQ(entries(path), 4U);
  EXPECT_EQ(read_file(path / "frame-0004.png").substr(1, 3), "PNG");
  calls = 0;
  options_.frames = 4;
  write(path / "");  // a folder of frames is replaced
  EXPECT_EQ(entries(path), 4U);
  write_file(path / "letter.txt", "not ours");
  EXPECT_THROW(write(path), std::system_error);
  EXPECT_EQ(read_file(path / "letter.txt"), "not ours");
  EXPECT_EQ(entries(folder_), 1U);
}

TEST_F(WriteAnimation, FramesDecodeToWhatWasRendered) {
  write(folder_ / "a.png");
  write(folder_ / "a.mp4");
  const std::string probe =
      "ffprobe -v error -count_frames -show_entries "
      "stream=width,height,nb_read_frames,pix_fmt -of csv=p=0 '" +
      (folder_ / "a.mp4").string() + "' >'" + (folder_ / "out").string() + "'";
  ASSERT_EQ(std::system(probe.c_str()), 0);
  EXPECT_EQ(read_file(folder_ / "out"), "64,52,yuv420p,4\n");
}

/// What ffprobe says of a video, and of what is decoded from it.
std::string probed(const fs::path& video, const fs::path& out, const std::string& entries) {
  const std::string command = "ffprobe -v error -show_entries " + entries + " -of csv=p=0 '" +
                              video.string() + "' >'" + out.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return read_file(out);
}

/// The opacity of a pixel at the left upper corner of the first frame, and of the one in the middle.
std::string opacities(const fs::path& video, const fs::path& out) {
  const std::string decoder = video.extension() == ".webm" ? "-c:v libvpx-vp9 " : "";
  const std::string command = "ffmpeg -v error -y " + decoder + "-i '" + video.string() +
                              "' -frames:v 1 -pix_fmt rgba -f rawvideo '" + out.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  const std::string bytes = read_file(out);
  EXPECT_EQ(bytes.size(), 64U * 52 * 4);
  return std::to_string(static_cast<unsigned char>(bytes.at(3))) + " " +
         std::to_string(static_cast<unsigned char>(bytes.at(4 * (64 * 26 + 32) + 3)));
}

TEST_F(WriteAnimation, FilmsMayBeTransparent) {
  for (const char* name : {"a.gif", "a.webm"}) {
    write(folder_ / name);
    EXPECT_EQ(opacities(folder_ / name, folder_ / "out"), "255 255") << name;
  }
  options_.transparent = true;
  for (const char* name : {"a.gif", "a.webm"}) {
    write(folder_ / name);
    EXPECT_EQ(opacities(folder_ / name, folder_ / "out"), "0 255") << name;
  }
  EXPECT_THROW(write(folder_ / "a.mp4"), std::invalid_argument);
  options_.background = Colour{1, 0, 0};  // then nothing shows through
  write(folder_ / "a.gif");
  EXPECT_EQ(opacities(folder_ / "a.gif", folder_ / "out"), "255 255");
}

TEST_F(WriteAnimation, FilmsHaveTheSizeAsked) {
  options_.size = RasterSize{81, 50};
  write(folder_ / "a.gif");
  EXPECT_EQ(probed(folder_ / "a.gif", folder_ / "out", "stream=width,height"), "81,50\n");
  EXPECT_THROW(write(folder_ / "a.mp4"), std::invalid_argument);
  EXPECT_THROW(write(folder_ / "a.webm"), std::invalid_argument);
  options_.size = RasterSize{80, 50};
  write(folder_ / "a.mp4");
  EXPECT_EQ(probed(folder_ / "a.mp4", folder_ / "out", "stream=width,height"), "80,50\n");
  options_.frames = 500;  // in two seconds
  EXPECT_THROW(write(folder_ / "a.gif"), std::invalid_argument);
}

TEST_F(WriteAnimation, UnwritablePlacesAreReportedAndLeaveNothing) {
  for (const AnimationFormat& format : animation_formats()) {
    const std::string name = "a" + std::string(format.ending);
    EXPECT_THROW(write(folder_ / "missing" / name), std::system_error) << name;
  }
  EXPECT_EQ(entries(folder_), 0U);
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const AnimationFormat& format : animation_formats()) {
    if (format.ending == ".png") continue;
    const fs::path full = folder_ / ("full" + std::string(format.ending));
    fs::create_symlink("/dev/full", full);
    EXPECT_THROW(write(full), std::system_error) << full;
  }
}

TEST_F(WriteAnimation, WithoutFfmpegAVideoIsOneClearLine) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  try {
    write(folder_ / "a.mp4");
    ADD_FAILURE();
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot run ffmpeg"), std::string::npos);
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(entries(folder_), 0U);
}

TEST_F(WriteAnimation, AnFfmpegThatFailsIsQuoted) {
  std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\necho 'no such codec' >&2\nexit 1\n";
  fs::permissions(folder_ / "ffmpeg", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder_.string() + ":" + path).c_str(), 1);
  try {
    write(folder_ / "a.webm");
    ADD_FAILURE();
  } catch (const std::system_error& error) {
    EXPECT_NE(std::string(error.what()).find("no such codec"), std::string::npos) << error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(entries(folder_), 1U);
}

TEST_F(WriteAnimation, AnotherEndingIsRefusedWithTheKnownOnes) {
  for (const char* name : {"a.avi", "a", ".svg"}) {
    try {
      write(folder_ / name);
      ADD_FAILURE() << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("none of .svg .json (Lottie) .html .gif"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST_F(WriteAnimation, AMorphThatLoopsGoesThereAndBack) {
  options_.loop = true;
  write_animation(folder_ / "a.json", sample_morph(motion::Detail::blend), options_);
  const nlohmann::json json = nlohmann::json::parse(read_file(folder_ / "a.json"));
  EXPECT_EQ(json["op"], 7);
  const auto keys = json["layers"][0]["shapes"][0]["it"][0]["ks"]["k"];
  ASSERT_EQ(keys.size(), 3U);
  EXPECT_EQ(keys[0]["s"], keys[2]["s"]);
}

/// The data of a page.
nlohmann::json data_of(const std::string& html) {
  const std::string mark = "id=\"animation\">";
  const std::size_t start = html.find(mark) + mark.size();
  return nlohmann::json::parse(html.substr(start, html.find("</script>", start) - start));
}

TEST(HtmlPlayer, HoldsTheCoefficientsAndTheTaps) {
  const motion::Morph morph = sample_morph(motion::Detail::stage);
  const nlohmann::json data = data_of(html_player(morph));
  EXPECT_EQ(data["detail"], "stage");
  EXPECT_EQ(data["levels"], 4);
  EXPECT_EQ(data["bank"]["low"]["taps"].get<std::vector<double>>(), morph.bank.synthesis_low.taps);
  EXPECT_EQ(data["bank"]["high"]["first"], morph.bank.synthesis_high.first_index);
  const nlohmann::json layer = data["layers"][1];
  EXPECT_EQ(layer["scale"], 32);
  const auto source = layer["contours"][0]["source"].get<std::vector<double>>();
  const Contour& expected = morph.layers[1].contours[0].source;
  ASSERT_EQ(source.size(), 512U);
  // 1e-5 of a box of 100 asks for three places.
  for (Eigen::Index i = 0; i < 512; ++i) {
    EXPECT_NEAR(source[static_cast<std::size_t>(i)], expected(i / 2, i % 2), 0.0005 + 1e-9);
  }
}

TEST(HtmlPlayer, LeavesOutDetailsTooSmallToMatter) {
  const motion::Morph morph = sample_morph(motion::Detail::blend);
  OutputOptions options;
  options.tolerance = 0.05;
  const std::string html = html_player(morph, options);
  const nlohmann::json data = data_of(html);
  EXPECT_LT(data.dump().size(),
            0.7 * static_cast<double>(data_of(html_player(morph)).dump().size()));
  for (std::size_t layer = 0; layer < 2; ++layer) {
    const motion::ContourPair& pair = morph.layers[layer].contours[0];
    const nlohmann::json& contour = data["layers"][layer]["contours"][0];
    for (const auto& [name, exact] :
         {std::pair{"source", &pair.source}, {"destination", &pair.destination}}) {
      std::vector<double> numbers;
      for (const nlohmann::json& value : contour[name]) {
        if (value.is_number()) numbers.push_back(value);
        if (value.is_string())
          numbers.resize(numbers.size() + 2 * std::stoul(value.get<std::string>()));
      }
      ASSERT_EQ(numbers.size(), 512U) << name;
      const Contour written =
          Eigen::Map<Eigen::Matrix<double, 256, 2, Eigen::RowMajor>>(numbers.data());
      const Contour moved = to_samples(morph.bank, written - *exact, morph.levels);
      // Each coefficient is rounded by 0.0005, and a point is a sum of few of them: of 4 + 1 levels the taps
      // of bspline-like and Daubechies' filters sum to less than 4 in absolute value.
      EXPECT_LE(moved.rowwise().norm().maxCoeff(), 0.05 + 5 * 4 * 0.0005 * std::sqrt(2.0)) << name;
    }
  }
}

TEST(HtmlPlayer, ShowsItsBackground) {
  OutputOptions options;
  EXPECT_TRUE(data_of(html_player(sample_animation(), options))["background"].is_null());
  options.transparent = true;
  EXPECT_EQ(data_of(html_player(sample_animation(), options))["background"], "none");
  options.background = Colour{0, 0, 1};
  EXPECT_EQ(data_of(html_player(sample_animation(), options))["background"], "#0000ff");
}

TEST(HtmlPlayer, LoadsNothingAndIsNotBrokenByText) {
  motion::Animation animation = sample_animation();
  animation.layers[0].id = "</script><script>alert(1)</script>{{data}}";
  OutputOptions options;
  options.title = "a < b";
  const std::string html = html_player(animation, options);
  EXPECT_EQ(data_of(html)["layers"][0]["id"], animation.layers[0].id);
  EXPECT_NE(html.find("<title>a &lt; b</title>"), std::string::npos);
  for (const char* network : {"src=", "href=", "https:", "url("}) {
    EXPECT_EQ(html.find(network), std::string::npos) << network;
  }
}

TEST(UsualTolerance, IsATenthOfAPixelWhereAFileHoldsCurves) {
  const ViewBox box{0, 0, 20, 10};
  OutputOptions options;
  options.size = {400, 300};  // 20 pixels a unit
  EXPECT_DOUBLE_EQ(usual_tolerance("a.svg", box, options), 0.005);
  EXPECT_DOUBLE_EQ(usual_tolerance("folder/a.json", box, options), 0.005);
  EXPECT_EQ(usual_tolerance("a.gif", box, options), 0);
  options.size.reset();
  options.pixels = 200;
  EXPECT_DOUBLE_EQ(usual_tolerance("a.html", box, options), 0.01);
}

}  // namespace
}  // namespace wavecurve::io
